// Ranges, scales and their legend: properties that hold for any values.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <random>

#include "painting/cell_image.h"
#include "painting/range_legend.h"
#include "workspace/layers.h"

namespace reliefui {

namespace {

// Typical step counts: mostly low, some high, and one extreme value.
std::vector<float> strayValues() {
    std::mt19937 random(7);
    std::vector<float> values;
    for (int i = 0; i < 5000; ++i) values.push_back(static_cast<float>(2 + random() % 30));
    values.push_back(4100);
    return values;
}

ValueSpread spreadOf(const std::vector<float>& values, std::size_t most = ValueSpread::kAll) {
    ValueSpread spread(most);
    for (const float value : values) spread.add(value);
    spread.finish();
    return spread;
}

ColorRange rangeWith(RangeEnds ends, double low, double high, bool logarithmic = false) {
    ColorRange range;
    range.ends = ends;
    range.low = low;
    range.high = high;
    range.logarithmic = logarithmic;
    return range;
}

}  // namespace

TEST(ColorRange, SpreadsCountAsALoopDoes) {
    const std::vector<float> values = strayValues();
    const ValueSpread spread = spreadOf(values);
    for (const double at : {1.5, 7.0, 16.0, 31.0, 4100.0, 5000.0}) {
        EXPECT_EQ(spread.above(at), std::count_if(values.begin(), values.end(), [&](float v) { return v > at; }));
        EXPECT_EQ(spread.between(at, 20),
                  std::count_if(values.begin(), values.end(), [&](float v) { return v >= at && v < 20; }) -
                      std::count_if(values.begin(), values.end(), [&](float v) { return v >= 20 && v < at; }));
    }
    // Subsampled: the extremes are exact, counts approximate.
    const ValueSpread thin = spreadOf(values, 500);
    EXPECT_FALSE(thin.exact());
    EXPECT_EQ(thin.largest(), 4100);
    EXPECT_EQ(thin.count(), spread.count());
    EXPECT_NEAR(static_cast<double>(thin.above(16)), static_cast<double>(spread.above(16)), 500);
}

TEST(ColorRange, PlacesAndValuesAreInverse) {
    for (const bool twoSided : {false, true}) {
        for (const bool logarithmic : {false, true}) {
            ColorScale scale;
            scale.low = logarithmic ? 0.01 : (twoSided ? 0 : -3);
            scale.high = 40;
            scale.logarithmic = logarithmic;
            scale.twoSided = twoSided;
            double before = -HUGE_VAL;
            for (int k = 0; k <= 20; ++k) {
                const double place = k / 20.0;
                const double value = scale.value(place);
                EXPECT_GT(value, before);
                before = value;
                EXPECT_NEAR(scale.place(value), place, 1e-9);
                // The two sides are mirror images.
                if (twoSided) {
                    EXPECT_NEAR(scale.place(-value), 1 - place, 1e-9);
                }
            }
            EXPECT_NEAR(scale.value(1), 40, 1e-9);
        }
    }
}

TEST(ColorRange, EndsAreWhatTheRangeSays) {
    const std::vector<float> values = strayValues();
    const ValueSpread spread = spreadOf(values);
    const ScaleEnds ends{0, spread.largest()};
    EXPECT_EQ(colorScale({}, spread, ends).high, 4100);
    const ColorScale most = colorScale(rangeWith(RangeEnds::Percentile, 0, 99.9), spread, ends);
    EXPECT_EQ(most.low, 0);
    EXPECT_LE(most.high, 31) << "a single outlier does not determine the colours of all others";
    EXPECT_LE(static_cast<double>(spread.above(most.high)), 0.001 * static_cast<double>(spread.count()) + 1);
    const ColorScale own = colorScale(rangeWith(RangeEnds::Own, 5, 9), spread, ends);
    EXPECT_EQ(own.low, 5);
    EXPECT_EQ(own.high, 9);
    // A logarithmic scale needs a first value above 0.
    const ColorScale log = colorScale(rangeWith(RangeEnds::All, 0, 1, true), spread, ends);
    EXPECT_TRUE(log.logarithmic);
    EXPECT_EQ(log.low, 2);
    EXPECT_FALSE(colorScale(rangeWith(RangeEnds::All, 0, 1, true), spreadOf({0, 0}), {0, 0}).logarithmic);
    // Nearly all values are equal; the range must still separate the others.
    EXPECT_EQ(colorScale(rangeWith(RangeEnds::Percentile, 0, 50), spreadOf({0, 0, 0, 0, 3}), {0, 3}).high, 3);
    const ColorScale both =
        colorScale(rangeWith(RangeEnds::Percentile, 0, 50), spreadOf({-8, -1, 0, 1, 2}), {0, 8, true, 0});
    EXPECT_TRUE(both.twoSided);
    EXPECT_EQ(both.high, 1);
}

// Single cells and whole images have the same colours.
TEST(ColorRange, ImagesOfCellsHaveTheColoursOfTheScale) {
    auto values = std::make_shared<relief::FloatImage>(64, 1);
    for (int i = 0; i < 64; ++i)
        (*values)(i, 0) = static_cast<float>(std::pow(10, i / 16.0 - 3) * (i % 3 == 0 ? -1 : 1));
    const Style style;
    for (const ColorMap map : {ColorMap::Count, ColorMap::Difference, ColorMap::Signed}) {
        for (const bool logarithmic : {false, true}) {
            Cells cells;
            cells.values = values;
            cells.map = map;
            cells.scale.low = 0.002;
            cells.scale.high = 5;
            cells.scale.logarithmic = logarithmic;
            cells.scale.twoSided = map != ColorMap::Count;
            cells.scale.threshold = 0.01;
            const CellImage image = cellImage(cells, style);
            for (int i = 0; i < 64; ++i) {
                const Rgba one = style.cell(map, static_cast<double>((*values)(i, 0)), cells.scale);
                const std::uint8_t* const at = &image.rgb[static_cast<std::size_t>(3 * i)];
                EXPECT_NEAR(at[0], one.r, 1) << i;
                EXPECT_NEAR(at[1], one.g, 1) << i;
                EXPECT_NEAR(at[2], one.b, 1) << i;
                const float size = cells.scale.twoSided ? std::abs((*values)(i, 0)) : (*values)(i, 0);
                EXPECT_EQ(one == Style::under(map), size <= 0.01F) << i;
            }
        }
    }
}

// The pixels of a layer have the colours of the bar next to it, up to its ends.
TEST(ColorRange, LayersHaveTheColoursOfTheScale) {
    LayerPicture layer;
    layer.layer = Layer::Steps;
    auto values = std::make_shared<relief::FloatImage>(4, 1);
    for (int x = 1; x < 4; ++x) (*values)(x, 0) = std::ldexp(1.0F, x);
    layer.values = values;
    layer.spread = std::make_shared<const ValueSpread>(spreadOf({0, 2, 4, 8}));
    layer.ends = {0, 8};
    colorLayer(layer, {});
    const Style style;
    for (int x = 0; x < 4; ++x) {
        const Rgba expected = style.cell(colorMapOf(Layer::Steps), static_cast<double>((*values)(x, 0)), layer.scale);
        const QColor seen = layer.image.pixelColor(x, 0);
        EXPECT_NEAR(seen.red(), expected.r, 1) << x;
        EXPECT_NEAR(seen.green(), expected.g, 1) << x;
        EXPECT_NEAR(seen.blue(), expected.b, 1) << x;
    }
}

// The number in a cell is as large as its width and height permit.
TEST(ColorRange, NumbersFitIntoTheirCells) {
    const Style style;
    for (const double width : {20.0, 30.0, 45.0, 80.0}) {
        for (const double height : {20.0, 60.0}) {
            const CellText text = cellText(width, height, style);
            if (text.pixels > 0) {
                EXPECT_TRUE(textFits(text, width, height)) << width << " x " << height;
            }
        }
    }
    EXPECT_EQ(cellText(5, 60, style).pixels, 0);
    EXPECT_GT(cellText(60, 60, style).pixels, 0);
}

// A count of one uses the singular, in English as well.
TEST(ColorRange, OnePixelIsNotOnePixels) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no translations";
    RangedValues values;
    values.name = "steps";
    values.range = standardRange(RangeOf::Steps);
    const auto said = [&](int above) {
        std::vector<float> steps(100, 1);
        std::fill_n(steps.begin(), above, 50.0F);
        values.range.threshold = 20;
        values.spread = std::make_shared<const ValueSpread>(spreadOf(steps));
        values.scale = colorScale(values.range, *values.spread, {0, values.spread->largest()});
        return rangeTexts(values).back();
    };
    EXPECT_NE(said(1).find("1 pixel)"), std::string::npos) << said(1);
    EXPECT_NE(said(2).find("2 pixels)"), std::string::npos) << said(2);
    EXPECT_NE(said(21).find("21 pixels)"), std::string::npos) << said(21);
}

