#include "relief/maps/mean_levels_map.h"

#include <algorithm>

#include "images/pyramid.h"
#include "relief/maps/map_memory.h"

namespace relief {

std::size_t MeanLevelsMap::bytes() const {
    std::size_t total = 0;
    for (std::size_t l = 1; l < levels.size(); ++l) total += levels[l]->pixels().size() * sizeof(float);
    return total;
}

std::shared_ptr<const MeanLevelsMap> meanLevelsMap(const HeightField& field, MapCache& cache, Work& work) {
    // Per texel: a pyramid of a copy, its sums, and its levels.
    constexpr std::uint64_t kBytes = 9;
    return cache.get<MeanLevelsMap>({"mean-levels", field.sharedHeights()}, bytesForTexels(field, kBytes), work,
                                    [&](Work& w) {
                                        const Pyramid pyramid(PyramidKind::Mean, field.heights(), w);
                                        MeanLevelsMap map;
                                        map.levels.push_back(field.sharedHeights());
                                        for (int l = 1; l < pyramid.levels(); ++l) {
                                            map.levels.push_back(std::make_shared<const FloatImage>(pyramid.level(l)));
                                        }
                                        return map;
                                    });
}

int baseLevelNumber(const std::string& text) {
    if (text == kBaseAuto) throw InputError("--set", Message(MessageId::BaseAutoNoView));
    return static_cast<int>(parseNumber(text, std::string(kBaseOption)));
}

BaseField baseField(const HeightField& field, int level, MapCache& cache, Work& work) {
    const int base = std::min(level, Pyramid::levelCount(field.width(), field.height()) - 1);
    if (base <= 0) return {field, 0, 1, 1};
    const auto map = meanLevelsMap(field, cache, work);
    const auto& heights = map->levels[static_cast<std::size_t>(base)];
    return {HeightField(heights, field.surface(), field.address(), field.reliefDepth()), base,
            static_cast<double>(heights->width()) / field.width(),
            static_cast<double>(heights->height()) / field.height()};
}

}  // namespace relief
