// The result as a figure.
#pragma once

#include "painting/annotation.h"
#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Rendered again at its size on the page. If its layer has a legend, it stands below the picture.
std::shared_ptr<const Figure> resultFigure(std::shared_ptr<const Snapshot> snapshot,
                                           const std::vector<Annotation>& notes);

// Where the pixels of the picture lie on a page or widget. picture: the whole picture there; seen: its visible part;
// pixels: width of the picture.
AnnotationFrame resultAnnotations(const Box& picture, const Box& seen, int pixels, double unit);

}  // namespace reliefui
