// The relief around the chosen ray in three dimensions: the ray, its parts coloured by decision, level or phase, the
// box of the current step's texel, the hit. A drag rotates, a right drag moves, the wheel zooms at the pointer, R
// resets the view; arrows, Shift+arrows, plus and minus do the same.
#pragma once

#include <memory>
#include <type_traits>

#include <vtkSmartPointer.h>

#include "panes/deferred_call.h"
#include "panes/figure_view.h"
#include "panes/trace/trace3d_picture.h"
#include "panes/trace/trace_state.h"

class QComboBox;
class QHBoxLayout;
class QKeyEvent;
class QLabel;
class QMouseEvent;
class QToolButton;
class QVTKOpenGLNativeWidget;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace reliefui {

class Trace3dView : public FigureView {
    Q_OBJECT
  public:
    explicit Trace3dView(Workspace* workspace, QWidget* parent = nullptr);
    ~Trace3dView() override;

    vtkRenderer* renderer() const;

  public slots:
    void fit();                         // the whole patch, seen from the side of the ray
    void setFollowing(bool on);         // keeps the end of the current step in the centre
    void setExaggeration(double n);     // factor of the heights
    void setColors(const QString& by);  // name from tracePaneColors()

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    std::shared_ptr<const Figure> figure() const override;
    void showSnapshot() override;
    bool outdated() const override;
    void releaseContents() override;

  private:
    void makeBar(QHBoxLayout* bar);
    void change(const TracePane& pane);
    template <class Value>
    void set(Value TracePane::*choice, const std::type_identity_t<Value>& value) {
        TracePane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();  // takes over the scenario's state of this pane
    void showStep(int step);
    bool handleMouse(QMouseEvent* event);
    bool handleKey(QKeyEvent* event);
    void render();
    void renderNow();
    void takeSize();
    void fitNote();
    Style deviceStyle() const;

    QVTKOpenGLNativeWidget* widget_;
    QLabel* note_;
    QToolButton* follow_ = nullptr;
    QComboBox* heights_ = nullptr;
    QComboBox* colors_ = nullptr;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    TracePicture picture_;
    QPointF pressed_;
    QPointF last_;
    DeferredCall deferredRender_{this, [this] { renderNow(); }};
    bool dragged_ = false;
    bool placed_ = false;  // the camera has been placed
    TracePane pane_;
};

}  // namespace reliefui
