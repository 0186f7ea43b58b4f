
// Relaxed cone stepping, Policarpo & Oliveira 2007, over the corrected cones of Ban et al. 2024.
Hit traceRelaxedConeRobust(Ray ray) {
    float above;
    Hit hit = marchCones(ray, above);
    if (!hit.found || gapAt(ray, hit.lambda) <= 0.0) return hit;
    return Hit(true, bisected(ray, above, hit.lambda), hit.steps + BISECTIONS);
}
