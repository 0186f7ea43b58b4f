
// Relief mapping, Policarpo et al. 2005: layers, then bisection of the last one.
Hit traceLayersBisection(Ray ray) {
    Bracket bracket;
    bool refine;
    Hit hit = searchLayers(ray, bracket, refine);
    if (!hit.found || !refine) return hit;
    return Hit(true, bisected(ray, bracket.above, bracket.below), hit.steps + BISECTIONS);
}
