// The caption below a figure: the pictures, the method, the view, the pixel and the step.
#pragma once

#include <memory>
#include <optional>

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// methods, filters: those of a comparison; empty: the scenario's own. step: zero-based step of the ray drawn;
// std::nullopt: the figure shows no ray. Names the pixel if one is chosen.
FigureCaption figureCaption(std::shared_ptr<const Snapshot> snapshot, std::optional<int> step = {},
                            const std::string& methods = {}, const std::string& filters = {});

// The caption for a figure that is rendered again: it states that counts and errors are those of the figure's own
// picture.
FigureCaption redrawnCaption(FigureCaption caption);
// Throws InputError if no pixel is chosen, or one without relief.
void requireRay(const char* figure, const Snapshot& snapshot);

}  // namespace reliefui
