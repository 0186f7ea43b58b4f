
// Parallax mapping with offset limiting, Welsh 2004: the shift never exceeds the depth of the slab.
Hit traceOffsetLimited(Ray ray) {
    vec2 entry = placeAt(ray, ray.from);
    float lengthOfRay = length(vec3(ray.run, slabTexels()));
    float share = lengthOfRay > 0.0 ? slabTexels() / lengthOfRay : 1.0;
    float lambda = ray.from + max(1.0 - heightAt(entry) - ray.from, 0.0) * share;
    return Hit(inside(entry) && inside(placeAt(ray, lambda)), lambda, 1);
}
