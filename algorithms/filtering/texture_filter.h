// A filter made ready for one picture (and, where it asks what is hidden, one height field).
#pragma once

#include <memory>
#include <span>

#include "filtering/color_levels.h"
#include "filtering/filter_block.h"
#include "filtering/filter_description.h"
#include "filtering/footprint_log.h"
#include "relief/map_cache.h"

namespace relief {

// Immutable, shared by threads.
class TextureFilter {
  public:
    virtual ~TextureFilter() = default;
    TextureFilter() = default;
    TextureFilter(const TextureFilter&) = delete;
    TextureFilter& operator=(const TextureFilter&) = delete;

    virtual const FilterDescription& description() const = 0;
    // log: may be null. Throws Cancelled.
    virtual Color color(const FilterQuery& query, FootprintCounts& counts, Work& work,
                        FootprintLog* log = nullptr) const = 0;
    // The same bits for a whole block; colors: of its length.
    virtual void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work& work) const;
    // Whether it traces texels back, so that it can tell which are hidden.
    virtual bool tracesBack() const { return false; }
    // Whether it asks what neighbours of a block's pixels met: FilterBlock::picture then saves it their rays.
    virtual bool asksNeighbours() const { return false; }
};

// What filters are made of.
struct FilterTools {
    std::shared_ptr<const ColorImage> picture;  // not null
    std::shared_ptr<const ColorLevels> levels;  // of the picture; null: built by makeFilter(), if the filter needs it
    HeightField field;
    bool skip = true;  // tests that cannot matter are skipped

    // From texels of the height map to texels of the picture.
    glm::dvec2 pictureScale() const {
        return {static_cast<double>(picture->width()) / field.width(),
                static_cast<double>(picture->height()) / field.height()};
    }
};

}  // namespace relief
