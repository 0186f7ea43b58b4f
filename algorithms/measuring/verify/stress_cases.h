// Height maps and rays that break tracers: families with a name each, seeded. What relief stress runs through.
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

// A map and how the command line names it.
struct StressMap {
    std::shared_ptr<const FloatImage> heights;
    std::string recipe;  // of relief/reliefs.h; empty: only a file can hold it
    std::uint64_t recipeSeed = 0;
};

struct StressMapFamily {
    std::string_view name;
    // Heights in [0, 1] of that size, at least 1 x 1.
    StressMap (*make)(int width, int height, Random& random);
};
// All zero, all one, one level, denormal heights, a spike, a pit, needles, checkers, plateaus, heights one rounding
// apart, noise, ramps, extremes side by side, and the recipes.
const std::vector<StressMapFamily>& stressMapFamilies();

struct StressSize {
    int width;
    int height;
};
// From 1 x 1 to 65536 x 2: sides that fit no 16 bits, and maps of one row or column.
const std::vector<StressSize>& stressSizes();

struct StressRayFamily {
    std::string_view name;
    int rays;   // of a case
    int every;  // in each n-th case: rays that take long are rarer
    ViewRay (*make)(const HeightField& field, Random& random);
};
// Finite rays; flat ones up to the domain's limit (kMaxRun) and beyond.
const std::vector<StressRayFamily>& stressRayFamilies();

struct StressCameraFamily {
    std::string_view name;
    // scene: what it looks at; the polygons are makeScene's.
    Camera (*make)(SceneKind scene, Random& random);
    bool refused = false;  // no picture can be seen by these
};
// Ordinary ones; in a polygon's plane, to the last bit and a rounding beside it; grazing; near; far; straight above and
// below; with the narrowest and widest fields of view; in one place with what they look at, which must be refused.
const std::vector<StressCameraFamily>& stressCameraFamilies();

}  // namespace relief
