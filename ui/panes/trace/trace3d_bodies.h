// What steps of map methods knew to be empty, in the 3-D trace: the current step's sphere or cone translucent, earlier
// ones as faint outlines. Distances are in the slab's metric: where heights are exaggerated, spheres are stretched.
#pragma once

#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "painting/step_body.h"
#include "painting/style.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

std::vector<vtkSmartPointer<vtkActor>> bodyMarks(const TraceScene& scene, const Snapshot& snapshot, std::size_t chosen,
                                                 const Style& style, double radius);

// Where words about it stand: above it.
Place aboveBody(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body);

}  // namespace reliefui
