// Axes, legend and the pixels one by one of the rows pane.
#include <algorithm>
#include <cmath>

#include "painting/axis_ticks.h"
#include "painting/legend_rows.h"
#include "panes/rows/rows_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::RowCurve;

constexpr double kTextSize = 0.8;
constexpr double kTick = 3;  // points
constexpr double kPlate = 17;

void addText(Drawing& drawing, Point at, Message text, Anchor anchor, Point offset, bool yields = false) {
    Label label;
    label.at = at;
    label.text = std::move(text);
    label.anchor = anchor;
    label.size = kTextSize;
    label.offset = offset;
    label.yields = yields;
    drawing.add({}, Role::Legend, std::move(label));
}

void addLine(Drawing& drawing, Point from, Point to, Role role = Role::Frame) {
    drawing.add({}, role, Polyline{{from, to}, false});
}

void addSide(Drawing& drawing, const Box& plot, double y, std::string text) {
    addLine(drawing, {plot.x0, y}, {plot.x1, y}, Role::Grid);
    addLine(drawing, {plot.x0 - kTick, y}, {plot.x0, y});
    addText(drawing, {plot.x0, y}, plainText(std::move(text)), Anchor::Right, {-kTick - 2, 0});
}

void addTexels(Drawing& drawing, const RowsFrame& frame) {
    constexpr double kApart = 22;
    const double step = niceStep(frame.high - frame.low, frame.upper.height() / kApart);
    for (const double texel : ticks(frame.low, frame.high, step)) {
        addSide(drawing, frame.upper, frame.yAt(texel), tickText(texel, step));
    }
}

void addErrorSide(Drawing& drawing, const RowsFrame& frame) {
    constexpr double kApart = 16;
    const double range = frame.errorHigh - frame.errorLow;
    if (!frame.logarithmic) {
        const double step = niceStep(range, frame.lower.height() / kApart);
        for (const double error : ticks(0, frame.errorHigh, step)) {
            addSide(drawing, frame.lower, frame.errorAt(error), tickText(error, step));
        }
        return;
    }
    const int every = std::max(1, static_cast<int>(std::ceil(range * kApart / frame.lower.height())));
    for (int n = static_cast<int>(frame.errorHigh); n >= static_cast<int>(frame.errorLow); n -= every) {
        addSide(drawing, frame.lower, frame.errorAt(std::pow(10.0, n)), powerOfTen(n));
    }
}

void addFrame(Drawing& drawing, const Box& plot) {
    addLine(drawing, {plot.x0, plot.y0}, {plot.x0, plot.y1});
    addLine(drawing, {plot.x0, plot.y1}, {plot.x1, plot.y1});
}

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
    addText(drawing, {strip.x0, strip.y0},
            Message(MessageId::DrawRowStrip,
                    {{"name", data.names[c]}, {"from", frame.lens.begin}, {"to", frame.lens.end - 1}}),
            Anchor::BottomLeft, {16, -1});
    Label label;
    label.at = {strip.x0, strip.y0};
    label.text = plainText(std::to_string(c + 1));
    label.anchor = Anchor::BottomLeft;
    label.size = kTextSize;
    label.offset = {0, -1};
    label.plate = true;
    drawing.items.push_back({{}, Role::Series, Emphasis::Normal, std::move(label), {static_cast<int>(c), 1}});
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
            drawing.items.push_back({{}, Role::Stream, Emphasis::Strong, Rectangle{box.grown(-0.5), true, 1, 0}, tint});
            if (std::binary_search(curve.exact.begin(), curve.exact.end(), pixel)) {
                drawing.add({}, Role::Highlight, Rectangle{box, false, 0.8, 0});
            }
            if (streamsOf(curve) < 2) continue;
            Label number;
            number.at = box.center();
            number.text = plainText(std::to_string(stream));
            number.anchor = Anchor::Center;
            number.size = 0.62;
            number.plate = true;
            number.room = box.grown(2.5);  // a plate of the same colour may touch its neighbours
            drawing.items.push_back({{}, Role::Stream, Emphasis::Normal, std::move(number), tint});
        }
        const double chosen = strip.x0 + side * (static_cast<double>(data.place.chosen - frame.lens.begin) + 0.5);
        if (data.place.chosen >= frame.lens.begin && data.place.chosen < frame.lens.end) {
            drawing.add({}, Role::Hit, Marker{{chosen, strip.y1 + 4}, Shape::TriangleUpHollow, 5});
        }
    }
}

