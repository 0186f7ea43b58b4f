
// Parallax occlusion mapping, Tatarchuk 2006: a straight line between the last two layers.
Hit traceLayersSecant(Ray ray) {
    Bracket bracket;
    bool refine;
    Hit hit = searchLayers(ray, bracket, refine);
    if (!hit.found || !refine) return hit;
    float share = bracket.gapAbove / (bracket.gapAbove - bracket.gapBelow);
    return Hit(true, bracket.above + share * (bracket.below - bracket.above), hit.steps + 1);
}
