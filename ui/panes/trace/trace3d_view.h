// The relief around the chosen ray in three dimensions: the ray, its stretches coloured by decision, level or phase,
// the box of the current step's texel, the hit. Drag turns, right drag moves, wheel zooms at the pointer, R fits;
// arrows, Shift+arrows, plus and minus do the same.
#pragma once

#include <memory>
#include <type_traits>

#include <vtkSmartPointer.h>

#include "panes/figure_view.h"
#include "panes/soon.h"
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
    void setFollowing(bool on);         // the camera keeps its eye on the end of the current step
    void setExaggeration(double n);     // of heights
    void setColors(const QString& by);  // of the steps, as of tracePaneColors()

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    std::shared_ptr<const Figure> figure() const override;
    void showSnapshot() override;
    bool outdated() const override;
    void letGo() override;

  private:
    void makeBar(QHBoxLayout* bar);
    void change(const TracePane& pane);
    template <class Value>
    void set(Value TracePane::*choice, const std::type_identity_t<Value>& value) {
        TracePane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();  // what the scenario says
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
    Soon renderSoon_{this, [this] { renderNow(); }};
    bool dragged_ = false;
    bool placed_ = false;  // the camera has been put somewhere
    TracePane pane_;
};

}  // namespace reliefui
