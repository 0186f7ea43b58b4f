// Which points the edge pixels of a tile need: a few bits per cell, in plain loops that the compiler vectorizes for
// each instruction set.
#include "filtering/grid_stages.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/grid_plan.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {
namespace plan {

using namespace relief::grid;

// Sets the point's bit in each cell with eight neighbours for which the cell `off` entries before it has that bit in
// mask.
void takeBit(const TileCells& cells, const BitColumn& mask, std::ptrdiff_t off, std::size_t point, BitColumn& out) {
    const std::uint16_t* from = mask.data() - off;
    const auto bit = static_cast<std::uint16_t>(1U << point);
    for (std::size_t c = cells.inner(); c < cells.count() - cells.inner(); ++c)
        out[c] |= static_cast<std::uint16_t>(from[c] & bit);
}

// Sets the bits of the points that any edge pixel sums. Edge pixels are at least kTileHalo cells from the border. mask:
// scratch memory.
void markSummed(const PointLattice& lattice, const FilterBlock& block, std::span<const std::size_t> edges,
                const TileCells& cells, BitColumn& mask, BitColumn& needed) {
    mask.assign(cells.count(), 0);
    for (const std::size_t i : edges) mask[cells.at(block.x[i], block.y[i])] = 0xFFFF;
    for (const PointLattice::Term& term : lattice.terms) {
        const int off = term.dy * cells.width + term.dx;
        takeBit(cells, mask, off, static_cast<std::size_t>(term.point), needed);
    }
}

// Adds the four centres around each such point. mask: scratch memory.
void addCentres(const PointLattice& lattice, const TileCells& cells, BitColumn& mask, BitColumn& needed) {
    mask.assign(cells.count(), 0);
    for (std::size_t k = 1; k < lattice.places.size(); ++k) {
        // The cells whose squares have this centre as a corner: the centre's own, the one to its left, and the two
        // above.
        const std::uint16_t* own = needed.data() + lattice.squareOf(k, cells.width);
        const std::uint16_t* above = own - cells.width;
        for (std::size_t c = cells.inner(); c < cells.count() - cells.inner(); ++c) {
            const auto here = static_cast<std::ptrdiff_t>(c);
            const int any = own[here] | own[here - 1] | above[here] | above[here - 1];
            mask[c] |= static_cast<std::uint16_t>(any >> k & 1);
        }
    }
    for (std::size_t c = 0; c < cells.count(); ++c) needed[c] |= mask[c];
}

// Sets all bits or none of each cell: whether hits within the square between its centre and the centres to the right,
// below and diagonally below can be interpolated from these four. They can if none of the six lines between the four
// crosses an edge, that is if each line is smooth at both ends or straight at one end.
void joinSquares(const TileCells& cells, const BitColumn& around, BitColumn& joined) {
    const std::size_t row = cells.row();
    joined.assign(cells.count(), 0);
    std::uint16_t* out = joined.data();
    const auto join = [](unsigned p, unsigned q, unsigned line) {
        return (p & q & (unsigned{kSmooth} << line)) | (((p | q) & (unsigned{kStraight} << line)) / kStraight);
    };
    for (std::size_t c = 0; c < cells.count() - cells.inner(); ++c) {
        const unsigned p = around[c], q = around[c + 1], r = around[c + row], s = around[c + row + 1];
        const unsigned lines = (join(p, q, kAcross) & join(r, s, kAcross)) | (join(p, r, kDown) & join(q, s, kDown)) |
                               join(p, s, kFalling) | join(r, q, kRising);
        out[c] = lines == kAllLines ? 0xFFFF : 0;
    }
}

// Sets a bit for each point whose hit is interpolated from centres; for a centre, whose footprint is.
void markInterpolated(const PointLattice& lattice, const TileCells& cells, const BitColumn& around,
                      const BitColumn& joined, BitColumn& interpolated) {
    // A centre's footprint follows from its neighbours if the horizontal and the vertical line through it are straight,
    // or smooth with nearby hits.
    constexpr unsigned kCross = (1U << kAcross) | (1U << kDown);
    for (std::size_t c = 0; c < cells.count(); ++c) {
        const unsigned lines = (around[c] / kStraight) | ((around[c] & kNearAround) != 0 ? around[c] : 0U);
        interpolated[c] = (lines & kCross) == kCross ? 1 : 0;
    }
    for (std::size_t k = 1; k < lattice.places.size(); ++k)
        takeBit(cells, joined, lattice.squareOf(k, cells.width), k, interpolated);
}

}  // namespace plan

void planCells(const grid::PlanJob& job, grid::BitColumn& mask, grid::PointPlan& out) {
    const auto& [lattice, block, edges, cells, around] = job;
    for (auto* column : {&out.needed, &out.interpolated}) column->assign(cells.count() + kCellSlack, 0);
    plan::markSummed(lattice, block, edges, cells, mask, out.needed);
    plan::addCentres(lattice, cells, mask, out.needed);
    plan::joinSquares(cells, around, mask);
    plan::markInterpolated(lattice, cells, around, mask, out.interpolated);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(planCells);

void grid::planCells(const PlanJob& job, BitColumn& mask, PointPlan& out) {
    HWY_DYNAMIC_DISPATCH(planCells)(job, mask, out);
}

}  // namespace relief
#endif
