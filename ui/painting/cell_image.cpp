#include "painting/cell_image.h"

#include <array>
#include <cmath>

#include "scenario/step_sentence.h"

namespace reliefui {

CellImage cellImage(const Cells& cells, const Style& style, int longest) {
    const CellRange all{0, 0, cells.values->width(), cells.values->height()};
    int step = 1;
    while (std::max(all.i1, all.j1) > longest * step) ++step;
    return cellImage(cells, style, all, step);
}

CellImage cellImage(const Cells& cells, const Style& style, const CellRange& part, int step) {
    constexpr std::size_t kCodes = 1024;
    std::array<Rgba, kCodes> codes;
    for (std::size_t c = 0; c < kCodes; ++c) {
        codes[c] = style.mapped(cells.map, static_cast<double>(c) / (kCodes - 1));
    }
    const relief::FloatImage& values = *cells.values;
    CellImage image;
    image.i0 = part.i0;
    image.j0 = part.j0;
    image.step = step;
    image.width = (part.i1 - part.i0 + step - 1) / step;
    image.height = (part.j1 - part.j0 + step - 1) / step;
    image.rgb.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
    const ColorScale& scale = cells.scale;
    // Non-linear scales and marks are mapped value by value, without the table.
    const bool straight = scale.high > scale.low && !scale.logarithmic && !scale.twoSided;
    const auto factor = static_cast<float>((kCodes - 1) / (straight ? scale.high - scale.low : 1));
    const auto low = static_cast<float>(scale.low);
    std::uint8_t* out = image.rgb.data();
    for (int y = 0; y < image.height; ++y) {
        const auto row = values.row(image.j0 + y * image.step);
        for (int x = 0; x < image.width; ++x) {
            const float value = row[static_cast<std::size_t>(image.i0 + x * image.step)];
            const auto exact = static_cast<double>(value);
            const bool mark = std::isnan(value) || (cells.map == ColorMap::Distance && value < 0);
            const bool special = cells.map == ColorMap::Picture || mark || scale.under(exact);
            const float code =
                straight ? (value - low) * factor : static_cast<float>(scale.place(exact)) * (kCodes - 1.0F);
            const Rgba color = special ? style.cell(cells.map, exact, scale)
                                       : codes[static_cast<std::size_t>(std::clamp(code + 0.5F, 0.0F, kCodes - 1.0F))];
            *out++ = color.r;
            *out++ = color.g;
            *out++ = color.b;
        }
    }
    return image;
}

namespace {

constexpr double kDigitWidth = 0.64;  // width of a DejaVu Sans digit, in ems

}  // namespace

CellText cellText(double cellWidth, double cellHeight, const Style& style) {
    constexpr double kSmallest = 0.72;  // times the text size
    constexpr double kLargest = 1.7;
    CellText text;
    const auto fitting = [&](int characters) {
        return std::min(cellWidth * 0.84 / (characters * kDigitWidth), cellHeight * 0.45);
    };
    if (fitting(5) >= style.textPixels(1.0)) text.decimals = 3;
    const double pixels = std::min(fitting(text.decimals + 2), style.textPixels(kLargest));
    if (pixels >= style.textPixels(kSmallest)) text.pixels = pixels;
    return text;
}

bool textFits(const CellText& text, double width, double height) {
    return text.pixels > 0 && width >= text.characters() * kDigitWidth * text.pixels && height >= 1.1 * text.pixels;
}

namespace {

// All cells of a grid of distances or slopes are printed with the same number of decimals, which gives the largest
// value about three significant figures.
CellText measuredText(const Cells& cells, double scale, const Style& style) {
    CellText text;
    const double high = cells.scale.high;
    text.digits = high >= 10 ? 2 : 1;
    text.decimals = high >= 10 ? 1 : (high >= 1 ? 2 : 3);
    // A logarithmic scale is chosen to show small values, so these get one more decimal.
    if (cells.scale.logarithmic) text.decimals = std::min(text.decimals + 1, 4);
    text.sign = cells.scale.twoSided;
    const double pixels = std::min({cells.cellWidth * scale * 0.84 / (text.characters() * kDigitWidth),
                                    cells.cellHeight * scale * 0.45, style.textPixels(1.7)});
    constexpr double kSmallest = 0.6;  // times the text size
    if (pixels >= style.textPixels(kSmallest)) text.pixels = pixels;
    return text;
}

}  // namespace

CellText cellText(const Cells& cells, const CellRange& range, double scale, const Style& style) {
    if (!cells.print || cells.cellHeight * scale < cells.printFrom * style.pixelsPerPoint()) return {};
    if (cells.map == ColorMap::Distance || cells.map == ColorMap::Difference) return measuredText(cells, scale, style);
    const CellText text = cellText(cells.cellWidth * scale, cells.cellHeight * scale, style);
    // Numbers with a single decimal may be set smaller: they have fewer digits to read, and cells in a narrow column
    // need it.
    constexpr double kSmallest = 0.5;  // times the text size; this gives 5 pt in print
    CellText single;
    single.decimals = 1;
    const double pixels = std::min({cells.cellWidth * scale * 0.84 / (single.characters() * kDigitWidth),
                                    cells.cellHeight * scale * 0.45, style.textPixels(1.7)});
    if (pixels < style.textPixels(kSmallest)) return text;
    single.pixels = pixels;
    for (int j = range.j0; j < range.j1; ++j) {
        for (int i = range.i0; i < range.i1; ++i) {
            const float value = (*cells.values)(i, j);
            if (static_cast<float>(std::round(static_cast<double>(value) * 10) / 10) != value) return text;
        }
    }
    return single;
}

std::string cellValueText(const Cells& cells, float value, const CellText& text) {
    const bool mark = std::isnan(value) || (cells.map == ColorMap::Distance && value < 0);
    if (mark) return {};
    return relief::fixedText(static_cast<double>(value), text.decimals);
}

}  // namespace reliefui
