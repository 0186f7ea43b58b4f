//@header Cones: green, in CONE_UNIT, rounded outwards: a ratio or its root down, a slope up. ratio: radius of the cone in the
//@header unit of CONE_LENGTH per unit of height (the slab is 1 high); slope: heights per unit of length, one over the ratio;
//@header texel-slope: heights per texel, as in the maps that Reliefscope stores for itself. The number is the stored one times
//@header CONE_SCALE, for sqrt-ratio after it is squared.
const int CONE_UNIT = 0;       // 0 ratio, 1 sqrt-ratio, 2 slope, 3 texel-slope
const int CONE_LENGTH = 0;     // 0 texture coordinates (uv), so that cones are ellipses on maps that are not square; 1 texture widths
const float CONE_SCALE = 1.0;  // of the stored number

// The height by which the cone rises along the ray's whole run.
float coneRise(float stored, vec2 run) {
    if (CONE_UNIT == 3) return stored * length(run);
    float runLength = CONE_LENGTH == 0 ? length(run / relief.size) : length(run) / relief.size.x;
    if (CONE_UNIT == 2) return stored * CONE_SCALE * runLength;
    float ratio = (CONE_UNIT == 1 ? stored * stored : stored) * CONE_SCALE;
    return runLength / max(ratio, 1e-6);
}
