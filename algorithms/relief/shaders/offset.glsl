
// Parallax mapping, Kaneko et al. 2001: the ray advances to the height at its point of entry.
Hit traceOffset(Ray ray) {
    vec2 entry = placeAt(ray, ray.from);
    float lambda = max(1.0 - heightAt(entry), ray.from);
    return Hit(inside(entry) && inside(placeAt(ray, lambda)), lambda, 1);
}
