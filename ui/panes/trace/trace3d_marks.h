// Objects that the 3-D trace draws over the relief: the ray, its parts coloured by step, the box of a step, the hit,
// and labels.
#pragma once

#include <array>
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

// Opacities, and radii relative to that of the ray.
inline constexpr double kLaterOpacity = 0.45;  // steps after the chosen one
inline constexpr double kCurtainOpacity = 0.16;
inline constexpr double kPrismOpacity = 0.26;
inline constexpr double kEdge = 0.7;     // edges of a box
inline constexpr double kHitDisk = 4.6;  // the white disk of a hit, and its ring
inline constexpr double kHitInner = 2.1;
inline constexpr double kHitOuter = 3.6;

class TraceMarks {
  public:
    TraceMarks(const TraceScene& scene, const relief::HeightField& field, const Style& style,
               const StepPaint& paint = {});

    vtkSmartPointer<vtkActor> line(vtkSmartPointer<vtkPolyData> data, Role role, double width) const;
    vtkSmartPointer<vtkActor> ray() const;  // a tube from slightly above the slab to the ray's end
    struct Sleeve {
        Place from, to;
        double radius;
        Rgba color;
    };
    // Sleeves around the ray for the steps up to the chosen one, or (later) for those after it, faintly; limited to the
    // steps around the chosen one in very long logs.
    std::vector<Sleeve> sleeves(const std::vector<relief::Step>& steps, std::size_t chosen, bool later) const;
    vtkSmartPointer<vtkActor> stretches(const std::vector<relief::Step>& steps, std::size_t chosen, bool later) const;
    Sleeve sleeve(const relief::Step& step) const;  // of the chosen step, thicker
    vtkSmartPointer<vtkActor> stretch(const relief::Step& step) const;
    // curtain(): the vertical surface between the ray and the relief below. shadow(): the ray's vertical projection
    // onto the relief.
    vtkSmartPointer<vtkActor> curtain() const;
    vtkSmartPointer<vtkActor> shadow() const;
    // What the step examined: over the step's texel, from the bottom of the block to the value read; for a walk through
    // a distance map the voxel or the tested cell.
    struct Prism {
        Box sides;  // in texels, clipped to the patch
        double low = 0;
        double high = 0;  // in Z
        Rgba color;
    };
    Prism prism(const relief::Step& step, const relief::MaxPyramidMap& maxima) const;
    std::vector<std::array<Place, 4>> faces(const Prism& prism) const;
    std::vector<std::array<Place, 2>> edges(const Prism& prism) const;
    vtkSmartPointer<vtkActor> box(const Prism& prism) const;
    vtkSmartPointer<vtkActor> boxEdges(const Prism& prism) const;
    // A ring that faces the viewer and is drawn in front of the surface it lies on.
    std::vector<vtkSmartPointer<vtkActor>> hitRing(vtkCamera* camera, double lambda) const;
    vtkSmartPointer<vtkTextActor> words(const Place& at, const std::string& text, Role role, double size) const;
    double radius() const { return radius_; }
    // Position of labels of the step.
    Place labelPlace(const relief::Step& step) const;

  private:
    const TraceScene& scene_;
    const relief::HeightField& field_;
    const Style& style_;
    StepPaint paint_;
    double radius_;  // of the ray
};

}  // namespace reliefui
