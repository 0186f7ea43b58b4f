// The pyramid as a figure, flat and as slabs.
#pragma once

#include <optional>

#include "panes/figure.h"
#include "panes/pyramid/pyramid_parts.h"
#include "panes/turntable.h"

namespace reliefui {

// High enough for every value to be written into its texel, where that needs no page higher than wide.
std::shared_ptr<const Figure> pyramidFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const PyramidOptions& options);
// camera: from where the slabs are seen; none: as at first. By OpenGL: WorkError where there is none.
std::shared_ptr<const Figure> slabsFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                          const PyramidOptions& options, const std::optional<Turntable>& camera);

}  // namespace reliefui
