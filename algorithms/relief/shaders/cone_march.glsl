//@header Green of reliefMap: the cone on the surface at the texel, filtered as the height is.
const int ITERATIONS = 32;  // largest number of steps

// Steps to the edge of the cone that stands on the surface below the ray, until the ray reaches the surface. Green of
// reliefMap: the cone, interpolated as the height is. above: depth of the last point above the surface.
Hit marchCones(Ray ray, out float above) {
    float lambda = ray.from;
    int steps = 1;
    above = lambda;
    for (int n = 0; n < ITERATIONS; ++n) {
        vec2 place = placeAt(ray, lambda);
        if (!inside(place)) return Hit(false, lambda, steps);
        vec2 stored = reliefAt(place);
        float gap = heightOf(stored.r) - (1.0 - lambda);
        if (gap >= 0.0 || lambda >= 1.0) break;
        above = lambda;
        lambda = min(lambda - gap / (1.0 + coneRise(stored.g, ray.run)), 1.0);
        ++steps;
    }
    return Hit(inside(placeAt(ray, lambda)), lambda, steps);
}
