//@header Heights: red of reliefMap, linear numbers (not sRGB) from 0 to 1; height 1 is the polygon's plane, 0 the slab's
//@header floor; the number is the height (WHITE 0), or one minus it (WHITE 1). 8 bits give terraces; block compression
//@header destroys green.
//@header Addressing: every sampler as ADDRESS says (0 repeat, 1 clamp, 2 clamp, too, and what lies outside is
//@header discarded); maps must be built with the same addressing. No MIP levels, unless said otherwise; for
//@header INTERPOLATION 0, linear filter. reliefMap must have relief.size texels: let no quality setting drop levels.
//@header Between texels: INTERPOLATION 1 weights texels in float, as Reliefscope's tracers do; 0 uses the sampler, one fetch for
//@header all channels, but graphics cards round its weights to 8 bits: hits move, and steps may pass the surface.
//@header Axes: texel (0, 0) is the picture's upper left one; v grows with its rows, downwards, as in Direct3D and Vulkan.
//@header Where textures hold the last row first (OpenGL, Unity), v grows upwards: pass the v at which they are sampled, and
//@header let the tangent frame's y point up the picture. Tangent frame: x along u, y along growing v, z out of the polygon;
//@header lengths in widths of the texture on it.
//@header Depth: the hit's, by relief.depthOfDistance, in perspective projections only; x = (f / (f - n)), y = -f n / (f - n)
//@header for planes n and f and a depth buffer from 0 to 1. Sides: relief.size in texels, relief.depth in texture widths; texels are square.
const int ADDRESS = 0;  // relief outside the map: 0 repeat, 1 clamp, 2 border (clamp the samplers; the rest is discarded)
const int WHITE = 0;    // what white means in reliefMap: 0 high, 1 deep
const int INTERPOLATION = 1;  // between texels: 0 by the sampler, 1 in float

layout(std140, binding = 0) uniform Relief {
    vec2 size;             // of the height map, texels
    float depth;           // thickness of the slab, texture widths
    float ambient;         // light in shadow
    float intensity;       // light where it falls at right angles, added to ambient
    vec2 depthOfDistance;  // depth buffer = x + y / distance: the projection's, distance along the view axis
@uniforms@} relief;
layout(binding = 1) uniform sampler2D reliefMap;  // red: height, 1 = the polygon's plane; linear filter
layout(binding = 2) uniform sampler2D colorMap;

// A ray that descends through the slab: at depth lambda (0 = the polygon's plane, 1 = the slab's floor) it is above
// the texel coordinates start + lambda * run. Texel (i, j) has its centre at (i + 0.5, j + 0.5).
struct Ray {
    vec2 start;
    vec2 run;
    float from;  // depth at which the search begins
};
struct Hit {
    bool found;    // false: the ray left the map (border)
    float lambda;  // depth of the hit
    int steps;     // decisions taken
};

vec2 placeAt(Ray ray, float lambda) {
    return ray.start + lambda * ray.run;
}

bool inside(vec2 place) {
    if (ADDRESS != 2) return true;
    return place.x >= 0.0 && place.y >= 0.0 && place.x <= relief.size.x && place.y <= relief.size.y;
}

float slabTexels() {
    return relief.depth * relief.size.x;
}

float heightOf(float stored) {
    return WHITE == 0 ? stored : 1.0 - stored;
}

// Red and green of reliefMap. Explicit level: the derivatives that texture() takes are wrong within loops and at
// silhouettes.
vec2 reliefAt(vec2 place) {
    if (INTERPOLATION == 0) return textureLod(reliefMap, place / relief.size, 0.0).rg;
    vec2 low = floor(place - 0.5);
    vec2 share = place - 0.5 - low;
    // Gathered at the corner that the four texels share, so that rounding cannot choose others: (x, y + 1),
    // (x + 1, y + 1), (x + 1, y), (x, y).
    vec2 corner = (low + 1.0) / relief.size;
    vec4 red = textureGather(reliefMap, corner, 0);
    vec4 green = textureGather(reliefMap, corner, 1);
    vec2 above = mix(vec2(red.w, green.w), vec2(red.z, green.z), share.x);
    vec2 below = mix(vec2(red.x, green.x), vec2(red.y, green.y), share.x);
    return mix(above, below, share.y);
}

float heightAt(vec2 place) {
    return heightOf(reliefAt(place).r);
}

// Surface minus ray, in heights: 0 or more where the ray has reached the surface.
float gapAt(Ray ray, float lambda) {
    return heightAt(placeAt(ray, lambda)) - (1.0 - lambda);
}
