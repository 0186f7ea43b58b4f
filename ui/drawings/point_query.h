// A point C of the slab with its two distances, as the distance map and the profile draw it: the sphere of the
// Euclidean distance and the vector to the surface point that decides it, and the sphere of the refined distance with
// the ray from above that decides it; and a ray through C towards the nearest surface point that hits something before
// C, which is why that point does not count. [DIST17] figs. 5 to 8.
#pragma once

#include <memory>
#include <optional>

#include "drawings/legend_rows.h"
#include "relief/tracers/point_distances.h"
#include "workspace/pane_states.h"

namespace reliefui {

struct DistanceFrame;
struct ProfileFrame;
struct ProfileSource;

struct PointQuery {
    QueryPoint point;   // as it was set; where the picture repeats, in any of its copies
    QueryPoint within;  // the same in the first copy, which the distances are of
    relief::PointDistances distances;
};

// Whether the point has distances: it lies over the picture, or the picture repeats.
bool overPicture(const relief::HeightField& field, const QueryPoint& point);
// Null where the point does not lie over the picture. flattest: degrees below which rays are not served. Traces some
// ten thousand rays; throws Cancelled.
std::shared_ptr<const PointQuery> pointQuery(const relief::HeightField& field, const QueryPoint& point, double flattest,
                                             relief::MapCache& cache, relief::Work& work);

// Adds the point, the spheres and the rays where the slice, or the plane of the profile's ray, cuts a sphere. A
// point beyond what is shown is drawn in the copy of the picture that is nearest to its middle.
void addPointMarks(Drawing& drawing, const PointQuery& query, const relief::HeightField& field,
                   const DistanceFrame& frame);
void addPointMarks(Drawing& drawing, const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame);
// Where they draw the point itself; none: it is not seen.
std::optional<Point> pointMarkAt(const PointQuery& query, const relief::HeightField& field, const DistanceFrame& frame);
std::optional<Point> pointMarkAt(const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame);
// Names the lines, with the distances and the ray.
void addPointLegend(LegendRows& rows, const PointQuery& query);

}  // namespace reliefui
