// The footprint of the chosen pixel as a figure.
#pragma once

#include "painting/annotation.h"
#include "panes/figure.h"
#include "panes/footprint/footprint_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> footprintFigure(std::shared_ptr<const Snapshot> snapshot, const FootprintOptions& options,
                                              const std::vector<Annotation>& notes);

// Where the texels of the height map, in which annotations are placed, lie on the drawing. seen: its visible part.
AnnotationFrame footprintAnnotations(const PixelFootprint& footprint, const Box& seen, double pointsPerTexel);

}  // namespace reliefui
