// A relief drawn by hand, texel by texel: a grid of heights as seen from above, or its profile; and the chosen ray.
#pragma once

#include <optional>

#include "images/drawn_relief.h"
#include "painting/drawing.h"
#include "relief/height_field.h"
#include "relief/ray.h"

namespace reliefui {

struct DrawnSource {
    relief::DrawnRelief relief;
    relief::Surface surface = relief::Surface::Bilinear;
    relief::Address address = relief::Address::Repeat;
    std::optional<std::pair<int, int>> chosen;  // texel; of a profile the column, row 0
    // Of the chosen pixel; on this very relief.
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
};

struct DrawnPicture {
    Drawing drawing;
    Box body;  // the grid, or the plot of the profile: height 0 at its lower side, 1 at its upper one
    bool profile = false;
};

// aspect: height over width of the room. An empty relief gives an empty picture.
DrawnPicture drawnPicture(const DrawnSource& source, double aspect);
Drawing drawnLegend(const DrawnSource& source, double width, relief::Language language);

// The texel under a point of the drawing, of a profile its column and row 0.
std::optional<std::pair<int, int>> drawnTexelAt(const DrawnPicture& picture, const relief::DrawnRelief& relief,
                                                Point at);
// The height that a point of a profile's plot stands for, in [0, 1].
double drawnHeightAt(const DrawnPicture& picture, Point at);

}  // namespace reliefui
