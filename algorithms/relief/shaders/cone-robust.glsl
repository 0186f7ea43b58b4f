
// Cone step mapping, Dummer 2006, over cones that are safe between texels, too (Ban et al. 2024).
Hit traceConeRobust(Ray ray) {
    float above;
    return marchCones(ray, above);
}
