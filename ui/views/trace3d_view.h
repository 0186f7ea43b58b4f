// The relief around the chosen ray in three dimensions: the ray, its stretches coloured by decision, the box of the
// current step's texel, the hit.
#pragma once

#include <memory>
#include <vector>

#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <QWidget>

#include "views/trace3d_scene.h"
#include "workspace/workspace.h"

class QLabel;
class QVTKOpenGLNativeWidget;

namespace reliefui {

class Trace3dView : public QWidget {
    Q_OBJECT
  public:
    explicit Trace3dView(Workspace* workspace, QWidget* parent = nullptr);
    ~Trace3dView() override;

    vtkRenderer* renderer() const { return renderer_; }

  public slots:
    void fit();                   // the whole patch, seen from the side of the ray
    void setFollowing(bool on);   // the camera keeps its eye on the end of the current step
    void setExaggeration(int n);  // of heights: 1, 2, 4

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void refresh();
    void showStep(int step);
    void applyStyle();
    void addStretches();
    void lookAtPatch();
    vtkSmartPointer<vtkActor> addLine(vtkSmartPointer<vtkPolyData> data, Rgba color, double width);
    void render();

    Workspace* workspace_;
    QVTKOpenGLNativeWidget* widget_;
    QLabel* note_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> renderer_;
    std::shared_ptr<const Snapshot> shown_;
    std::unique_ptr<TraceScene> scene_;
    std::vector<vtkSmartPointer<vtkActor>> stepActors_;  // of the current step, replaced by the next
    bool placed_ = false;                                // the camera has been put somewhere
    bool following_ = false;
    double exaggeration_ = 1;
};

}  // namespace reliefui
