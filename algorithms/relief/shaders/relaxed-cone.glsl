const int BISECTIONS = 8;  // number of bisections of the last step

// Relaxed cone stepping, Policarpo & Oliveira 2007: wider cones, in which a ray crosses the surface at most once.
Hit traceRelaxedCone(Ray ray) {
    float above;
    Hit hit = marchCones(ray, above);
    if (!hit.found || gapAt(ray, hit.lambda) <= 0.0) return hit;
    float below = hit.lambda;
    for (int n = 0; n < BISECTIONS; ++n) {
        float middle = 0.5 * (above + below);
        if (gapAt(ray, middle) < 0.0) {
            above = middle;
        } else {
            below = middle;
        }
    }
    return Hit(true, below, hit.steps + BISECTIONS);
}
