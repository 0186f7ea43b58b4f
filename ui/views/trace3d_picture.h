// The picture of the 3-D trace in a renderer, for the pane and for files: the relief around the chosen ray, the ray,
// its stretches coloured by decision, what the current step knew. It belongs to no window.
#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>
#include <QString>

#include "drawings/style.h"
#include "views/trace3d_scene.h"
#include "views/turntable.h"

class vtkProp;
class vtkRenderer;
class vtkTextActor;

namespace reliefui {

class TracePicture {
  public:
    TracePicture();
    ~TracePicture();
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    vtkRenderer* renderer() const;
    // Null where there is no ray; words say why.
    const TraceScene* scene() const { return scene_.get(); }
    const std::shared_ptr<const Snapshot>& shown() const { return shown_; }

    // Replaces everything. style: in the pixels of the window; exaggeration: of heights.
    void show(std::shared_ptr<const Snapshot> snapshot, const Style& style, double exaggeration);
    // The next show() draws anew, whatever it is of.
    void forget();
    void showStep(int step);
    // The camera: the whole patch seen from the side of the ray; the same without turning; the end of the step in the
    // middle. aspect: width over height of the view.
    void fit(double aspect);
    void showAll(double aspect);
    void follow(int step);
    // Puts the camera, and what depends on it, into the renderer: before each rendering.
    void place();

    Turntable camera;

  private:
    void clear(const Style& style);
    void addRelief();
    void addRay();
    void addStep(const relief::Step& step, std::size_t number);
    void addWords(const QString& words);
    void placeTopLabel();

    vtkSmartPointer<vtkRenderer> renderer_;
    std::shared_ptr<const Snapshot> shown_;
    std::unique_ptr<TraceScene> scene_;
    Style style_;
    std::vector<vtkSmartPointer<vtkProp>> stepProps_;  // of the current step, replaced by the next
    vtkSmartPointer<vtkTextActor> topLabel_;           // at the left corner of the slab's top
};

}  // namespace reliefui
