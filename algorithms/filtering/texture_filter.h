// A filter prepared for one picture and, if it needs visibility, one height field.
#pragma once

#include <memory>
#include <span>

#include "filtering/color_levels.h"
#include "filtering/filter_block.h"
#include "filtering/filter_description.h"
#include "filtering/footprint_log.h"
#include "relief/map_cache.h"

namespace relief {

// Immutable; may be shared by threads.
class TextureFilter {
  public:
    virtual ~TextureFilter() = default;
    TextureFilter() = default;
    TextureFilter(const TextureFilter&) = delete;
    TextureFilter& operator=(const TextureFilter&) = delete;

    virtual const FilterDescription& description() const = 0;
    // Filters one pixel. log: may be null. Throws Cancelled.
    virtual Color color(const FilterQuery& query, FootprintCounts& counts, Work& work,
                        FootprintLog* log = nullptr) const = 0;
    // Filters a block with the same bits. colors: as many as queries.
    virtual void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work& work) const;
    // Returns true if the filter traces texels back, so that it can report which are hidden.
    virtual bool tracesBack() const { return false; }
    // Returns true if the filter reads the hits of neighbouring pixels: FilterBlock::picture then saves it tracing
    // their rays.
    virtual bool readsNeighbours() const { return false; }
};

// The inputs of a filter.
struct FilterTools {
    std::shared_ptr<const ColorImage> picture;  // not null
    std::shared_ptr<const ColorLevels> levels;  // of the picture; null: built by makeFilter() if needed
    HeightField field;
    bool skip = true;  // skip tests that cannot change the result

    // Texels of the picture per texel of the height map.
    glm::dvec2 pictureScale() const {
        return {static_cast<double>(picture->width()) / field.width(),
                static_cast<double>(picture->height()) / field.height()};
    }
};

}  // namespace relief
