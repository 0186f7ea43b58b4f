// Axes, legend and strips of single pixels of the rows pane.
#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "panes/rows/rows_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::RowCurve;

constexpr double kPlate = 17;

Message titleOf(const RowsData& data) {
    double low = 0;
    double high = 0;
    for (const double q : data.row.q) {
        if (std::isnan(q)) continue;
        low = high == 0 ? q : std::min(low, q);
        high = std::max(high, q);
    }
    return Message(MessageId::DrawRowTitle, {{"y", data.place.line},
                                             {"pixels", data.row.span.size()},
                                             {"width", data.place.width},
                                             {"precision", data.inDouble ? "double" : "float"},
                                             {"q", relief::numberText(high > 0 ? low / high : 0, 2)}});
}

std::string countText(double count) {
    return relief::numberText(count, 3);
}

Message curveText(const RowsData& data, std::size_t c) {
    const RowCurve& curve = data.row.curves[c];
    const std::string& name = data.names[c];
    if (curve.valid.empty()) return Message(MessageId::DrawRowCurveNone, {{"name", name}});
    const relief::PixelCounts& counts = data.counts[c];
    Message text(MessageId::DrawRowCurve, {{"name", name},
                                           {"mul", countText(counts.mul)},
                                           {"add", countText(counts.add)},
                                           {"div", countText(counts.div)},
                                           {"worst", relief::numberText(curve.worst, 3)}});
    const bool spans = curve.options.variant == relief::RowVariant::Subspan;
    const std::int64_t every = spans ? curve.options.span : curve.anchor;
    if (every == 0) return text;
    text.id = MessageId::DrawRowCurveEvery;
    text.values.push_back({"every", every});
    return text;
}

void addStripTitle(Drawing& drawing, const RowsData& data, const RowsFrame& frame, std::size_t s) {
    const std::size_t c = frame.stripCurves[s];
    const Box& strip = frame.strips[s];
    constexpr double kNumberRoom = 16;
    Message title(MessageId::DrawRowStrip,
                  {{"name", data.names[c]}, {"from", frame.lens.begin}, {"to", frame.lens.end - 1}});
    const double size = chart::fittingSize(chart::widthOf(title), strip.width() - kNumberRoom);
    drawing.add({}, Role::Legend,
                Label{.at = {strip.x0, strip.y0},
                      .text = std::move(title),
                      .anchor = Anchor::BottomLeft,
                      .size = size,
                      .offset = {kNumberRoom, -1}});
    addCurveNumber(drawing, {strip.x0, strip.y0}, c, {0, -1}, Anchor::BottomLeft);
}

}  // namespace

void addStrips(Drawing& drawing, const RowsData& data, const RowsFrame& frame) {
    if (frame.lens.empty()) return;
    for (std::size_t s = 0; s < frame.strips.size(); ++s) {
        const RowCurve& curve = data.row.curves[frame.stripCurves[s]];
        const Box& strip = frame.strips[s];
        const double side = strip.width() / static_cast<double>(frame.lens.size());
        addStripTitle(drawing, data, frame, s);
        for (std::int64_t pixel = frame.lens.begin; pixel < frame.lens.end; ++pixel) {
            if (pixel < curve.valid.begin || pixel >= curve.valid.end) continue;
            const double x = strip.x0 + side * static_cast<double>(pixel - frame.lens.begin);
            const Box box{x, strip.y0, x + side, strip.y1};
            const std::int32_t stream = curve.stream[static_cast<std::size_t>(pixel - data.row.span.begin)];
            const LevelTint tint{stream, 1};
            drawing.add({}, Role::Stream, Rectangle{box.grown(-0.5), true, 1, 0}, Emphasis::Strong, tint);
            if (std::binary_search(curve.exact.begin(), curve.exact.end(), pixel)) {
                drawing.add({}, Role::Highlight, Rectangle{box, false, 0.8, 0});
            }
            if (streamsOf(curve) < 2) continue;
            // Without a halo: neighbouring plates of the same colour may touch.
            drawing.add({}, Role::Stream,
                        Label{.at = box.center(),
                              .text = plainText(std::to_string(stream)),
                              .anchor = Anchor::Center,
                              .size = 0.62,
                              .plate = true,
                              .room = box.grown(2.5)},
                        Emphasis::Normal, tint);
        }
        const double chosen = strip.x0 + side * (static_cast<double>(data.place.chosen - frame.lens.begin) + 0.5);
        if (data.place.chosen >= frame.lens.begin && data.place.chosen < frame.lens.end) {
            drawing.add({}, Role::Hit, Marker{{chosen, strip.y1 + 4}, Shape::TriangleUpHollow, 5});
        }
    }
}

Drawing rowsAxes(const RowsData& data, const RowsFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    const chart::Axes upper(drawing, frame.upper, frame.whole);
    const chart::Axes lower(drawing, frame.lower, frame.whole);
    upper.corner(Message(MessageId::DrawRowTexels));
    lower.corner(Message(MessageId::DrawRowError));
    // Uses the whole title, or its first part if it would overlap the text at the left, as large as possible.
    const double least = 0.75 * chart::kTextSize;
    for (const auto& [part, size] : {std::pair(-1, chart::kTextSize), {0, chart::kTextSize}, {0, least}}) {
        drawing.add({}, Role::Legend,
                    Label{.at = {frame.upper.x1, frame.upper.y0},
                          .text = titleOf(data),
                          .anchor = Anchor::Right,
                          .size = size,
                          .offset = {0, -9},
                          .yields = true,
                          .part = part});
    }
    upper.left(frame.texels(), true);
    lower.left(frame.errors(), true);
    for (const chart::Axes& axes : {upper, lower}) axes.sides();
    lower.below(frame.pixels(), Message(MessageId::DrawRowPixels));
    for (const chart::Tick& tick : chart::ticks(frame.pixels(), chart::Side::Below)) {
        chart::line(drawing, {tick.at, frame.upper.y1}, {tick.at, frame.upper.y1 + chart::kTick});
    }
    return drawing;
}

Drawing rowsLegend(const RowsData& data, double width, relief::Language language, RowsLegend legend) {
    LegendRows rows(width, language);
    bool exact = false;
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        const Message text = legend == RowsLegend::Names ? plainText(data.names[c]) : curveText(data, c);
        rows.sign(Role::Series,
                  Label{.text = plainText(std::to_string(c + 1)),
                        .anchor = Anchor::Center,
                        .size = chart::kTextSize,
                        .plate = true},
                  text, {static_cast<int>(c), 1}, Emphasis::Normal, kPlate);
        exact = exact || !data.row.curves[c].exact.empty();
    }
    if (legend != RowsLegend::Whole) return rows.take();
    if (exact) rows.sign(Role::Highlight, Marker{{}, Shape::Bar, 6}, Message(MessageId::DrawRowExact));
    if (data.affine) {
        const std::string share = relief::numberText(100 * data.affine->share, 2);
        rows.sign(Role::Highlight, Marker{{}, Shape::SquareHollow, 7},
                  Message(MessageId::DrawRowClosedForm, {{"share", share}}));
    }
    return rows.take();
}

}  // namespace reliefui
