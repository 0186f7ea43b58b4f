// The levels of the mean pyramid as height maps: with a base level k > 0, level k is traced. [MIP18] fig. 2.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"
#include "relief/height_field.h"
#include "relief/image.h"
#include "relief/map_cache.h"

namespace relief {

struct MeanLevelsMap {
    static constexpr RayClass kRays = RayClass::AnyRays;
    std::vector<std::shared_ptr<const FloatImage>> levels;  // [0]: the heights themselves

    std::size_t bytes() const;
};

// Takes the map from the cache, or builds it in parallel; O(texels).
std::shared_ptr<const MeanLevelsMap> meanLevelsMap(const HeightField& field, MapCache& cache, Work& work);

// A height field at a base level. Its texels are larger: perS and perT of them correspond to one texel of the whole
// field on each axis (W_k / W; 1 at level 0). Lambda is the same in both.
struct BaseField {
    HeightField field;
    int level = 0;
    double perS = 1;
    double perT = 1;
};

// The option of methods that trace a base level: a number, or `auto`, which the renderer replaces, since it depends on
// the view (rendering/base_level.h).
inline constexpr std::string_view kBaseOption = "base";
inline constexpr std::string_view kBaseAuto = "auto";
// The number of a checked option. Throws InputError("--set", ...) for `auto`.
int baseLevelNumber(const std::string& text);

// The field at a base level, at most the last one. Level 0 builds nothing.
BaseField baseField(const HeightField& field, int level, MapCache& cache, Work& work);

}  // namespace relief
