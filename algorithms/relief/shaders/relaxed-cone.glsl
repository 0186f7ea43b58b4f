
// Relaxed cone stepping, Policarpo & Oliveira 2007: wider cones, in which a ray crosses the surface at most once.
Hit traceRelaxedCone(Ray ray) {
    float above;
    Hit hit = marchCones(ray, above);
    if (!hit.found || gapAt(ray, hit.lambda) <= 0.0) return hit;
    return Hit(true, bisected(ray, above, hit.lambda), hit.steps + BISECTIONS);
}
