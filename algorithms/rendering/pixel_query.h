// Makes the query of a texture filter for a pixel with a hit.
#pragma once

#include "filtering/filter_block.h"
#include "relief/methods/look_up_point.h"
#include "rendering/visible_polygons.h"

namespace relief {

// exact: whether the hit was found by an exact method on the unfiltered heights.
inline FilterQuery pixelQuery(const VisiblePolygon& polygon, const HeightField& field, const ViewRay& ray,
                              const Hit& hit, bool exact, int x, int y) {
    FilterQuery query;
    query.ray = ray;
    query.lambda = hit.lambda;
    query.spread = polygon.runPerTexel;
    query.view = &polygon;
    query.x = x, query.y = y;
    query.exact = exact;
    query.place = lookUpPoint(field, ray, hit);
    // The plane at the hit's height has the coordinates s = s0 + lambda (s0 - sEye) r, and t likewise.
    const double scale = 1 + hit.lambda * polygon.runPerTexel;
    const Jacobian top = jacobianAt(polygon.texelFromScreen, x + 0.5, y + 0.5);
    query.jacobian = {top.ux * scale, top.vx * scale, top.uy * scale, top.vy * scale};
    return query;
}

}  // namespace relief
