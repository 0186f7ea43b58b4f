// Every filter behind one face, made ready for one picture (and, where it asks what is hidden, one height field).
#pragma once

#include <memory>
#include <span>

#include "filtering/elliptical_visible.h"
#include "filtering/filter_block.h"
#include "filtering/filter_choice.h"
#include "filtering/footprint_log.h"

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
    std::shared_ptr<const ColorLevels> levels;  // of the picture; null: built here, if the filter needs it
    HeightField field;
    bool skip = true;  // tests that cannot matter are skipped
};

// `supersample` reads each of its samples bilinearly. Throws InputError (names, options), Cancelled.
std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work);
// Whether the filter reads the mean pyramid.
bool needsLevels(const FilterChoice& choice);

}  // namespace relief
