#include "measuring/bench/filter_queries.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "base/parallel.h"
#include "rendering/tile_worker.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kGrain = static_cast<std::size_t>(kTileWidth) * kTileHeight;

}  // namespace

FilterQueries::FilterQueries(const Frame& frame, const FrameRequest& request, std::span<const glm::ivec2> pixels)
    : visible_(frame.visible(request)),
      picture_{frame.width, frame.height, frame.rays->polygon.data(), &frame.rays->rays, &frame.hits->hits} {
    for (const glm::ivec2& pixel : pixels) {
        const auto query = filterQuery(frame, request, visible_, pixel.x, pixel.y);
        if (!query) continue;
        if (size_ % kGrain == 0) blocks_.emplace_back().picture = &picture_;
        blocks_.back().push(*query);
        ++size_;
    }
}

FootprintCounts FilterQueries::filter(const TextureFilter& filter, std::vector<Color>& colors, Work& work) const {
    colors.resize(size_);
    FootprintCounts total;
    std::mutex mutex;
    parallelRanges(work, blocks_.size(), std::size_t{1}, [&](std::size_t first, std::size_t last) {
        FootprintCounts counts;
        for (std::size_t b = first; b < last; ++b) {
            filter.colors(blocks_[b], {colors.data() + b * kGrain, blocks_[b].size()}, counts, work);
        }
        const std::lock_guard lock(mutex);
        total.add(counts);
    });
    return total;
}

std::vector<std::vector<double>> FilterQueries::rates(std::span<const TextureFilter* const> filters, int rounds,
                                                      Work& work) const {
    std::vector<std::vector<double>> rates(filters.size());
    std::vector<Color> colors;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t f = 0; f < filters.size(); ++f) {
            const auto begun = Clock::now();
            filter(*filters[f], colors, work);
            const double seconds = std::max(std::chrono::duration<double>(Clock::now() - begun).count(), 1e-9);
            rates[f].push_back(static_cast<double>(size_) / seconds);
            work.progress().advance();
        }
    }
    return rates;
}

std::vector<glm::ivec2> sampledTiles(const Frame& frame, std::size_t most) {
    const auto& outcome = frame.hits->hits.outcome;
    const auto hits = static_cast<std::size_t>(std::count(outcome.begin(), outcome.end(), Outcome::Hit));
    const std::size_t every = std::max<std::size_t>(1, (hits + most - 1) / most);
    std::vector<glm::ivec2> pixels;
    std::size_t tile = 0;
    for (int y0 = 0; y0 < frame.height; y0 += kTileHeight) {
        for (int x0 = 0; x0 < frame.width; x0 += kTileWidth) {
            if (tile++ % every != 0) continue;
            for (int y = y0; y < std::min(y0 + kTileHeight, frame.height); ++y) {
                for (int x = x0; x < std::min(x0 + kTileWidth, frame.width); ++x) {
                    if (outcome[frame.index(x, y)] == Outcome::Hit && pixels.size() < most) pixels.emplace_back(x, y);
                }
            }
        }
    }
    return pixels;
}

}  // namespace relief
