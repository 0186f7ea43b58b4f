// What the 3-D trace draws over the relief: the ray, its stretches in the colours of the steps, the box of a step, the
// hit, and words.
#pragma once

#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "painting/step_body.h"
#include "painting/style.h"
#include "panes/step_colors.h"
#include "panes/trace/trace3d_scene.h"

class vtkCamera;
class vtkTextActor;

namespace reliefui {

class TraceMarks {
  public:
    TraceMarks(const TraceScene& scene, const relief::HeightField& field, const Style& style,
               const StepPaint& paint = {});

    vtkSmartPointer<vtkActor> line(vtkSmartPointer<vtkPolyData> data, Role role, double width) const;
    vtkSmartPointer<vtkActor> ray() const;  // a tube from a little above the slab to its end
    // Sleeves around the ray, of the steps up to the chosen one or of those after it (faint); of very long logs only
    // the steps around the chosen one.
    vtkSmartPointer<vtkActor> stretches(const std::vector<relief::Step>& steps, std::size_t chosen, bool later) const;
    vtkSmartPointer<vtkActor> stretch(const relief::Step& step) const;  // the chosen one, thicker
    // Between the ray and the relief under it, and where its shadow lies.
    vtkSmartPointer<vtkActor> curtain() const;
    vtkSmartPointer<vtkActor> shadow() const;
    // What the step looked at: from the foot of the block to the value read, over the step's texel; of a walk through a
    // distance map the voxel, or what it tested.
    struct Prism {
        Box sides;  // texels; those beyond the patch are cut off
        double low = 0;
        double high = 0;  // Z
        Rgba color;
    };
    Prism prism(const relief::Step& step, const relief::MaxPyramidMap& maxima) const;
    vtkSmartPointer<vtkActor> box(const Prism& prism) const;
    vtkSmartPointer<vtkActor> boxEdges(const Prism& prism) const;
    // A ring that faces the eye, before what it lies on.
    std::vector<vtkSmartPointer<vtkActor>> hitRing(vtkCamera* camera, double lambda) const;
    vtkSmartPointer<vtkTextActor> words(const Place& at, const std::string& text, Role role, double size) const;
    double radius() const { return radius_; }
    // Where words about the step stand.
    Place labelPlace(const relief::Step& step) const;

  private:
    const TraceScene& scene_;
    const relief::HeightField& field_;
    const Style& style_;
    StepPaint paint_;
    double radius_;  // of the ray
};

}  // namespace reliefui
