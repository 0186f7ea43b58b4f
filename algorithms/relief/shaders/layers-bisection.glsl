const int BISECTIONS = 8;  // number of bisections of the last layer

// Relief mapping, Policarpo et al. 2005: layers, then bisection of the last one.
Hit traceLayersBisection(Ray ray) {
    Bracket bracket;
    bool refine;
    Hit hit = searchLayers(ray, bracket, refine);
    if (!hit.found || !refine) return hit;
    for (int n = 0; n < BISECTIONS; ++n) {
        float middle = 0.5 * (bracket.above + bracket.below);
        if (gapAt(ray, middle) < 0.0) {
            bracket.above = middle;
        } else {
            bracket.below = middle;
        }
    }
    return Hit(true, bracket.below, hit.steps + BISECTIONS);
}
