// The rows pane: its data against closed forms, and its drawing.
#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <QTranslator>

#include "chart_laws.h"
#include "measuring/bench/bench_rows.h"
#include "painting/style.h"
#include "panes/rows/row_flow.h"
#include "panes/rows/rows_drawing.h"
#include "relief/errors.h"

namespace reliefui {

namespace {

RowsPlace wallPlace(std::int64_t width, double elevation) {
    RowsPlace place;
    place.map = relief::obliqueWall(4096, width, elevation);
    place.y = relief::wallRows(width, 3, elevation).firstY;
    place.span = {0, width};
    place.width = width;
    place.chosen = width / 3;
    return place;
}

RowsData dataOf(const RowsPlace& place, const std::vector<std::string>& methods, bool inDouble = false) {
    RowsOptions options;
    options.methods = methods;
    return rowsData(place, rowMethods(options, "test"), inDouble);
}

std::vector<Item> itemsOf(const Drawing& drawing, Role role) {
    std::vector<Item> items;
    for (const Item& item : drawing.items) {
        if (item.role == role) items.push_back(item);
    }
    return items;
}

TEST(Rows, AffineIsWorstWhereTheClosedFormSays) {
    for (const double elevation : {60.0, 25.0, 8.0}) {
        const RowsData data = dataOf(wallPlace(3840, elevation), {"affine"}, true);
        ASSERT_TRUE(data.affine);
        const relief::RowCurve& curve = data.row.curves[0];
        // Pixels are at most half a pixel from the true position, where the error is flat.
        EXPECT_NEAR(static_cast<double>(curve.worstPixel) + 0.5, data.affine->x, 1);
        EXPECT_NEAR(curve.worst, data.affine->error, 1e-5 * data.affine->error);
        const auto [low, high] = std::minmax_element(data.row.q.begin(), data.row.q.end());
        const double root = std::sqrt(*high / *low);
        EXPECT_NEAR(data.affine->share, (root - 1) / (root + 1), 1e-12);
        const double change = std::abs(data.row.u.back() - data.row.u.front());
        EXPECT_NEAR(curve.worst / change, data.affine->share, 1e-4);

        // The mark is drawn there.
        const RowsFrame frame = rowsFrame(data, {}, {}, 640, 400);
        const auto marks = itemsOf(rowsPlots(data, frame), Role::Highlight);
        ASSERT_EQ(marks.size(), 1u);
        const Point at = std::get<Marker>(marks[0].primitive).at;
        EXPECT_NEAR(frame.pixelAt(at.x), data.affine->x, 1e-6);
        EXPECT_NEAR(at.y, frame.errorAt(curve.worst), 0.01);

        // The curve's number stands there, also if that is the first or the last visible pixel.
        const auto worst = static_cast<double>(curve.worstPixel);
        for (const double from : {worst, worst - 19}) {
            const RowsFrame near = rowsFrame(data, {}, {from, from + 20}, 640, 400);
            int numbers = 0;
            for (const Item& item : itemsOf(rowsPlots(data, near), Role::Series)) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label == nullptr || label->at.y < near.lower.y0) continue;
                EXPECT_NEAR(near.pixelAt(label->at.x), worst + 0.5, 1e-6);
                ++numbers;
            }
            EXPECT_EQ(numbers, 1) << from - worst;
        }
    }
}

