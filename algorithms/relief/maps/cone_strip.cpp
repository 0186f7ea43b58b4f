#include "relief/maps/cone_strip.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace relief {

namespace {

constexpr float kEmpty = -1;  // below every height

// Index of a cell in the picture, or -1 if there is none.
int placeOf(const GridAxis& axis, int k) {
    return axis.wraps || (k >= 0 && k < axis.cells) ? ConeScene::place(axis, k) : -1;
}

// The near cells in the directions of a sector, grouped by their gap.
NearRings ringsOf(const ConeScene& scene, int sector, std::ptrdiff_t stride) {
    std::map<std::int64_t, std::vector<std::ptrdiff_t>> byGap;
    for (int y = -kNearCells; y <= kNearCells; ++y) {
        for (int x = -kNearCells; x <= kNearCells; ++x) {
            const std::int64_t gap2 = squaredGap({0, 1, 0, 1}, {x, x + 1, y, y + 1});
            // Gap 0: the 3 x 3 cells, which are not above the apex by definition.
            if (gap2 == 0 || static_cast<double>(gap2) >= scene.squaredReach) continue;
            if (scene.sectors.meets(sector, x - 1, x + 1, y - 1, y + 1)) byGap[gap2].push_back(y * stride + x);
        }
    }
    NearRings rings;
    for (const auto& [gap2, offsets] : byGap) {
        rings.offsets.insert(rings.offsets.end(), offsets.begin(), offsets.end());
        rings.ends.push_back(rings.offsets.size());
        rings.inverseGaps.push_back(static_cast<float>(1 / std::sqrt(static_cast<double>(gap2))));
    }
    return rings;
}

}  // namespace

ConeStrip::ConeStrip(const ConeScene& scene) : scene_(scene) {
    const int vectors = (scene.width + kNearPad - 1) / kNearPad;
    width_ = static_cast<std::size_t>(vectors * kNearPad);
    stride_ = width_ + 2 * static_cast<std::size_t>(kNearCells);
    for (std::size_t n = 0; n < stride_; ++n) {
        columns_.push_back(placeOf(scene.grid.x, static_cast<int>(n) - kNearCells));
    }
    cells_.resize(stride_ * static_cast<std::size_t>(kStripRows + 2 * kNearCells));
    apexes_.resize(width_ * kStripRows);
    for (int sector = 0; sector < scene.sectors.count(); ++sector) {
        rings_.push_back(ringsOf(scene, sector, static_cast<std::ptrdiff_t>(stride_)));
        slopes_.emplace_back(width_ * kStripRows);
    }
}

void ConeStrip::load(int y0) {
    float* to = cells_.data();
    for (int n = -kNearCells; n < kStripRows + kNearCells; ++n, to += stride_) {
        const int y = placeOf(scene_.grid.y, y0 + n);
        if (y < 0) {
            std::fill(to, to + stride_, kEmpty);
            continue;
        }
        const auto row = scene_.cells.row(y);
        for (std::size_t x = 0; x < stride_; ++x) {
            to[x] = columns_[x] < 0 ? kEmpty : row[static_cast<std::size_t>(columns_[x])];
        }
    }
    const int rows = std::min(kStripRows, scene_.height - y0);
    for (int row = 0; row < rows; ++row) {
        const float* cells = cells_.data() + static_cast<std::size_t>(row + kNearCells) * stride_ + kNearCells;
        apexesAbove(cells, static_cast<std::ptrdiff_t>(stride_), scene_.width, apexes_.data() + at(0, row));
        for (std::size_t sector = 0; sector < rings_.size(); ++sector) {
            steepenByRings(rings_[sector], cells, apexes_.data() + at(0, row), scene_.width,
                           slopes_[sector].data() + at(0, row));
        }
    }
}

}  // namespace relief
