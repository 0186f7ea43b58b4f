// The queries of a texture filter for the pixels of a frame, grouped as the frame's tiles group them, to measure
// filters alone.
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
    // pixels: sorted by tiles; those without a hit are skipped. Keeps references to frame and request, which must
    // outlive the queries.
    FilterQueries(const Frame& frame, const FrameRequest& request, std::span<const glm::ivec2> pixels);
    FilterQueries(const FilterQueries&) = delete;
    FilterQueries& operator=(const FilterQueries&) = delete;

    std::size_t size() const { return size_; }
    // Sets the colours, in the order of the pixels. Throws Cancelled.
    FootprintCounts filter(const TextureFilter& filter, std::vector<Color>& colors, Work& work) const;
    // Returns pixels per second, by filter and round; each round runs all filters in turn. Throws Cancelled.
    std::vector<std::vector<double>> rates(std::span<const TextureFilter* const> filters, int rounds, Work& work) const;

  private:
    VisiblePolygons visible_;  // the queries point into it
    PictureHits picture_;
    std::vector<FilterBlock> blocks_;
    std::size_t size_ = 0;
};

// Returns pixels of the frame with a hit, for FilterQueries: whole tiles distributed uniformly over the picture, at
// most `most` pixels.
std::vector<glm::ivec2> sampledTiles(const Frame& frame, std::size_t most);

}  // namespace relief