TEST(Rows, AnchoredRowsStayBelowAWeightAndTheOthersDrift) {
    const RowsData data = dataOf(wallPlace(65536, 8), {"incremental", "streams:streams=4", "incremental:anchor=0"});
    EXPECT_LT(data.row.curves[0].worst, relief::kAnchorError);
    EXPECT_LT(data.row.curves[1].worst, relief::kAnchorError);
    EXPECT_GT(data.row.curves[2].worst, 100 * relief::kAnchorError);
    RowsOptions options;
    for (const bool logarithmic : {true, false}) {
        options.logarithmic = logarithmic;
        const RowsFrame frame = rowsFrame(data, options, {}, 640, 400);
        const double weight = frame.errorAt(relief::kAnchorError);
        // The curves of the first variant and of the streams are below the line of 1/256; that of the last variant is
        // not.
        double highest[3] = {1e9, 1e9, 1e9};
        int streams = 0;
        for (const Item& item : rowsPlots(data, frame).items) {
            const auto* line = std::get_if<Polyline>(&item.primitive);
            if (line == nullptr || line->points.front().y < frame.lower.y0) continue;
            if (item.role != Role::Series && item.role != Role::Stream) continue;
            const int curve = item.role == Role::Stream ? 1 : item.tint.level;
            streams += item.role == Role::Stream ? 1 : 0;
            for (const Point& p : line->points) {
                highest[curve] = std::min(highest[curve], p.y);
                EXPECT_GE(p.y, frame.lower.y0 - 1e-9);
                EXPECT_LE(p.y, frame.lower.y1 + 1e-9);
            }
        }
        EXPECT_EQ(streams, 4) << "a line each";
        EXPECT_GT(highest[0], weight);
        EXPECT_GT(highest[1], weight);
        EXPECT_LT(highest[2], weight);
    }
}

TEST(Rows, ScalesAreWhatTheAxesSay) {
    const RowsData data = dataOf(wallPlace(3840, 25), {"affine", "direct"});
    RowsOptions options;
    const RowsFrame decades = rowsFrame(data, options, {}, 640, 400);
    EXPECT_LE(data.row.curves[0].worst, std::pow(10, decades.errorHigh));
    EXPECT_NEAR(decades.errorAt(std::pow(10, decades.errorHigh)), decades.lower.y0, 1e-9);
    const double decade = decades.lower.height() / (decades.errorHigh - decades.errorLow);
    EXPECT_NEAR(decades.errorAt(1), decades.lower.y0 + decades.errorHigh * decade, 1e-9);
    EXPECT_NEAR(decades.errorAt(0.01), decades.errorAt(1) + 2 * decade, 1e-9);
    EXPECT_EQ(decades.errorAt(0), decades.lower.y1);
    for (const Box& plot : {decades.upper, decades.lower}) {
        const RowsReading at = rowsReading(data, decades, {decades.xAt(1000.5), plot.center().y});
        EXPECT_TRUE(at.inside && at.curve);
        EXPECT_EQ(at.pixel, 1000);
    }
    EXPECT_FALSE(rowsReading(data, decades, {decades.upper.x0 - 1, decades.upper.y0 - 1}).inside);
    options.logarithmic = false;
    const RowsFrame linear = rowsFrame(data, options, {}, 640, 400);
    EXPECT_EQ(linear.errorAt(0), linear.lower.y1);
    EXPECT_NEAR(linear.errorAt(linear.errorHigh / 4), linear.lower.y1 - linear.lower.height() / 4, 1e-9);
}

// Without pixels or without errors, every place and every error still has its position.
TEST(Rows, NothingHasScalesToo) {
    RowsOptions options;
    options.logarithmic = false;
    RowsData none;
    none.row.span = {5, 5};
    const RowsFrame frame = rowsFrame(none, options, {}, 640, 400);
    EXPECT_EQ(frame.xAt(5), frame.upper.x0);
    EXPECT_EQ(frame.xAt(6), frame.upper.x1);
    EXPECT_EQ(frame.errorAt(0), frame.lower.y1);
    EXPECT_LT(frame.errorAt(relief::kAnchorError), frame.lower.y1);
}

