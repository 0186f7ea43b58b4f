// A point C of the slab with its two distances, as the distance map and the profile draw it: the sphere of the
// Euclidean distance and the vector to the surface point that decides it, and the sphere of the refined distance with
// the ray from above that decides it; and a ray through C towards the nearest surface point that hits something before
// C, which is why that point does not count. [DIST17] figs. 5 to 8.
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

// The same place in the period that brings it nearest to `near`.
double nearestCopy(double place, double near, double period);

// The plane that is drawn, as the marks need it.
struct PointPlane {
    Box plot;
    std::function<Point(const Place3&)> at;  // where a place lies on the drawing, seen along the plane's normal
    Place3 center{};                         // C, in the copy of the picture that is drawn: nearest to what is shown
    double off = 0;                          // texels from C to the plane
    double scaleX = 1;                       // points a texel
    double scaleY = 1;
    double slab = 0;      // D
    bool spheres = true;  // maps seen from above have no plane that could cut them
};

// Adds the point, the spheres where the plane cuts them, and the rays.
void addPointMarks(Drawing& drawing, const PointQuery& query, const PointPlane& plane);
// Where they draw the point itself; none: it is not seen.
std::optional<Point> pointMarkAt(const PointPlane& plane, const PointQuery& query);
// Names the lines, with the distances and the ray.
void addPointLegend(LegendRows& rows, const PointQuery& query);

}  // namespace reliefui
