// The history of the chosen pixel as a sheet of equations, and its figure.
#pragma once

#include "panes/figure.h"
#include "panes/formula/formula_data.h"
#include "rendering/pixel_history.h"

namespace reliefui {

std::vector<FormulaGroup> whyGroups(const relief::PixelHistory& history, const relief::FrameRequest& request,
                                    relief::Language language);
// Computes the history first.
std::shared_ptr<const Figure> whyFigure(std::shared_ptr<const Snapshot> snapshot);
// The same with a known history.
std::shared_ptr<const Figure> whyFigure(std::shared_ptr<const Snapshot> snapshot,
                                        std::shared_ptr<const relief::PixelHistory> history);

}  // namespace reliefui
