// What a figure says of itself below its drawing: the pictures, the method, the view, the pixel and the step.
#pragma once

#include <memory>
#include <optional>

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// methods, filters: of a comparison; empty: the scenario's own. step: of the ray that is drawn, from 0; none: no ray
// is. Of the pixel where one is chosen.
FigureCaption figureCaption(std::shared_ptr<const Snapshot> snapshot, std::optional<int> step = {},
                            const std::string& methods = {}, const std::string& filters = {});

// The same of what is rendered anew for the figure: counts and errors are those of its own picture.
FigureCaption redrawnCaption(FigureCaption caption);
// Throws InputError where no pixel is chosen, or one that shows no relief.
void requireRay(const char* figure, const Snapshot& snapshot);

}  // namespace reliefui
