// How the filter weighs the texels of a footprint: the weight function over r^2 ([TEX] fig. 3) with each texel on it,
// and the map of weights over the pixel with each texel's place in it.
#pragma once

#include "painting/drawing.h"
#include "workspace/pixel_footprint.h"

namespace reliefui {

// Whether the footprint is an ellipse whose texels were weighed and listed.
bool hasWeights(const PixelFootprint& footprint);

// In a room of points; beside each other, or one below the other, as it is shaped. Of a footprint that has weights.
// Texels' marks have the id of a texel whose i is their number in the footprint's list.
Drawing weightDrawing(const PixelFootprint& footprint, const Box& room);
// Rings around the marks of one of them, over the drawing in the same room.
Drawing weightHighlight(const PixelFootprint& footprint, const Box& room, std::size_t texel);
// What its signs are, in at most `width` points.
Drawing weightLegend(const PixelFootprint& footprint, double width, relief::Language language);

}  // namespace reliefui