TEST(Rows, StreamsHaveTheirColours) {
    const RowsData data = dataOf(wallPlace(640, 25), {"streams:streams=4", "opposed"});
    const RowsFrame frame = rowsFrame(data, {}, {100, 130}, 640, 400);
    ASSERT_EQ(frame.lens, (relief::PixelSpan{100, 130}));
    ASSERT_EQ(frame.strips.size(), 2u);
    std::map<int, int> boxes;
    for (const Item& item : itemsOf(rowsPlots(data, frame), Role::Stream)) {
        const auto* box = std::get_if<Rectangle>(&item.primitive);
        if (box == nullptr) continue;
        const Point middle = box->box.center();
        const RowsReading at = rowsReading(data, frame, middle);
        ASSERT_TRUE(at.inside && at.curve);
        const std::int64_t anchor = data.row.curves[0].anchor;
        if (*at.curve == 0) {
            const std::int64_t n = anchor > 0 ? at.pixel % anchor : at.pixel;
            EXPECT_EQ(item.tint.level, n % 4) << at.pixel;
        } else {
            EXPECT_EQ(item.tint.level, at.pixel < 320 ? 0 : 1);
        }
        ++boxes[static_cast<int>(*at.curve)];
    }
    EXPECT_EQ(boxes[0], 30);
    EXPECT_EQ(boxes[1], 30);
    // Neighbours are distinguishable in either theme.
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        Style style;
        style.theme = theme;
        for (int s = 0; s < 4; ++s) EXPECT_NE(style.stream(s), style.stream(s + 1));
        for (int s = 0; s < 3; ++s) EXPECT_NE(style.series(s), style.series(s + 1));
    }
}

TEST(Rows, AWiderPictureHasTheSameCoordinates) {
    const RowsPlace place = wallPlace(640, 25);
    const RowsPlace wide = widened(place, 65536);
    EXPECT_EQ(wide.span, (relief::PixelSpan{0, 65536}));
    const double scale = 65536.0 / 640;
    for (const double x : {0.5, 200.25, 639.5}) {
        const relief::TexelPoint a = place.map.at(x, place.y);
        const relief::TexelPoint b = wide.map.at(x * scale, place.y);
        EXPECT_NEAR(a.s, b.s, 1e-8);
        EXPECT_NEAR(a.t, b.t, 1e-8);
    }
    EXPECT_NEAR(static_cast<double>(wide.chosen) / scale, static_cast<double>(place.chosen) + 0.5, 1);
}

TEST(Rows, CountsAreThePapers) {
    const RowsData data = dataOf(wallPlace(640, 60), {"affine", "direct", "incremental:anchor=0", "streams:anchor=0"});
    const double expected[4][3] = {{0, 2, 0}, {8, 8, 2}, {0, 4, 2}, {0, 3, 2}};
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_EQ(data.counts[c].mul, expected[c][0]);
        EXPECT_EQ(data.counts[c].add, expected[c][1]);
        EXPECT_EQ(data.counts[c].div, expected[c][2]);
    }
    // Their curves are numbered from 1, in the legend as in the plots.
    std::string numbers;
    for (const Item& item : rowsLegend(data, 500, relief::Language::English).items) {
        const auto* const label = std::get_if<Label>(&item.primitive);
        if (label != nullptr && label->plate) numbers += labelText(*label, relief::Language::English);
    }
    EXPECT_EQ(numbers, "1234");
}

TEST(Rows, TheVariantsAreDescribedInUkrainian) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/translations/reliefscope_uk.qm")));
    for (const relief::RowMethodDescription& method : relief::rowMethodList()) {
        if (!std::holds_alternative<relief::RowVariant>(method.kind)) continue;
        EXPECT_FALSE(translator.translate("core", method.help.c_str()).isEmpty()) << method.help;
    }
}

TEST(Rows, WhatIsNoRowVariantIsRefused) {
    for (const char* const name : {"fill", "derivatives-direct", "nonsense", "streams:streams=0", "affine:anchor=3"}) {
        RowsOptions options;
        options.methods = {name};
        EXPECT_THROW(rowMethods(options, "test"), relief::InputError) << name;
    }
    RowsOptions options;
    options.methods.assign(kMostRowCurves + 1, "affine");
    EXPECT_THROW(rowMethods(options, "test"), relief::InputError);
}

