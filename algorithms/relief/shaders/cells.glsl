//@header Rows: cells are counted from the maps' first row, which must be the textures' first one, at v = 0. Where pictures are
//@header loaded with the last row first, flip the finished maps, the heights and the colours before that; v then grows downwards.
const float FAR = 1e30;  // greater than every depth

// The bilinear surface is a patch in each cell between four texel centres. Cells are numbered from 0: under repeat cell
// i lies between the centres of texels i and i + 1 and there are as many cells as texels; otherwise it lies between i -
// 1 and i, and there is one more. In cell coordinates x cell i reaches from i to i + 1.
struct CellRay {
    vec2 start, run, inverse;
    ivec2 side;   // sign of the run
    ivec2 cells;  // in a period
};
// A square of 2^level cells on each axis: cells [index * 2^level, (index + 1) * 2^level) of the period that begins at
// cell `base`. Steps change only these integers, so that rounding cannot make the walk skip a cell.
struct Node {
    ivec2 index, base;
};

CellRay cellRay(Ray ray) {
    CellRay cell;
    cell.start = ray.start + (ADDRESS == 0 ? -0.5 : 0.5);
    cell.run = ray.run;
    cell.side = ivec2(sign(ray.run));
    cell.inverse = 1.0 / mix(ray.run, vec2(1.0), equal(ray.run, vec2(0.0)));
    cell.cells = ivec2(relief.size) + (ADDRESS == 0 ? 0 : 1);
    return cell;
}

// Cell coordinates of the lines k of the period that begins at `base`. At the map's border cells end half a texel outside
// the outermost centres, or, under clamp, never.
vec2 linesOf(CellRay ray, ivec2 k, ivec2 base) {
    if (ADDRESS == 0) return vec2(base + k);
    vec2 low = vec2(ADDRESS == 1 ? -FAR : 0.5), high = ADDRESS == 1 ? vec2(FAR) : vec2(ray.cells) - 0.5;
    return mix(mix(vec2(k), low, lessThanEqual(k, ivec2(0))), high, greaterThanEqual(k, ray.cells));
}

// Depths at which the ray crosses a line on each axis.
vec2 depthsAt(CellRay ray, vec2 lines) {
    return (lines - ray.start) * ray.inverse;
}

// Depths at which the ray enters and leaves the node on each axis; without a limit where it runs along the axis' lines.
vec2 entryDepths(CellRay ray, Node node, int level) {
    ivec2 first = node.index << level, last = min(first + (1 << level), ray.cells);
    vec2 depths = depthsAt(ray, linesOf(ray, mix(last, first, greaterThan(ray.side, ivec2(0))), node.base));
    return mix(depths, vec2(-FAR), equal(ray.side, ivec2(0)));
}
vec2 exitDepths(CellRay ray, Node node, int level) {
    ivec2 first = node.index << level, last = min(first + (1 << level), ray.cells);
    vec2 depths = depthsAt(ray, linesOf(ray, mix(first, last, greaterThan(ray.side, ivec2(0))), node.base));
    return mix(depths, vec2(FAR), equal(ray.side, ivec2(0)));
}

// Moves to the node that the ray enters next; across a corner to the diagonal one. Returns false at the map's border.
bool moveOn(CellRay ray, vec2 exits, int level, inout Node node) {
    ivec2 last = (ray.cells - 1) >> level;
    ivec2 next = node.index + mix(ivec2(0), ray.side, lessThanEqual(exits, exits.yx));
    bvec2 under = lessThan(next, ivec2(0)), over = greaterThan(next, last);
    if (ADDRESS != 0 && (any(under) || any(over))) return false;
    node.base += mix(ivec2(0), ray.cells, over) - mix(ivec2(0), ray.cells, under);
    node.index = mix(mix(next, last, under), ivec2(0), over);
    return true;
}

// The cell in which the ray is at, and just after, depth lambda: from its position, corrected by the depths that the
// walk compares, since a position near a line may be rounded to its other side.
Node cellAt(CellRay ray, float lambda) {
    ivec2 at = ivec2(floor(ray.start + lambda * ray.run));
    vec2 exits = depthsAt(ray, vec2(at + max(ray.side, ivec2(0))));
    at += mix(ivec2(0), ray.side, lessThanEqual(exits, vec2(lambda)));
    vec2 entries = depthsAt(ray, vec2(at + max(-ray.side, ivec2(0))));
    at -= mix(ivec2(0), ray.side, greaterThan(entries, vec2(lambda)));
    if (ADDRESS != 0) return Node(clamp(at, ivec2(0), ray.cells - 1), ivec2(0));
    ivec2 base = ivec2(floor((vec2(at) + 0.5) / vec2(ray.cells))) * ray.cells;
    return Node(at - base, base);
}

// The index of a texel next to the map, under the addressing.
ivec2 wrapped(ivec2 texel, ivec2 texels) {
    if (ADDRESS != 0) return clamp(texel, ivec2(0), texels - 1);
    return mix(texel, ivec2(0), greaterThanEqual(texel, texels));
}

// Heights of the four texels around a cell: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
vec4 cornersOf(Node cell) {
    ivec2 low = cell.index - (ADDRESS == 0 ? 0 : 1);
    ivec2 texels = ivec2(relief.size);
    ivec2 a = wrapped(low, texels), b = wrapped(low + 1, texels);
    return vec4(heightOf(texelFetch(reliefMap, a, 0).r), heightOf(texelFetch(reliefMap, ivec2(b.x, a.y), 0).r),
                heightOf(texelFetch(reliefMap, ivec2(a.x, b.y), 0).r), heightOf(texelFetch(reliefMap, b, 0).r));
}

float patchHeight(vec4 corners, vec2 place) {
    return mix(mix(corners.x, corners.y, place.x), mix(corners.z, corners.w, place.x), place.y);
}

// Depth at which the ray meets the patch of the cell between its entry and exit; FAR if it does not. Along the ray the
// surface minus the ray is a parabola gapIn + slope w + curve w^2, w from 0 at the entry to 1 at the exit.
float patchHit(CellRay ray, Node cell, vec4 corners, float entry, float exit) {
    if (!(entry < exit)) return FAR;
    vec2 corner = vec2(cell.base + cell.index);
    vec2 first = clamp(ray.start + entry * ray.run - corner, 0.0, 1.0);
    vec2 last = clamp(ray.start + exit * ray.run - corner, 0.0, 1.0);
    float gapIn = patchHeight(corners, first) - (1.0 - entry);
    if (gapIn >= 0.0) return entry;
    float gapOut = patchHeight(corners, last) - (1.0 - exit);
    float curve = (last.x - first.x) * (last.y - first.y) * ((corners.w - corners.y) - (corners.z - corners.x));
    float slope = gapOut - gapIn - curve;
    if (gapOut < 0.0 && !(curve < 0.0 && slope > 0.0 && slope < -2.0 * curve)) return FAR;  // no summit between
    float discriminant = slope * slope - 4.0 * curve * gapIn;
    if (discriminant < 0.0 && gapOut < 0.0) return FAR;
    float root = sqrt(max(discriminant, 0.0));
    // Of both forms of the root, the one whose sum does not cancel.
    float w = slope >= 0.0 ? -2.0 * gapIn / (slope + root) : (root - slope) / (2.0 * curve);
    return entry + (w < 1.0 ? w : 1.0) * (exit - entry);
}
