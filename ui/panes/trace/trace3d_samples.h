// What the 3-D trace draws of steps that looked at the surface at single points of the ray: the layers as sheets, the
// heights read as stems between ray and surface, a shift as an arrow. Keyed on primitives and decisions.
#pragma once

#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "panes/step_colors.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

// Where on the ray step `index` read its value.
double readAt(const std::vector<relief::Step>& steps, std::size_t index);

// The lambdas at which sheets are drawn: of the layers that the ray came to, evenly thinned out to at most
// `kMostSheets`; the chosen step's is not among them (it is drawn by itself).
inline constexpr std::size_t kMostSheets = 16;
std::vector<double> sheetLambdas(const std::vector<relief::Step>& steps, std::size_t chosen);

// Of the steps up to and around the chosen one; nothing where no step looked at a point.
std::vector<vtkSmartPointer<vtkActor>> sampleMarks(const TraceScene& scene, const std::vector<relief::Step>& steps,
                                                   std::size_t chosen, const StepPaint& paint, const Style& style,
                                                   double radius);

}  // namespace reliefui
