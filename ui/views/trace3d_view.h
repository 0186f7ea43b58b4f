// The relief around the chosen ray in three dimensions: the ray, its stretches coloured by decision, the box of the
// current step's texel, the hit. Drag turns, right drag moves, wheel zooms at the pointer, R fits.
#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>
#include <QWidget>

#include "views/soon.h"
#include "views/trace3d_scene.h"
#include "views/turntable.h"
#include "workspace/workspace.h"

class QHBoxLayout;
class QComboBox;
class QLabel;
class QMouseEvent;
class QToolButton;
class QVTKOpenGLNativeWidget;
class vtkGenericOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextActor;

namespace reliefui {

class Trace3dView : public QWidget {
    Q_OBJECT
  public:
    explicit Trace3dView(Workspace* workspace, QWidget* parent = nullptr);
    ~Trace3dView() override;

    vtkRenderer* renderer() const;

  public slots:
    void fit();                      // the whole patch, seen from the side of the ray
    void setFollowing(bool on);      // the camera keeps its eye on the end of the current step
    void setExaggeration(double n);  // of heights

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeBar(QHBoxLayout* bar);
    void change(const relief::TracePane& pane);
    void adopt();  // what the scenario says
    void refresh();
    void showStep(int step);
    void addRelief();
    void addRay();
    void addStep(const relief::Step& step, std::size_t number);
    void addWords(const QString& words);
    void showAll();  // without turning
    void placeTopLabel();
    bool handleMouse(QMouseEvent* event);
    void render();
    void renderNow();

    Workspace* workspace_;
    QVTKOpenGLNativeWidget* widget_;
    QLabel* note_;
    QToolButton* follow_ = nullptr;
    QComboBox* heights_ = nullptr;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> renderer_;
    std::shared_ptr<const Snapshot> shown_;
    std::unique_ptr<TraceScene> scene_;
    std::vector<vtkSmartPointer<vtkProp>> stepProps_;  // of the current step, replaced by the next
    vtkSmartPointer<vtkTextActor> topLabel_;           // at the left corner of the slab's top
    Turntable camera_;
    QPointF last_;
    Soon renderSoon_{this, [this] { renderNow(); }};
    bool placed_ = false;  // the camera has been put somewhere
    relief::TracePane pane_;
};

}  // namespace reliefui
