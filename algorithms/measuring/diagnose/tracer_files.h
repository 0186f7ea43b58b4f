// What the files of another program's tracer tell of it.
#pragma once

#include <optional>
#include <string>

#include "measuring/compare/logged_ray.h"
#include "measuring/diagnose/diagnose.h"
#include "scenario/rays_view.h"

namespace relief {

// Returns the record of the files: with their hits, or with the answers with which their logs end. stepsFile: for
// messages. Throws InputError if steps do not fit the heights.
TracerRecord tracerRecord(RayFiles files, const HeightField& field, const std::string& stepsFile);

// Returns the scenario that shows a ray: in the view of its file, or, without one, from a camera that looks along it.
Scenario sceneOfRay(Scenario scenario, const HeightField& field, const RayBlock& rays,
                    const std::optional<RaysView>& view, std::size_t ray);

}  // namespace relief
