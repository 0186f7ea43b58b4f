
// Steep parallax mapping, McGuire 2005: the answer is the first layer below the surface.
Hit traceLayers(Ray ray) {
    Bracket bracket;
    bool refine;
    return searchLayers(ray, bracket, refine);
}
