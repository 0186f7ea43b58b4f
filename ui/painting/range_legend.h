// The legend of what is shown in colours by a range: the bar with its ticks, the histogram of the values above it, what
// lies beyond its ends and above its threshold. The one place where such a legend is made.
#pragma once

#include "painting/color_range.h"
#include "painting/drawing.h"

namespace reliefui {

enum class Counted : std::uint8_t { Pixels, Texels, Voxels };

// Values shown in colours.
struct RangedValues {
    RangeOf of = RangeOf::Height;
    std::string name;  // what they are, with their unit; in the style's language
    std::string unit;  // "texels"; empty: a plain number
    Counted counted = Counted::Pixels;
    ColorMap map = ColorMap::Height;
    ColorRange range;
    ColorScale scale;
    std::shared_ptr<const ValueSpread> spread;
    std::int64_t whole = 0;  // what shares are of; 0: the values
};

// In at most `width` points, from (0, 0) on. The bar has the id of ItemKind::ColorBar. brief: one row, without the
// histogram.
Drawing rangeLegend(const RangedValues& values, double width, bool brief = false);
// The lines that stand beside the bar: name, range, what is beyond it, what is above the threshold.
std::vector<std::string> rangeTexts(const RangedValues& values);

}  // namespace reliefui
