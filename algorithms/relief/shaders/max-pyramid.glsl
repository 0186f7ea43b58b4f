//@header maxPyramid: level k holds the maxima of 2^k x 2^k heights in ceil(size / 2^k) texels, the last ones of
//@header fewer heights; level 0 is the height map. relief.pyramidLevels is their number, that of 1 x 1 texel included. Where a side is
//@header no power of two, enlarge the texture to a multiple of 2^(pyramidLevels - 1), so that each level has room; what is
//@header stored beyond is not read. If white is deep, they are minima. Not filtered. With powers of two, reliefMap may be the same texture.

//@uniform     int pyramidLevels;     // levels of maxPyramid, that of 1 x 1 texel included
layout(binding = 3) uniform sampler2D maxPyramid;

float maximumAt(ivec2 texel, int level) {
    return heightOf(texelFetch(maxPyramid, texel, level).r);
}

// The highest point of the texels around the node's cells, of which each level has 2 x 2 squares.
float maximumOf(Node node, int level) {
    ivec2 texels = (ivec2(relief.size) + (1 << level) - 1) >> level;
    ivec2 low = node.index - (ADDRESS == 0 ? 0 : 1);
    ivec2 a = wrapped(low, texels), b = wrapped(low + 1, texels);
    return max(max(maximumAt(a, level), maximumAt(ivec2(b.x, a.y), level)),
               max(maximumAt(ivec2(a.x, b.y), level), maximumAt(b, level)));
}

// Hierarchical skips on the pyramid of maxima, Tevs et al. 2008; Romaniuk & Dudnyk 2018. Exact but for rounding.
Hit traceMaxPyramid(Ray viewRay) {
    CellRay ray = cellRay(viewRay);
    int top = relief.pyramidLevels - 1;
    // Begin with nodes a quarter to half as long as the ray's run.
    float longest = max(abs(viewRay.run.x), abs(viewRay.run.y));
    int level = clamp(int(floor(log2(max(longest, 1.0)))) - 1, 0, top);
    // Above the highest point there is nothing to hit.
    float lambda = max(viewRay.from, 1.0 - maximumAt(ivec2(0), top));
    if (!inside(placeAt(viewRay, viewRay.from)) || !inside(placeAt(viewRay, lambda))) return Hit(false, lambda, 1);
    Node node = cellAt(ray, lambda);
    node.index >>= level;
    // Every node is left once, and is descended into or climbed out of at most once.
    int most = 8 * (int(abs(ray.run.x) + abs(ray.run.y)) + 4 + 4 * relief.pyramidLevels);
    for (int steps = 1; steps <= most; ++steps) {
        vec2 exits = exitDepths(ray, node, level);
        float exit = min(min(exits.x, exits.y), 1.0);
        if (maximumOf(node, level) >= 1.0 - exit) {
            if (level > 0) {
                // Descend to the child in which the ray is.
                Node cell = cellAt(ray, lambda);
                --level;
                node = Node(cell.index >> level, cell.base);
                continue;
            }
            vec2 entries = entryDepths(ray, node, 0);
            float hit = patchHit(ray, node, cornersOf(node), max(max(entries.x, entries.y), 0.0), exit);
            if (hit < FAR) return Hit(true, max(hit, viewRay.from), steps);
        }
        lambda = exit;
        if (exit >= 1.0) return Hit(false, 1.0, steps);
        ivec2 parent = node.index >> 1;
        ivec2 base = node.base;
        if (!moveOn(ray, exits, level, node)) return Hit(false, exit, steps);
        // Climb where the ray has left the parent.
        if (level < top && (any(notEqual(node.index >> 1, parent)) || any(notEqual(node.base, base)))) {
            ++level;
            node.index >>= 1;
        }
    }
    return Hit(false, lambda, most);
}
