const int LAYERS = 64;  // number of layers in the slab

// The last layer above the surface and the first one at or below it; gap: surface minus ray.
struct Bracket {
    float above, gapAbove;
    float below, gapBelow;
};

// Finds the first layer below the surface. refine: whether there is a layer above, between which and it to search.
Hit searchLayers(Ray ray, out Bracket bracket, out bool refine) {
    bracket = Bracket(ray.from, 0.0, ray.from, 0.0);
    refine = false;
    for (int n = 0; n <= LAYERS; ++n) {
        float lambda = min(ray.from + float(n) / float(LAYERS), 1.0);
        if (!inside(placeAt(ray, lambda))) return Hit(false, lambda, n + 1);
        float gap = gapAt(ray, lambda);
        if (gap >= 0.0 || lambda >= 1.0) {
            bracket.below = lambda;
            bracket.gapBelow = max(gap, 0.0);
            refine = n > 0;
            return Hit(true, lambda, n + 1);
        }
        bracket.above = lambda;
        bracket.gapAbove = gap;
    }
    return Hit(false, 1.0, LAYERS + 1);
}
