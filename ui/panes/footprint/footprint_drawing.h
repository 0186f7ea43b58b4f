// A pixel's footprint as a drawing: the texture's texels, the ellipse, its axes and box, each texel's weight as the
// area of a dot, hidden texels crossed out with a line to their occluder; for supersample the hits of its rays. [TEX]
// figs., [ANISO17]. One unit is one texel of the level that is read, unwrapped.
#pragma once

#include <optional>

#include "painting/drawing.h"
#include "workspace/pixel_footprint.h"

namespace reliefui {

struct FootprintOptions {
    int neighbours = 0;  // number of neighbouring pixels whose ellipses are drawn: 0, 4 or 8
    // list derivatives and the ellipse's coefficients in the legend, in figures, which have the room
    bool numbers = false;
    bool weights = true;  // show the weight function and the map of weights, if there are any

    bool operator==(const FootprintOptions&) const = default;
};

// The texture around the footprint. The bounds have this aspect (width / height) and contain the ellipse and everything
// visible. Under steep relief, distant hidden texels also map into the pixel; they lie outside the bounds. beyond:
// additional texture on every side, as a multiple of the bounds' sides, for views that can be moved.
Drawing footprintTexture(const PixelFootprint& footprint, double aspect, double beyond = 0);

// Arguments of the marks. Dots are drawn where they are large enough to be distinguished, so their number depends on
// the visible part. seen: visible part of the drawing; pointsPerTexel: its scale. chosen: texel under the pointer.
struct FootprintMarks {
    Drawing drawing;
    bool weights = true;  // false: too small to be drawn at this scale
};
FootprintMarks footprintMarks(const PixelFootprint& footprint, const FootprintOptions& options, const Box& seen,
                              double pointsPerTexel, std::optional<std::size_t> chosen = {});

// Legend of numbers and marks, at most `width` points wide.
Drawing footprintLegend(const PixelFootprint& footprint, const FootprintOptions& options, bool weights, double width,
                        relief::Language language);

// The ray's hit nearest to the point, at most `reach` texels away; null: there is none.
const RayHit* footprintRayAt(const PixelFootprint& footprint, Point at, double reach);
// Index of the listed texel at the point; the smallest texel if there are several.
std::optional<std::size_t> footprintTexelAt(const PixelFootprint& footprint, Point at);
// Position, in the drawing, at which the texel's line of sight is blocked.
Point blockerPlace(const PixelFootprint& footprint, const relief::FootprintTexel& texel);

}  // namespace reliefui
