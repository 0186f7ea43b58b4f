#include "filtering/texture_filter.h"

#include <cassert>

namespace relief {

void TextureFilter::colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts,
                           Work& work) const {
    assert(colors.size() == block.size());
    for (std::size_t i = 0; i < block.size() && !work.stopped(); ++i) colors[i] = color(block[i], counts, work);
}

}  // namespace relief
