// FILE.json beside a file of rays, FILE.csv, that `relief export rays` has written: the view, its matrices, and the
// pixel of each ray.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rendering/view_rays.h"
#include "scenario/scenario.h"

namespace relief {

// Returns the name of the file beside the rays: with the ending .json.
std::string raysViewPath(const std::string& raysPath);

// Returns the file's content.
std::string raysViewText(const Scenario& scenario, const FrameRequest& request, const ViewRays& view,
                         const std::string& path);

// Returns true if raysViewText() made the file.
bool isRaysView(const std::string& path);

struct RaysView {
    Scenario scenario;
    std::vector<PixelChoice> pixels;  // of each ray
};
// Reads the file beside the rays; std::nullopt if there is none, or it was not written by this program. Throws
// InputError if it is damaged or belongs to another number of rays.
std::optional<RaysView> readRaysView(const std::string& raysPath, std::size_t rays);

}  // namespace relief
