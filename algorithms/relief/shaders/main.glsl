
// --- The pixel. Tangent frame: x along u, y along growing v, z out of the polygon; the unit of length
// is the width of the texture on the polygon.
const float SHADOW_BIAS = 0.01;  // depth by which a blocker must lie above the point that it shadows

layout(location = 0) in vec2 texcoord;  // 0 to 1 over the map, as the textures are sampled
layout(location = 1) in vec3 fromEye;   // from the eye to the polygon's point, tangent frame
layout(location = 2) in vec3 toLight;   // tangent frame, any length
layout(location = 0) out vec4 color;

vec3 normalAt(vec2 place) {
    float alongS = heightAt(place + vec2(0.5, 0.0)) - heightAt(place - vec2(0.5, 0.0));
    float alongT = heightAt(place + vec2(0.0, 0.5)) - heightAt(place - vec2(0.0, 0.5));
    return normalize(vec3(-alongS * slabTexels(), -alongT * slabTexels(), 1.0));
}

// Follows the light's ray down from the top of the slab, so that the tracer is used for rays from above only.
bool inShadow(vec2 place, float lambda, vec3 light) {
    if (light.z <= 0.0) return true;
    Ray ray;
    ray.run = -light.xy / light.z * slabTexels();
    ray.start = place - lambda * ray.run;
    ray.from = 0.0;
    if (ADDRESS == 2) {
        // Begin where the ray enters through the side of the map.
        if (ray.start.x < 0.0) ray.from = max(ray.from, -ray.start.x / ray.run.x);
        if (ray.start.y < 0.0) ray.from = max(ray.from, -ray.start.y / ray.run.y);
        if (ray.start.x > relief.size.x) ray.from = max(ray.from, (relief.size.x - ray.start.x) / ray.run.x);
        if (ray.start.y > relief.size.y) ray.from = max(ray.from, (relief.size.y - ray.start.y) / ray.run.y);
        // Deeper by more than the rounding: just outside the map the tracer would find nothing.
        ray.from *= 1.000002;
    }
    Hit blocker = @trace@(ray);
    return blocker.found && blocker.lambda < lambda - SHADOW_BIAS;
}

void main() {
    // Of the polygon, before any branch: they are smooth, while those of the hit jump at silhouettes.
    vec2 acrossX = dFdx(texcoord);
    vec2 acrossY = dFdy(texcoord);
    if (fromEye.z >= 0.0) discard;  // seen from behind
    Ray ray;
    ray.start = texcoord * relief.size;
    ray.run = fromEye.xy / -fromEye.z * slabTexels();
    ray.from = 0.0;
    Hit hit = @trace@(ray);
    if (!hit.found) discard;  // silhouette at the map's border
    vec2 place = placeAt(ray, hit.lambda);
    // The hit is this many times as far from the eye as the polygon; so is its pixel as wide.
    float farther = 1.0 + hit.lambda * relief.depth / -fromEye.z;
    vec4 albedo = textureGrad(colorMap, place / relief.size, acrossX * farther, acrossY * farther);
    vec3 light = normalize(toLight);
    float lit = max(dot(normalAt(place), light), 0.0);
    if (lit > 0.0 && inShadow(place, hit.lambda, light)) lit = 0.0;
    color = vec4(albedo.rgb * (relief.ambient + relief.intensity * lit), albedo.a);
    // gl_FragCoord.w is one over the distance along the view axis, in perspective projections only.
    gl_FragDepth = relief.depthOfDistance.x + relief.depthOfDistance.y * gl_FragCoord.w / farther;
}
