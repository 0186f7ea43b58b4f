//@header distanceMap: distance from the centre of each voxel to the surface, in the metric of texels in which the slab is
//@header depth * size.x thick; the stored number times relief.distanceScale is in texture widths. Layer 0 is at the slab's floor. Linear filter; the
//@header third axis always clamped.
const int ITERATIONS = 256;  // largest number of steps
const int STOP = 0;          // 0 at the surface, 1 where the distance is below WITHIN, 2 after all steps
const float WITHIN = 0.05;   // texels

//@uniform     float distanceScale;   // texture widths per unit of distanceMap
layout(binding = 3) uniform sampler3D distanceMap;

// A voxel next to the volume, under the addressing.
ivec3 voxelAt(ivec3 voxel, ivec3 voxels) {
    ivec2 across = clamp(voxel.xy, ivec2(0), voxels.xy - 1);
    if (ADDRESS == 0) across = voxel.xy - ivec2(floor((vec2(voxel.xy) + 0.5) / vec2(voxels.xy))) * voxels.xy;
    return ivec3(across, clamp(voxel.z, 0, voxels.z - 1));
}

// The distance above a place at a height, as stored.
float distanceAt(vec2 place, float height) {
    if (INTERPOLATION == 0) return textureLod(distanceMap, vec3(place / relief.size, height), 0.0).r;
    ivec3 voxels = textureSize(distanceMap, 0);
    vec3 at = vec3(place, height) * vec3(voxels) / vec3(relief.size, 1.0) - 0.5;
    vec3 low = floor(at);
    vec3 share = at - low;
    ivec3 a = voxelAt(ivec3(low), voxels), b = voxelAt(ivec3(low) + 1, voxels);
    // The columns at the four corners: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
    vec4 below = vec4(texelFetch(distanceMap, a, 0).r, texelFetch(distanceMap, ivec3(b.x, a.yz), 0).r,
                      texelFetch(distanceMap, ivec3(a.x, b.y, a.z), 0).r, texelFetch(distanceMap, ivec3(b.xy, a.z), 0).r);
    vec4 above = vec4(texelFetch(distanceMap, ivec3(a.xy, b.z), 0).r, texelFetch(distanceMap, ivec3(b.x, a.y, b.z), 0).r,
                      texelFetch(distanceMap, ivec3(a.x, b.yz), 0).r, texelFetch(distanceMap, b, 0).r);
    vec4 column = mix(below, above, share.z);
    return mix(mix(column.x, column.y, share.x), mix(column.z, column.w, share.x), share.y);
}

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
        float clear = distanceAt(place, 1.0 - lambda);
        clear *= relief.distanceScale * relief.size.x;
        if (STOP == 1 && clear < WITHIN) return Hit(true, lambda, n + 1);
        lambda = texelsPerLambda > 0.0 ? min(lambda + clear / texelsPerLambda, 1.0) : 1.0;
        if (!inside(placeAt(ray, lambda))) return Hit(false, lambda, n + 2);
    }
    return Hit(true, lambda, ITERATIONS + 1);
}
