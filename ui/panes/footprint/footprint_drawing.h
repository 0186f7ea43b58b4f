// A pixel's footprint as a drawing: the texture's texels, the ellipse, its axes and box, each texel's weight as the
// area of a dot, hidden texels crossed out with a line to what hides them; of supersample the hits of its rays. [TEX]
// figs., [ANISO17]. One unit of the drawing is one texel of the level that is read, unwrapped.
#pragma once

#include <optional>

#include "painting/drawing.h"
#include "workspace/pixel_footprint.h"

namespace reliefui {

struct FootprintOptions {
    int neighbours = 0;    // 0, 4 or 8 pixels around, their ellipses
    bool numbers = false;  // derivatives and the ellipse's coefficients in the legend: figures have the room
    bool weights = true;   // beside it the weight function and the map of weights, where there are any

    bool operator==(const FootprintOptions&) const = default;
};

// The texture around the footprint; its bounds fill a room of this shape (width over height) and hold the ellipse and
// what is seen. Under steep relief texels far away fall into the pixel and are hidden: they lie outside. beyond: how
// much more texture there is on every side, of the bounds' sides, for a view that is moved.
Drawing footprintTexture(const PixelFootprint& footprint, double aspect, double beyond = 0);

// Dots are drawn where they are large enough to be told apart, so how much is drawn depends on what is seen.
// seen: the part of the drawing on the screen; pointsPerTexel: its scale. chosen: the texel under the pointer.
struct FootprintMarks {
    Drawing drawing;
    bool weights = true;  // false: too small here to be drawn
};
FootprintMarks footprintMarks(const PixelFootprint& footprint, const FootprintOptions& options, const Box& seen,
                              double pointsPerTexel, std::optional<std::size_t> chosen = {});

// Numbers and signs, in at most `width` points.
Drawing footprintLegend(const PixelFootprint& footprint, const FootprintOptions& options, bool weights, double width,
                        relief::Language language);

// The ray's hit nearest to the point and at most `reach` texels from it; null: there is none.
const RayHit* footprintRayAt(const PixelFootprint& footprint, Point at, double reach);
// The listed texel under the point, the smallest of several.
std::optional<std::size_t> footprintTexelAt(const PixelFootprint& footprint, Point at);
// Where its sight is blocked, on the drawing.
Point blockerPlace(const PixelFootprint& footprint, const relief::FootprintTexel& texel);

}  // namespace reliefui
