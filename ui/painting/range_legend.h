// Legend of a picture whose colours follow a ColorRange: the colour bar with ticks, the histogram of the values above
// it, and how many values lie beyond its ends and above its threshold. All such legends are made here.
#pragma once

#include "painting/color_range.h"
#include "painting/drawing.h"

namespace reliefui {

enum class Counted : std::uint8_t { Pixels, Texels, Voxels };

// Values shown in colours, and how they are described.
struct RangedValues {
    RangeOf of = RangeOf::Height;
    std::string name;  // quantity and unit, in the style's language
    std::string unit;  // "texels"; empty: a plain number
    Counted counted = Counted::Pixels;
    ColorMap map = ColorMap::Height;
    ColorRange range;
    ColorScale scale;
    std::shared_ptr<const ValueSpread> spread;
    std::int64_t whole = 0;  // total to which shares refer; 0: the number of values
};

// Draws the legend at most `width` points wide, with its upper left corner at (0, 0). The bar has the id
// ItemKind::ColorBar. brief: no histogram, one row if it fits.
Drawing rangeLegend(const RangedValues& values, double width, bool brief = false);
// The lines of text next to the bar: name, range, share beyond it, share up to the threshold.
std::vector<std::string> rangeTexts(const RangedValues& values);

}  // namespace reliefui
