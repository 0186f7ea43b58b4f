//@header distanceMap: distance from the centre of each voxel to the surface, in the metric of texels in which the slab is
//@header depth * size.x thick; the stored number times relief.distanceScale is in texture widths. Layer 0 is at the slab's floor. Linear filter; the
//@header third axis always clamped.
const int ITERATIONS = 256;  // largest number of steps
const int STOP = 0;          // 0 at the surface, 1 where the distance is below WITHIN, 2 after all steps
const float WITHIN = 0.05;   // texels

//@uniform     float distanceScale;   // texture widths per unit of distanceMap
layout(binding = 3) uniform sampler3D distanceMap;

// Sphere tracing, Donnelly 2005: each step advances by the distance to the surface.
Hit traceDistance(Ray ray) {
    float texelsPerLambda = length(vec3(ray.run, slabTexels()));
    float lambda = ray.from;
    float above = lambda;
    float gapAbove = 0.0;
    for (int n = 0; n < ITERATIONS; ++n) {
        if (lambda >= 1.0) return Hit(true, lambda, n + 1);
        vec2 place = placeAt(ray, lambda);
        if (STOP == 0) {
            float gap = heightAt(place) - (1.0 - lambda);
            if (gap >= 0.0) {
                // Where the straight line between the last two heights meets the ray.
                float hit = n > 0 ? above + gapAbove / (gapAbove - gap) * (lambda - above) : lambda;
                return Hit(true, hit, n + 1);
            }
            above = lambda;
            gapAbove = gap;
        }
        float clear = textureLod(distanceMap, vec3(place / relief.size, 1.0 - lambda), 0.0).r;
        clear *= relief.distanceScale * relief.size.x;
        if (STOP == 1 && clear < WITHIN) return Hit(true, lambda, n + 1);
        lambda = texelsPerLambda > 0.0 ? min(lambda + clear / texelsPerLambda, 1.0) : 1.0;
        if (!inside(placeAt(ray, lambda))) return Hit(false, lambda, n + 2);
    }
    return Hit(true, lambda, ITERATIONS + 1);
}
