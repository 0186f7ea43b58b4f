
// Cone step mapping, Dummer 2006.
Hit traceConeDummer(Ray ray) {
    float above;
    return marchCones(ray, above);
}
