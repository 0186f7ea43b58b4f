// What the pixels of a frame ask of a texture filter, put together as the frame's tiles do it: to measure filters
// alone.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/filter_block.h"
#include "filtering/texture_filter.h"
#include "rendering/frame.h"

namespace relief {

class FilterQueries {
  public:
    // pixels: tile by tile; those without a hit are left out. The frame must outlive the queries.
    FilterQueries(const Frame& frame, const FrameRequest& request, std::span<const glm::ivec2> pixels);
    FilterQueries(const FilterQueries&) = delete;
    FilterQueries& operator=(const FilterQueries&) = delete;

    std::size_t size() const { return size_; }
    // The colours, in the order of the pixels. Throws Cancelled.
    FootprintCounts filter(const TextureFilter& filter, std::vector<Color>& colors, Work& work) const;
    // Pixels a second: of each filter as many as there are rounds, the filters in turn. Throws Cancelled.
    std::vector<std::vector<double>> rates(std::span<const TextureFilter* const> filters, int rounds, Work& work) const;

  private:
    VisiblePolygons visible_;  // the queries point into it
    PictureHits picture_;
    std::vector<FilterBlock> blocks_;
    std::size_t size_ = 0;
};

// Pixels of the frame with a hit, of whole tiles evenly spread, at most so many of them, for FilterQueries.
std::vector<glm::ivec2> sampledTiles(const Frame& frame, std::size_t most);

}  // namespace relief