TEST(ColorRange, LegendsSayWhatIsCutOffAndHowMuchIsAboveTheThreshold) {
    RangedValues values;
    values.name = "steps";
    values.range = standardRange(RangeOf::Steps);
    values.range.threshold = 20;
    values.spread = std::make_shared<const ValueSpread>(spreadOf(strayValues()));
    values.scale = colorScale(values.range, *values.spread, {0, values.spread->largest()});
    std::string all;
    for (const std::string& line : rangeTexts(values)) all += line + "\n";
    const auto has = [&](const std::string& part) { return all.find(part) != std::string::npos; };
    EXPECT_TRUE(has("99.9")) << all;
    EXPECT_TRUE(has("4100")) << all;
    EXPECT_TRUE(has(std::to_string(values.spread->above(values.scale.high)))) << all;
    EXPECT_TRUE(has(std::to_string(values.spread->above(20)))) << all;
    // Of a two-sided scale, the threshold cuts off both sides.
    RangedValues both = values;
    both.spread = std::make_shared<const ValueSpread>(spreadOf({-50, -40, -30, -3, 0, 5, 21, 40}));
    both.scale = colorScale(both.range, *both.spread, {0, 50, true, 0});
    EXPECT_NE(rangeTexts(both).back().find("(5 pixel"), std::string::npos) << rangeTexts(both).back();
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    // The numbers stand at the bar's positions of their values.
    const Drawing legend = rangeLegend(values, 400);
    const auto bar = std::find_if(legend.items.begin(), legend.items.end(),
                                  [](const Item& item) { return std::holds_alternative<Cells>(item.primitive); });
    ASSERT_NE(bar, legend.items.end());
    const Cells& cells = std::get<Cells>(bar->primitive);
    EXPECT_EQ(cells.scale, values.scale);
    for (const Item& item : legend.items) {
        const auto* const label = std::get_if<Label>(&item.primitive);
        if (label == nullptr || label->anchor != Anchor::Top) continue;
        const std::string text = labelText(*label, relief::Language::English);
        if (text.find_first_not_of("0123456789.") != std::string::npos) continue;
        EXPECT_NEAR((label->at.x - cells.clip.x0) / cells.clip.width(), values.scale.place(std::stod(text)), 1e-6)
            << text;
    }
    // If there is little width the text is below the bar; nothing is wider than the available width.
    for (const double width : {160.0, 240.0, 400.0}) {
        EXPECT_LE(rangeLegend(values, width).bounds.width(), std::max(width, 210.0));
    }
}

}  // namespace reliefui
