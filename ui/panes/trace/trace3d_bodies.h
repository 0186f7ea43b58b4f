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

std::vector<vtkSmartPointer<vtkActor>> bodyMarks(const TraceScene& scene, const Snapshot& snapshot, std::size_t chosen,
                                                 const Style& style, double radius);

// Position of a label: above the body.
Place aboveBody(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body);

}  // namespace reliefui