TEST(Rows, EveryVariantIsDrawnWithinThePlots) {
    for (int v = 0; v < relief::kRowVariants; ++v) {
        const std::string name(relief::rowVariantName(static_cast<relief::RowVariant>(v)));
        for (const std::int64_t width : {std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, std::int64_t{700}}) {
            for (const bool inDouble : {false, true}) {
                const RowsData data = dataOf(wallPlace(width, 8), {name}, inDouble);
                const RowsFrame frame = rowsFrame(data, {}, {}, 500, 300);
                for (const Item& item : rowsPlots(data, frame).items) {
                    const auto* line = std::get_if<Polyline>(&item.primitive);
                    if (line == nullptr) continue;
                    for (const Point& p : line->points) {
                        EXPECT_TRUE(frame.whole.contains(p)) << name << " " << width << " " << p.x << " " << p.y;
                    }
                }
                EXPECT_FALSE(rowsLegend(data, 500, relief::Language::English).items.empty());
                // The shortest legend still names all variants, in one or two lines.
                const Drawing names = rowsLegend(data, 500, relief::Language::English, RowsLegend::Names);
                EXPECT_EQ(names.items.size(), 2 * data.names.size());
                EXPECT_LE(names.bounds.height(), 40);
                for (const auto& [w, h] : {std::pair(500.0, 300.0), {226.0, 176.0}, {226.0, 120.0}}) {
                    const Drawing axes = rowsAxes(data, rowsFrame(data, {}, {}, w, h));
                    EXPECT_GT(axes.items.size(), 6u);
                    expectWordsInside(axes);
                }
            }
        }
    }
}

// Where each pixel of the diagram gets its numbers from: this many pixels away; "c" is from the coefficients, "u" by
// steps of u.
std::string sourcesOf(const RowsData& data) {
    std::string text;
    for (const RowFlowPixel& pixel : rowFlow(data.row.curves[0])) {
        const std::string from = pixel.from ? std::to_string(*pixel.from - pixel.pixel) : "c";
        text += (text.empty() ? "" : " ") + from + (pixel.divides ? "" : "u");
    }
    return text;
}

TEST(Rows, TheDiagramSaysWhatAVariantComputes) {
    const RowsPlace place = wallPlace(8, 25);
    for (const auto& [variant, sources] :
         std::map<std::string, std::string>{{"direct", "c c c c c c c c"},
                                            {"row-constant", "c c c c c c c c"},
                                            {"incremental:anchor=0", "c -1 -1 -1 -1 -1 -1 -1"},
                                            {"incremental-shared:anchor=3", "c -1 -1 c -1 -1 c -1"},
                                            {"streams:streams=2:anchor=0", "c c -2 -2 -2 -2 -2 -2"},
                                            {"streams:streams=3:anchor=6", "c c c -3 -3 -3 c c"},
                                            {"opposed:anchor=0", "c -1 -1 -1 1 1 1 c"},
                                            {"affine", "c -1u -1u -1u -1u -1u -1u -1u"},
                                            {"subspan:span=4", "c -1u -1u -1u c -1u -1u c"}}) {
        EXPECT_EQ(sourcesOf(dataOf(place, {variant})), sources) << variant;
    }
    // Of a long row the beginning, or both ends.
    EXPECT_EQ(sourcesOf(dataOf(wallPlace(3840, 25), {"opposed:anchor=0"})), "c -1 -1 -1 1 1 1 c");
    EXPECT_EQ(rowFlow(dataOf(wallPlace(3840, 25), {"direct"}).row.curves[0]).back().pixel, 7);

    // The numbers drawn are those that the variant computed, and nothing is wider than the page.
    const RowsData data = dataOf(place, {"row-constant", "opposed:anchor=0"});
    const Drawing drawing = rowFlowDrawing(data, 220);
    for (const relief::RowCurve& curve : data.row.curves) {
        for (const double u : curve.u) {
            EXPECT_TRUE(std::any_of(drawing.items.begin(), drawing.items.end(), [&](const Item& item) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                return label != nullptr && labelText(*label, relief::Language::English) == relief::numberText(u, 3);
            })) << u;
        }
    }
    for (const Item& item : drawing.items) {
        if (const auto* const box = std::get_if<Rectangle>(&item.primitive)) {
            EXPECT_TRUE(drawing.bounds.contains({box->box.x0, box->box.y0}));
            EXPECT_TRUE(drawing.bounds.contains({box->box.x1, box->box.y1}));
        }
    }
}

}  // namespace

}  // namespace reliefui
