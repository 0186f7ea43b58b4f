//@header coneMap, of each cell between four texel centres: red the height of the highest of 3 x 3 cells, on which the cone
//@header stands, rounded up; green the cone. As many texels as cells: those of the height map, or one more on each axis unless
//@header ADDRESS is 0. Not filtered; relief map cone --pack R=apex,G=cone writes it.

layout(binding = 3) uniform sampler2D coneMap;

// Steps along conservative cones, Dummer 2006; made safe for the bilinear surface as by Ban et al. 2024. Exact but for
// rounding.
Hit traceCone(Ray viewRay) {
    CellRay ray = cellRay(viewRay);
    float lambda = viewRay.from;
    if (!inside(placeAt(viewRay, lambda))) return Hit(false, lambda, 1);
    int most = int(abs(ray.run.x) + abs(ray.run.y)) + 6;
    for (int steps = 1; steps <= most; ++steps) {
        Node cell = cellAt(ray, lambda);
        vec2 exits = exitDepths(ray, cell, 0);
        float exit = max(min(min(exits.x, exits.y), 1.0), lambda);
        if (ADDRESS == 2 && exit <= lambda) return Hit(false, lambda, steps);
        vec2 cone = texelFetch(coneMap, cell.index, 0).rg;
        float after = exit;
        if (1.0 - exit > cone.r) {
            // Until the ray meets the cone it can hit nothing.
            after = exit + (1.0 - exit - cone.r) / (1.0 + coneRise(cone.g, ray.run));
        } else {
            vec2 entries = entryDepths(ray, cell, 0);
            vec4 corners = cornersOf(cell);
            float hit = patchHit(ray, cell, corners, max(max(entries.x, entries.y), 0.0), exit);
            if (hit < FAR) return Hit(true, max(hit, viewRay.from), steps);
        }
        if (after >= 1.0 || !inside(placeAt(viewRay, after))) return Hit(false, after, steps);
        lambda = after;
    }
    return Hit(false, lambda, most);
}
