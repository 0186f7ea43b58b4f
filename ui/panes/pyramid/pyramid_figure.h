// The pyramid as a figure, flat and as slabs.
#pragma once

#include <optional>

#include "painting/annotation.h"
#include "panes/figure.h"
#include "panes/pyramid/pyramid_parts.h"
#include "panes/turntable.h"

namespace reliefui {

// The page is high enough to print every texel's value, unless it would become higher than wide.
std::shared_ptr<const Figure> pyramidFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const PyramidOptions& options, const std::vector<Annotation>& notes);
// Where the texels of level 0 lie on the drawing; on that of several kinds, on the first one.
AnnotationFrame pyramidAnnotations(const PyramidParts& parts);
// camera: view of the slabs; std::nullopt: the initial view. Rendered with OpenGL; throws WorkError if it is not
// available. turn: of an orbit, in degrees.
std::shared_ptr<const Figure> slabsFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                          const PyramidOptions& options, const std::optional<Turntable>& camera,
                                          std::optional<double> turn = {});

}  // namespace reliefui
