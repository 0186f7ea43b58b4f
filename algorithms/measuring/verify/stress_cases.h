// Seeded families of height maps, rays and cameras that are difficult for tracers; relief stress runs through them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "measuring/random_rays.h"
#include "relief/camera.h"
#include "relief/height_field.h"
#include "rendering/scene.h"

namespace relief {

// A map, and how it is named on the command line.
struct StressMap {
    std::shared_ptr<const FloatImage> heights;
    std::string recipe;  // of relief/reliefs.h; empty: the map can only be read from a file
    std::uint64_t recipeSeed = 0;
};

struct StressMapFamily {
    std::string_view name;
    // Makes heights in [0, 1] of this size, at least 1 x 1.
    StressMap (*make)(int width, int height, Random& random);
};
// All zero, all one, a constant height, denormal heights, a spike, a pit, needles, checkers, plateaus, heights that
// differ by one rounding step, noise, ramps, extreme heights next to each other, and the recipes.
const std::vector<StressMapFamily>& stressMapFamilies();

struct StressSize {
    int width;
    int height;
};
// From 1 x 1 to 65536 x 2: including sides that do not fit into 16 bits, and maps of one row or column.
const std::vector<StressSize>& stressSizes();

struct StressRayFamily {
    std::string_view name;
    int rays;   // number of rays per case
    int every;  // used in every n-th case, since rays that take long are rarer
    ViewRay (*make)(const HeightField& field, Random& random);
};
// Finite rays, including grazing ones up to the domain's limit (kMaxRun) and beyond.
const std::vector<StressRayFamily>& stressRayFamilies();

struct StressCameraFamily {
    std::string_view name;
    // scene: the scene that the camera looks at, with the polygons of makeScene().
    Camera (*make)(SceneKind scene, Random& random);
    bool refused = false;  // these cameras see no picture and must be refused
};
// Ordinary cameras; in a polygon's plane, exactly and off by one rounding step; grazing; near; far; straight above and
// below; with the narrowest and widest fields of view; at the position of their own target, which must be refused.
const std::vector<StressCameraFamily>& stressCameraFamilies();

}  // namespace relief
