// The space that steps of map methods treated as empty, in the 3-D trace: the current step's sphere or cone is
// translucent, earlier ones are faint outlines. Distances are in the slab's metric: spheres are stretched if heights
// are exaggerated.
#pragma once

#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "painting/step_body.h"
#include "painting/style.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

// Opacities, and radii relative to that of the ray.
inline constexpr double kBodyOpacity = 0.3;
inline constexpr double kOutline = 0.6;  // of the current step's body
inline constexpr double kEarlierOutline = 0.22;
inline constexpr double kEarlierOpacity = 0.45;
// The first of the earlier steps whose bodies are outlined.
inline std::size_t firstOutline(std::size_t chosen) {
    constexpr std::size_t kMostOutlines = 40;
    return chosen > kMostOutlines ? chosen - kMostOutlines : 0;
}

// A step's sphere or cone in the scene.
class BodyShape {
  public:
    BodyShape(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body);

    const StepBody& body() const { return body_; }
    Place center() const { return scene_.onRay(body_.lambda); }
    double stretch() const { return stretch_; }          // of heights: Z per texel of the slab's metric
    Place onSphere(double x, double y, double z) const;  // in a direction of length 1 in the slab's metric
    // Point of the cone. reach: distance from its axis (away() of the body); azimuth: in radians.
    Place onCone(double reach, double azimuth) const;
    double reach() const;  // up to which the cone is drawn
    Place onRim(int n) const;
    // Sphere: a horizontal circle and one in the plane of the ray. Cone: its rim and two sides.
    std::vector<std::vector<Place>> outline() const;

  private:
    const TraceScene& scene_;
    StepBody body_;
    double stretch_;
    relief::ViewRay ray_;
};

std::vector<vtkSmartPointer<vtkActor>> bodyMarks(const TraceScene& scene, const Snapshot& snapshot, std::size_t chosen,
                                                 const Style& style, double radius);

// Position of a label: above the body.
Place aboveBody(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body);

}  // namespace reliefui
