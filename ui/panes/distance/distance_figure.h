// The slice through a distance map as a figure.
#pragma once

#include <optional>

#include "painting/annotation.h"
#include "panes/distance/distance_drawing.h"
#include "panes/distance/distance_state.h"
#include "panes/figure.h"
#include "panes/point_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

DistanceOptions distanceOptions(const DistancePane& pane, const ColorRanges& ranges = {});
DistancePane paneOf(const DistanceOptions& options);

// Throws InputError that names `what` if the map that the scenario's distance pane shows has no slice of this index.
// Builds the map.
void checkSlice(const Snapshot& snapshot, int slice, const std::string& what, relief::Work& work);

// point: its distances are shown. Painting throws InputError if the map cannot be built.
std::shared_ptr<const Figure> distanceFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                             const DistanceOptions& options, const std::optional<QueryPoint>& point,
                                             const std::vector<Annotation>& notes);

// Where the data of the slice's annotations lie on its drawing.
AnnotationFrame distanceAnnotations(const DistanceFrame& frame);

}  // namespace reliefui
