const int BISECTIONS = 8;  // number of bisections of the last layer or step

// Halves the interval of depths from `above`, where the ray is above the surface, to `below`, where it is not. Returns
// the deeper end of the last interval.
float bisected(Ray ray, float above, float below) {
    for (int n = 0; n < BISECTIONS; ++n) {
        float middle = 0.5 * (above + below);
        if (gapAt(ray, middle) < 0.0) {
            above = middle;
        } else {
            below = middle;
        }
    }
    return below;
}
