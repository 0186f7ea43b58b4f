// What any-hit queries that jump share: cell by cell where something may be in the way, and by what `Jump` says where
// nothing can be. Jump: free(ray, course, cx, cy, mu, out) tells up to which mu the segment is free from here on, given
// that it is in that cell at mu and leaves it at out; not beyond mu: the cell must be looked at.
#pragma once

#include "relief/any_leaf.h"
#include "relief/cell_record.h"

namespace relief {

template <class Sink, class Jump>
Sight lookByJumps(const HeightField& field, const CellGrid& grid, const AnyRay& ray, double highest, double bound,
                  Sink& sink, const Jump& free) {
    if (!ray.finite()) return Sight::Clear;
    const GridRay course(grid, ray.course());
    const double end = endBelow(ray, highest);
    AxisCell cx = course.x.startCell(grid.x);
    AxisCell cy = course.y.startCell(grid.y);
    const auto note = [&](Decision decision, double in, double out) {
        return [&, decision, in, out] {
            const double lambdaOut = 1 - ray.heightAt(out);
            return cellRecord(field, grid, cx, cy, decision, 1 - ray.heightAt(in), lambdaOut, 0, lambdaOut);
        };
    };
    sink.step(note(Decision::Start, 0, 0));
    if (!(end > 0) || runsOutside(grid, course)) {
        sink.step(note(Decision::Miss, 0, 0));
        return Sight::Clear;
    }
    double mu = 0;
    // Two records besides: the start and the end.
    for (double left = bound - 2; left > 0; --left) {
        cx = course.x.cellAt(grid.x, mu);
        cy = course.y.cellAt(grid.y, mu);
        const Stay stay = cellStay(grid, course, cx, cy);
        const double leave = std::min(course.x.leave(grid.x, cx.index, cx.index + 1, cx.base),
                                      course.y.leave(grid.y, cy.index, cy.index + 1, cy.base));
        const double out = std::clamp(stay.out, mu, end);
        const double jump = free(ray, course, cx, cy, mu, out);
        sink.read(1);
        if (jump > mu) {
            sink.step(note(Decision::Advance, mu, std::min(jump, end)));
            mu = jump;
        } else {
            sink.read(field.surface() == Surface::Bilinear ? 4 : 1);
            if (cellBlocks(field, grid, ray, course, cx, cy, end)) {
                sink.step(note(Decision::Hit, mu, out));
                return Sight::Blocked;
            }
            sink.step(note(Decision::Test, mu, out));
            mu = std::max(leave, mu);
        }
        const bool leaves = grid.bounded && (course.x.leave(grid.x, 0, grid.x.cells, 0) <= mu ||
                                             course.y.leave(grid.y, 0, grid.y.cells, 0) <= mu);
        if (mu >= end || leaves) {
            sink.step(note(Decision::Miss, std::min(mu, end), std::min(mu, end)));
            return Sight::Clear;
        }
    }
    sink.step(note(Decision::Limit, mu, mu));
    return Sight::Limit;
}

}  // namespace relief
