#include "windows/core_texts.h"

#include <QCoreApplication>

namespace reliefui {

namespace {

// Known to lupdate; looked up by their English text.
[[maybe_unused]] const char* const kKnown[] = {
    QT_TRANSLATE_NOOP("core", "Relief depth"),
    QT_TRANSLATE_NOOP("core", "Elevation"),
    QT_TRANSLATE_NOOP("core", "Azimuth"),
    QT_TRANSLATE_NOOP("core", "Distance"),
    QT_TRANSLATE_NOOP("core", "Fov"),
    QT_TRANSLATE_NOOP("core", "Light azimuth"),
    QT_TRANSLATE_NOOP("core", "Light elevation"),
    QT_TRANSLATE_NOOP("core", "Ambient"),
    QT_TRANSLATE_NOOP("core", "Intensity"),
    QT_TRANSLATE_NOOP("core", "Width"),
    QT_TRANSLATE_NOOP("core", "Height"),
    QT_TRANSLATE_NOOP("core", "Bounded"),
    QT_TRANSLATE_NOOP("core", "what hits may be wrong by where that spares work; its error is measured"),
    QT_TRANSLATE_NOOP("core", "thickness of the relief slab"),
    QT_TRANSLATE_NOOP("core", "how high the camera stands above the horizontal"),
    QT_TRANSLATE_NOOP("core", "how far the camera has turned to the right, 0 in front"),
    QT_TRANSLATE_NOOP("core", "from the camera to what it looks at"),
    QT_TRANSLATE_NOOP("core", "vertical field of view"),
    QT_TRANSLATE_NOOP("core", "where the light comes from, 0 in front"),
    QT_TRANSLATE_NOOP("core", "how high the light stands"),
    QT_TRANSLATE_NOOP("core", "share of the light that comes from everywhere"),
    QT_TRANSLATE_NOOP("core", "strength of the light"),
    QT_TRANSLATE_NOOP("core", "of the picture"),
    QT_TRANSLATE_NOOP("core", "degrees"),
    QT_TRANSLATE_NOOP("core", "texture widths"),
    QT_TRANSLATE_NOOP("core", "texels"),
    QT_TRANSLATE_NOOP("core", "pixels"),
    QT_TRANSLATE_NOOP("core", "frame"),
    QT_TRANSLATE_NOOP("core", "pyramid"),
    QT_TRANSLATE_NOOP("core", "exact"),
    QT_TRANSLATE_NOOP("core", "conservative"),
    QT_TRANSLATE_NOOP("core", "approximate"),
    QT_TRANSLATE_NOOP("core", "the texel that holds the point"),
    QT_TRANSLATE_NOOP("core", "the four texels around the point, weighted by closeness"),
    QT_TRANSLATE_NOOP("core", "Skips what lies below the ray by the pyramid of maxima; iterative, stackless."),
    QT_TRANSLATE_NOOP("core",
                      "Skips what lies below the ray by the pyramid of maxima; recursive, as the paper tells it."),
    QT_TRANSLATE_NOOP("core",
                      "Tests every cell that the ray crosses, in order: the truth that others are held against."),
    QT_TRANSLATE_NOOP("core", "One sample: the ray is taken to the height found where it enters."),
    QT_TRANSLATE_NOOP("core", "One sample, the shift never longer than the relief is deep."),
    QT_TRANSLATE_NOOP("core", "Equal layers of depth; the first one below the surface."),
    QT_TRANSLATE_NOOP("core", "Equal layers, then a straight line between the last two."),
    QT_TRANSLATE_NOOP("core", "Equal layers, then halving the last one."),
    QT_TRANSLATE_NOOP("core",
                      "One level of the max pyramid marks the segments worth testing; another method works inside them "
                      "and gives its guarantee. It mostly takes more steps than that method alone: compare the two."),
    QT_TRANSLATE_NOOP("core", "Plain texturing: no relief, lit as the polygon is."),
    QT_TRANSLATE_NOOP("core", "The picture stays flat; the light sees the slopes of the heights."),
    QT_TRANSLATE_NOOP(
        "core", "The picture stays flat; the light sees a normal map, the given one or one baked from the heights."),
    QT_TRANSLATE_NOOP("core", "A mesh of triangles at the heights; frames rasterise it with a depth buffer."),
    QT_TRANSLATE_NOOP("core", "many rays a pixel, traced and lit one by one: the picture's truth, slow"),
    QT_TRANSLATE_NOOP("core", "samples"),
    QT_TRANSLATE_NOOP("core", "quads"),
    QT_TRANSLATE_NOOP("core", "along each side of the texture"),
    QT_TRANSLATE_NOOP("core", "Density"),
    QT_TRANSLATE_NOOP(
        "core",
        "base level: above 0, the mean pyramid's level is traced instead of the heights (the last if there are "
        "fewer); auto: the highest whose texels are no wider than the narrowest pixel of the view"),
    QT_TRANSLATE_NOOP("core", "Layers"),
    QT_TRANSLATE_NOOP("core", "Bisections"),
    QT_TRANSLATE_NOOP("core", "Level"),
    QT_TRANSLATE_NOOP("core", "Inner"),
    QT_TRANSLATE_NOOP("core", "Base"),
    QT_TRANSLATE_NOOP("core", "layers"),
    QT_TRANSLATE_NOOP("core", "halvings"),
    QT_TRANSLATE_NOOP("core", "level"),
    QT_TRANSLATE_NOOP("core", "how many the slab is cut into"),
    QT_TRANSLATE_NOOP("core", "of the last layer"),
    QT_TRANSLATE_NOOP("core", "the middle level (the top if there are fewer)"),
    QT_TRANSLATE_NOOP("core", "the method inside the segments; its own options as inner.NAME"),
    QT_TRANSLATE_NOOP(
        "core",
        "Steps to the edge of the cone that the map promises to be empty above each cell; below its apex the "
        "cell is skipped if the ray stays above it, else tested."),
    QT_TRANSLATE_NOOP("core", "azimuth sectors that have slopes of their own"),
    QT_TRANSLATE_NOOP("core", "how cones are stored"),
    QT_TRANSLATE_NOOP("core", "Steps to the edge of the interpolated cone, a fixed number of times."),
    QT_TRANSLATE_NOOP("core", "at most"),
    QT_TRANSLATE_NOOP("core",
                      "Wider cones that the ray may leave below the surface, once; then halving of the last step."),
    QT_TRANSLATE_NOOP("core", "of the last step"),
    QT_TRANSLATE_NOOP("core", "how far cones are looked for"),
    QT_TRANSLATE_NOOP("core", "along which cones are measured"),
    QT_TRANSLATE_NOOP("core", "Sphere tracing by trilinear distances, until the ray is at the surface."),
    QT_TRANSLATE_NOOP(
        "core",
        "Sphere tracing with distances that hold for whole voxels; near the surface the cells themselves are tested."),
    QT_TRANSLATE_NOOP("core", "The papers' refined map as it stands, from sampled rays; overshoots at walls."),
    QT_TRANSLATE_NOOP("core",
                      "Sphere tracing with the larger distances that rays from above may use; safe for whole voxels."),
    QT_TRANSLATE_NOOP("core", "side of a voxel's footprint"),
    QT_TRANSLATE_NOOP("core", "how many voxels the slab is high"),
    QT_TRANSLATE_NOOP("core", "how distances are stored"),
    QT_TRANSLATE_NOOP("core", "elevation of the flattest ray that it serves"),
    QT_TRANSLATE_NOOP("core", "azimuth sectors in which what hides a voxel is looked for"),
    QT_TRANSLATE_NOOP("core", "azimuth sectors that have distances of their own (a divisor of horizons)"),
    QT_TRANSLATE_NOOP("core", "sampled from each voxel"),
    QT_TRANSLATE_NOOP("core", "at most; with stop=never all"),
    QT_TRANSLATE_NOOP("core", "where the march ends: at the surface, where the distance is below `within`, or nowhere"),
    QT_TRANSLATE_NOOP("core", "of stop=distance"),
    QT_TRANSLATE_NOOP("core",
                      "what Euclidean distances are measured to: the surface, or the nearest solid voxel's centre"),
    QT_TRANSLATE_NOOP("core", "the map that it traces with"),
    QT_TRANSLATE_NOOP("core", "a step by the distance: from where the ray leaves the voxel, or from where it is"),
    QT_TRANSLATE_NOOP("core", "map euclidean"),
    QT_TRANSLATE_NOOP("core", "map euclidean-conservative"),
    QT_TRANSLATE_NOOP("core", "map refined-sampled"),
    QT_TRANSLATE_NOOP("core", "map refined"),
    QT_TRANSLATE_NOOP("core", "map cone"),
    QT_TRANSLATE_NOOP("core", "map cone-dummer"),
    QT_TRANSLATE_NOOP("core", "map relaxed-cone"),
    QT_TRANSLATE_NOOP("core", "error against exact"),
    QT_TRANSLATE_NOOP("core", "looking for pixels"),
    QT_TRANSLATE_NOOP("core", "Bilinear"),
    QT_TRANSLATE_NOOP("core", "Columns"),
    QT_TRANSLATE_NOOP("core", "Repeat"),
    QT_TRANSLATE_NOOP("core", "Clamp"),
    QT_TRANSLATE_NOOP("core", "Border"),
    QT_TRANSLATE_NOOP("core", "Floor"),
    QT_TRANSLATE_NOOP("core", "Wall"),
    QT_TRANSLATE_NOOP("core", "Cube"),
    QT_TRANSLATE_NOOP("core", "brick wall in a running bond with deep mortar"),
    QT_TRANSLATE_NOOP("core", "thin needles on a low ground"),
    QT_TRANSLATE_NOOP("core", "square pits in a high plateau"),
    QT_TRANSLATE_NOOP("core", "thin columns on a low ground"),
    QT_TRANSLATE_NOOP("core", "blocks with buildings of different heights"),
    QT_TRANSLATE_NOOP("core", "rough terrain: value noise in octaves"),
    QT_TRANSLATE_NOOP("core", "smooth hills: a few sines"),
    QT_TRANSLATE_NOOP("core", "eight terraces with vertical walls"),
    QT_TRANSLATE_NOOP("core", "blocks of 0 and 1"),
    QT_TRANSLATE_NOOP("core", "two levels of the mean pyramid, by the longer side of the pixel's projection"),
    QT_TRANSLATE_NOOP("core", "all texels in the ellipse of the pixel, weighted by the pixel's own shape"),
    QT_TRANSLATE_NOOP("core", "the same without the texels that the relief hides from the viewer"),
    QT_TRANSLATE_NOOP("core", "how the texels of a footprint are weighed"),
    QT_TRANSLATE_NOOP("core", "of the Gaussian pixel"),
    QT_TRANSLATE_NOOP("core", "of the footprint; 0: what suits the weights"),
    QT_TRANSLATE_NOOP("core", "the level by the footprint's minor axis, or always level 0"),
    QT_TRANSLATE_NOOP("core", "smallest minor semi-axis of the 1-pixel circle on the level chosen"),
    QT_TRANSLATE_NOOP("core", "largest ratio of the axes; longer footprints get wider"),
    QT_TRANSLATE_NOOP("core", "whether the Gaussian makes allowance for the size of texels"),
    QT_TRANSLATE_NOOP("core", "where weights come from: the formula, a table over the distance, a map of the pixel"),
    QT_TRANSLATE_NOOP("core", "of the map of weights along each side; the table has its square"),
    QT_TRANSLATE_NOOP("core",
                      "where in the pixel a texel counts: its place on the plane (the paper's), its own, and with its "
                      "area seen (ours); or what rays through parts of the pixel see, of its own or on a grid that "
                      "neighbours share (ours; grid: the default)"),
    QT_TRANSLATE_NOOP("core",
                      "many pixels at once, of 16-bit levels, where the formula is direct; or one by one in double"),
    QT_TRANSLATE_NOOP("core",
                      "how footprints are computed: each pixel's derivatives in double; or along rows in float "
                      "([TEX]), by differences or by cached squares; slower"),
    QT_TRANSLATE_NOOP("core", "form=rays: through a pixel in which the relief is no plane"),
    QT_TRANSLATE_NOOP("core", "form=grid: looked at for each pixel where the relief is no plane"),
    QT_TRANSLATE_NOOP("core", "samples along each side of a pixel"),
    QT_TRANSLATE_NOOP("core", "what a pixel of the display is: how samples are weighed"),
    QT_TRANSLATE_NOOP("core", "Weights"),
    QT_TRANSLATE_NOOP("core", "Sigma"),
    QT_TRANSLATE_NOOP("core", "Radius"),
    QT_TRANSLATE_NOOP("core", "Levels"),
    QT_TRANSLATE_NOOP("core", "Anisotropy"),
    QT_TRANSLATE_NOOP("core", "Texel size"),
    QT_TRANSLATE_NOOP("core", "Source"),
    QT_TRANSLATE_NOOP("core", "Resolution"),
    QT_TRANSLATE_NOOP("core", "Ellipse"),
    QT_TRANSLATE_NOOP("core", "Form"),
    QT_TRANSLATE_NOOP("core", "Samples"),
    QT_TRANSLATE_NOOP("core", "Pixel model"),
    QT_TRANSLATE_NOOP("core", "cells"),
    QT_TRANSLATE_NOOP("core", "the 8 x 8 example of the max pyramid's paper"),
    QT_TRANSLATE_NOOP("core", "two walls with a trench between them: the example of the refined map's paper"),
    QT_TRANSLATE_NOOP("core", "u, v linear along the row, no perspective: wrong on purpose."),
    QT_TRANSLATE_NOOP("core", "(A x + B y + C) / (G x + H y + I), the denominator made for each of u and v."),
    QT_TRANSLATE_NOOP("core", "(u_t + A n) / (u_b + G n): what does not change along a row once."),
    QT_TRANSLATE_NOOP("core",
                      "w += A, q += G, a denominator for each of u and v. Starts again from an exact value every "
                      "anchor pixels; without that it drifts."),
    QT_TRANSLATE_NOOP("core",
                      "The same with one q for u and v. Starts again from an exact value every anchor pixels; without "
                      "that it drifts."),
    QT_TRANSLATE_NOOP("core",
                      "The same with one 1 / q for u and v. Starts again from an exact value every anchor pixels; "
                      "without that it drifts."),
    QT_TRANSLATE_NOOP("core",
                      "Pixel n from pixel n - k, k streams at once; 2, 4, 8, 16 and 32 run in vector lanes. Starts "
                      "again from an exact value every anchor pixels; without that it drifts."),
    QT_TRANSLATE_NOOP("core",
                      "From both ends of the row to its middle. Starts again from an exact value every anchor pixels; "
                      "without that it drifts."),
    QT_TRANSLATE_NOOP("core",
                      "Interleaved streams, the rows by several threads. Starts again from an exact value every anchor "
                      "pixels; without that it drifts."),
    QT_TRANSLATE_NOOP(
        "core", "A division every m pixels, u and v linear between; m as given, or the longest that keeps an error."),
};

[[maybe_unused]] const char* const kOptions[][2] = {
    QT_TRANSLATE_NOOP3("core", "Floor", "option"),
};

}  // namespace

QString coreText(const std::string& english) {
    return QCoreApplication::translate("core", english.c_str());
}

namespace {

std::string capitalised(const std::string& name) {
    std::string title = name;
    for (char& c : title) {
        if (c == '-' || c == '_') c = ' ';
    }
    if (!title.empty() && title.front() >= 'a' && title.front() <= 'z') title.front() -= 'a' - 'A';
    return title;
}

}  // namespace

QString controlTitle(const std::string& name) {
    return coreText(capitalised(name));
}

QString optionTitle(const std::string& name) {
    // Without a translation of its own it has the word's.
    return QCoreApplication::translate("core", capitalised(name).c_str(), "option");
}

QString unitSuffix(const std::string& unit) {
    if (unit.empty()) return {};
    if (unit == "degrees") return QStringLiteral("°");
    if (unit == "pixels") return QStringLiteral(" px");
    return {};  // stands in the tool tip: the box would be as wide as the panel
}

}  // namespace reliefui
