// A point C of the slab with its two distances, as the distance map and the profile draw it: the sphere of the
// Euclidean distance and the vector to the surface point that decides it, and the sphere of the refined distance with
// the ray from above that decides it. [DIST17] figs. 5 to 8.
#pragma once

#include <memory>
#include <optional>

#include "drawings/legend_rows.h"
#include "relief/maps/refined.h"
#include "scenario/pane_states.h"

namespace reliefui {

struct DistanceFrame;
struct ProfileFrame;
struct ProfileSource;

struct PointQuery {
    relief::QueryPoint point;           // as it was set, texels in any copy of the picture
    relief::PointDistances distances;   // of the same point in the first copy
};

// Whether the point has distances: over the picture or, where it repeats, anywhere.
bool overPicture(const relief::HeightField& field, const relief::QueryPoint& point);
// Null where the point is not over the picture. flattest: degrees below which rays are not served. Takes some
// milliseconds; throws Cancelled.
std::shared_ptr<const PointQuery> pointQuery(const relief::HeightField& field, const relief::QueryPoint& point,
                                             double flattest, relief::MapCache& cache, relief::Work& work);

// Adds point, spheres and lines where they cut the slice or the ray's plane; nothing if the slice misses them. A point
// beyond the window is drawn in the copy of the picture that is nearest to its middle.
void addPointMarks(Drawing& drawing, const PointQuery& query, const relief::HeightField& field,
                   const DistanceFrame& frame);
void addPointMarks(Drawing& drawing, const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame);
// Names the two lines, and states both distances and the ray in a sentence.
void addPointLegend(LegendRows& rows, const PointQuery& query);
// "C: Euclidean 3.000, refined 4.000 texels; decided by the ray ..."
relief::Message pointSentence(const PointQuery& query);

}  // namespace reliefui
