// Weights of a footprint's texels: the weight function over r^2 ([TEX] fig. 3) with each texel on it, and the map of
// weights over the pixel with each texel's position.
#pragma once

#include "painting/drawing.h"
#include "workspace/pixel_footprint.h"

namespace reliefui {

// Returns true if the footprint is an ellipse whose texels were weighted and listed.
bool hasWeights(const PixelFootprint& footprint);

// Draws both plots into a room given in points, side by side or one below the other, depending on its shape. The
// footprint must have weights. Texels' marks have ids of ItemKind::Texel, with i the index in the footprint's list.
Drawing weightDrawing(const PixelFootprint& footprint, const Box& room);
// Rings around the marks of one texel, to be drawn over weightDrawing() in the same room.
Drawing weightHighlight(const PixelFootprint& footprint, const Box& room, std::size_t texel);
// Legend of the marks, at most `width` points wide.
Drawing weightLegend(const PixelFootprint& footprint, double width, relief::Language language);

}  // namespace reliefui
