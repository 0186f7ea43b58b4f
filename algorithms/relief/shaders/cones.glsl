//@header Cones: green, as CONE_UNITS says. Rounded outwards: a slope up, a ratio or its root down.
const int CONE_UNITS = 0;  // green: 0 slope, heights per texel; 1 ratio, radius in texture widths per height; 2 its root

// The slope of a cone, heights per texel, from the number that the map stores.
float coneSlope(float stored) {
    if (CONE_UNITS == 0) return stored;
    float ratio = CONE_UNITS == 1 ? stored : stored * stored;
    return 1.0 / (max(ratio, 1e-6) * relief.size.x);
}
