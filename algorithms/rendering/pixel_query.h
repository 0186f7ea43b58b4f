// What a texture filter is asked for a pixel with a hit.
#pragma once

#include "filtering/filter_block.h"
#include "relief/methods/look_up_point.h"
#include "rendering/visible_polygons.h"

namespace relief {

// exact: the hit is of an exact method, of the heights themselves.
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
    // Of the plane at the hit's height: s = s0 + lambda (s0 - sEye) r, and t alike.
    const double scale = 1 + hit.lambda * polygon.runPerTexel;
    const Jacobian top = jacobianAt(polygon.texelFromScreen, x + 0.5, y + 0.5);
    query.jacobian = {top.ux * scale, top.vx * scale, top.uy * scale, top.vy * scale};
    return query;
}

}  // namespace relief
