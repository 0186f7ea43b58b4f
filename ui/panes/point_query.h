// A point C of the slab with its two distances, as drawn in the distance map and the profile: the sphere of the
// Euclidean distance with the vector to the nearest surface point; the sphere of the refined distance with the ray from
// above that decides it; and, if the nearest surface point does not count, a ray through C towards it that hits the
// surface before C. [DIST17] figs. 5 to 8.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "painting/legend_rows.h"
#include "panes/point_state.h"
#include "panes/ray_geometry.h"
#include "relief/tracers/point_distances.h"

namespace reliefui {

struct PointQuery {
    QueryPoint point;   // as set; if the picture repeats, possibly in another copy
    QueryPoint within;  // the same point in the first copy, to which the distances refer
    relief::PointDistances distances;
};

// Returns true if the point has distances: it lies over the picture, or the picture repeats.
bool overPicture(const relief::HeightField& field, const QueryPoint& point);
// Returns null if the point does not lie over the picture. flattest: elevation in degrees below which rays are ignored.
// Traces some ten thousand rays. Throws Cancelled.
std::shared_ptr<const PointQuery> pointQuery(const relief::HeightField& field, const QueryPoint& point, double flattest,
                                             relief::MapCache& cache, relief::Work& work);

// The periodic copy of a place that is nearest to `near`.
double nearestCopy(double place, double near, double period);

// The drawn plane, as needed for the marks.
struct PointPlane {
    Box plot;
    std::function<Point(const Place3&)> at;  // maps a place, projected along the plane's normal, to the drawing
    Place3 center{};                         // C, in the periodic copy nearest to the visible part
    double off = 0;                          // distance of C from the plane, in texels
    double scaleX = 1;                       // points per texel
    double scaleY = 1;
    double slab = 0;      // thickness D of the slab
    bool spheres = true;  // false for maps drawn from above, which have no plane that could intersect spheres
};

// Adds the point, the cross-sections of its spheres with the plane, and the rays.
void addPointMarks(Drawing& drawing, const PointQuery& query, const PointPlane& plane);
// Position of the point's mark; std::nullopt if it is not visible.
std::optional<Point> pointMarkAt(const PointPlane& plane, const PointQuery& query);
// Adds the names of the lines, with the distances and the ray.
void addPointLegend(LegendRows& rows, const PointQuery& query);

}  // namespace reliefui
