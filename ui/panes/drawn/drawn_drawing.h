// A relief edited by hand, texel by texel: a grid of heights seen from above, or its profile; and the chosen ray.
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
    std::optional<std::pair<int, int>> chosen;  // chosen texel; in a profile the column, with row 0
    // There is a ray of the chosen pixel, traced on this very relief.
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
};

struct DrawnPicture {
    Drawing drawing;
    Box body;  // box of the grid, or of the profile's plot: height 0 at the bottom, 1 at the top
    bool profile = false;
};

// aspect: height / width of the available room. An empty relief gives an empty picture.
DrawnPicture drawnPicture(const DrawnSource& source, double aspect);
Drawing drawnLegend(const DrawnSource& source, double width, relief::Language language);

// The texel at a point of the drawing; in a profile its column, with row 0.
std::optional<std::pair<int, int>> drawnTexelAt(const DrawnPicture& picture, const relief::DrawnRelief& relief,
                                                Point at);
// The height at a point of a profile's plot, in [0, 1].
double drawnHeightAt(const DrawnPicture& picture, Point at);

}  // namespace reliefui
