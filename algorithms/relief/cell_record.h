// The step record of a walk from cell to cell.
#pragma once

#include "relief/leaf.h"
#include "relief/step_log.h"

namespace relief {

// The largest stored height of the surface within a cell.
inline double cellMaximum(const HeightField& field, const CellGrid& grid, AxisCell cx, AxisCell cy) {
    return withHeights(field, [&](const auto& heights) {
        return field.surface() == Surface::Bilinear ? cellMaximum<Surface::Bilinear>(heights, grid, cx.index, cy.index)
                                                    : cellMaximum<Surface::Columns>(heights, grid, cx.index, cy.index);
    });
}

// Record of a decision about the cell (cx, cy) over the lambda interval [in, out], with the cell's largest height as
// subject. value: the column `value` of step files; after: lambda from which the walk continues.
inline Step cellRecord(const HeightField& field, const CellGrid& grid, AxisCell cx, AxisCell cy, Decision decision,
                       double in, double out, double value, double after) {
    Step step;
    step.phase = decision == Decision::Start ? Phase::Start : Phase::Search;
    step.decision = decision;
    step.i = cx.index + grid.x.firstName;
    step.j = cy.index + grid.y.firstName;
    step.periodX = cx.base / grid.x.cells;
    step.periodY = cy.base / grid.y.cells;
    step.lambdaIn = in;
    step.lambdaOut = out;
    step.value = value;
    step.lambdaAfter = after;
    step.subject = subject::Texel{0, step.i, step.j, cellMaximum(field, grid, cx, cy)};
    return step;
}

}  // namespace relief
