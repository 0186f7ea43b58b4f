// Objects that the 3-D trace draws for steps that sample the surface at points of the ray: layers as sheets, heights as
// stems between ray and surface, a shift as an arrow. Chosen by the steps' subjects and decisions.
#pragma once

#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "panes/step_colors.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

// Lambda at which step `index` read its value.
double readAt(const std::vector<relief::Step>& steps, std::size_t index);

// Lambdas of the sheets: those of the layers that the ray reached, uniformly thinned to at most `kMostSheets`, without
// the chosen step's, which is drawn separately.
inline constexpr std::size_t kMostSheets = 16;
std::vector<double> sheetLambdas(const std::vector<relief::Step>& steps, std::size_t chosen);

// Objects for the steps up to and around the chosen one; empty if no step samples a point.
std::vector<vtkSmartPointer<vtkActor>> sampleMarks(const TraceScene& scene, const std::vector<relief::Step>& steps,
                                                   std::size_t chosen, const StepPaint& paint, const Style& style,
                                                   double radius);

}  // namespace reliefui