Drawing rowsAxes(const RowsData& data, const RowsFrame& frame) {
    constexpr double kPixelsApart = 60;
    Drawing drawing;
    drawing.bounds = frame.whole;
    addText(drawing, {frame.upper.x0, frame.upper.y0}, Message(MessageId::DrawRowTexels), Anchor::BottomLeft,
            {-36, -5});
    // All of the title, or where it would run into these words its first part.
    for (const int part : {-1, 0}) {
        addText(drawing, {frame.upper.x1, frame.upper.y0}, titleOf(data), Anchor::Right, {0, -11}, true);
        std::get<Label>(drawing.items.back().primitive).part = part;
    }
    addText(drawing, {frame.lower.x0, frame.lower.y0}, Message(MessageId::DrawRowError), Anchor::BottomLeft, {-36, -7});
    addTexels(drawing, frame);
    addErrorSide(drawing, frame);
    addFrame(drawing, frame.upper);
    addFrame(drawing, frame.lower);
    // First: numbers give way to words.
    const Message title(MessageId::DrawRowPixels);
    if (frame.lowPane()) {
        addText(drawing, {frame.lower.x1, frame.lower.y1}, title, Anchor::Right, {0, kTick + 6});
    } else {
        addText(drawing, {frame.lower.center().x, frame.lower.y1}, title, Anchor::Top, {0, kTick + 13});
    }
    const double step = std::max(1.0, niceStep(frame.to - frame.from, frame.upper.width() / kPixelsApart));
    // Marks stand at the middles of their pixels.
    for (const double pixel : ticks(frame.from, frame.to - 0.5, step)) {
        const double x = frame.xAt(pixel + 0.5);
        addLine(drawing, {x, frame.upper.y1}, {x, frame.upper.y1 + kTick});
        addLine(drawing, {x, frame.lower.y1}, {x, frame.lower.y1 + kTick});
        addText(drawing, {x, frame.lower.y1}, plainText(tickText(pixel, step)), Anchor::Top, {0, kTick + 1}, true);
    }
    return drawing;
}

Drawing rowsLegend(const RowsData& data, double width, relief::Language language, RowsLegend legend) {
    LegendRows rows(width, language);
    bool exact = false;
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        const Message text = legend == RowsLegend::Names ? plainText(data.names[c]) : curveText(data, c);
        const Point at = rows.place(kPlate + rows.textRoom(text) + LegendRows::kBetween);
        Label number;
        number.at = {at.x + 5, at.y};
        number.text = plainText(std::to_string(c + 1));
        number.anchor = Anchor::Center;
        number.size = kTextSize;
        number.plate = true;
        rows.add(Role::Series, std::move(number), {static_cast<int>(c), 1});
        rows.text({at.x + kPlate, at.y}, text);
        exact = exact || !data.row.curves[c].exact.empty();
    }
    if (legend != RowsLegend::Whole) return rows.take();
    const auto mark = [&](Shape shape, double size, const Message& text) {
        const Point at = rows.place(LegendRows::kSign + rows.textRoom(text) + LegendRows::kBetween);
        rows.add(Role::Highlight, Marker{{at.x + 5, at.y}, shape, size});
        rows.text({at.x + LegendRows::kSign, at.y}, text);
    };
    if (exact) mark(Shape::Bar, 6, Message(MessageId::DrawRowExact));
    if (data.affine) {
        const std::string share = relief::numberText(100 * data.affine->share, 2) + "%";
        mark(Shape::SquareHollow, 7, Message(MessageId::DrawRowClosedForm, {{"share", share}}));
    }
    return rows.take();
}

}  // namespace reliefui
