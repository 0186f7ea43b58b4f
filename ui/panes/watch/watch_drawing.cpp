#include "panes/watch/watch_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "relief/errors.h"

namespace reliefui {

namespace {

// Sizes in points.
constexpr double kMostNames = 0.38;  // as a share of the width
constexpr double kGap = 6;
constexpr double kBetween = 3;  // between graphs
constexpr double kMostRow = 64;
constexpr double kTwoLines = 26;  // height of a row from which name and value have a line each
constexpr double kRangeText = 0.7;
constexpr double kLeastForRange = 22;

double namesWidth(const std::vector<WatchRow>& rows, double width) {
    constexpr double kLeast = 60;
    double longest = kLeast;
    for (const WatchRow& row : rows) longest = std::max(longest, textWidth(row.name, kChartText, true));
    return std::min(longest + kGap, kMostNames * width);
}

double rangeWidth(const std::vector<WatchRow>& rows) {
    double longest = 0;
    for (const WatchRow& row : rows) {
        const GraphRange range = graphRange(row.heights);
        for (const double value : {range.low, range.high}) {
            if (!range.empty()) longest = std::max(longest, textWidth(relief::numberText(value, 3), kRangeText));
        }
    }
    return longest + kGap;
}

// Returns true if the row's values are numbers, so that the ends of its range have a meaning.
bool isNumbers(const WatchRow& row) {
    return !row.values.values.empty() && std::holds_alternative<double>(row.values.values.front());
}

// The longest beginning of a text that fits, with an ellipsis if it is cut.
std::string fitting(const std::string& text, double room, double size, bool bold) {
    if (textWidth(text, size, bold) <= room) return text;
    std::string cut = text;
    while (!cut.empty() && textWidth(cut + "…", size, bold) > room) {
        do cut.pop_back();
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U);
        if (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0xC0U) cut.pop_back();
    }
    return cut + "…";
}

}  // namespace

std::string WatchRow::text(std::size_t step) const {
    return step < values.values.size() ? relief::expressionValueText(values.values[step]) : std::string();
}

std::vector<WatchRow> watchRows(const PixelTrace& trace, const WatchPane& pane) {
    const relief::StepColumns columns = trace.columns();
    std::vector<WatchRow> rows;
    for (const std::string& name : pane.values) {
        WatchRow row;
        row.name = name;
        try {
            row.values = relief::watchedValues(name, columns);
            row.heights = row.values.heights();
        } catch (const relief::InputError& error) {
            row.fault = error.message();
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Box WatchFrame::graph(std::size_t row) const {
    const double top = graphs.y0 + static_cast<double>(row) * rowHeight();
    return {graphs.x0, top, graphs.x1, top + rowHeight() - kBetween};
}

GraphPart WatchFrame::part(std::size_t step) const {
    const double width = steps > 0 ? graphs.width() / static_cast<double>(steps) : 0;
    return {graphs.x0 + static_cast<double>(step) * width, graphs.x0 + static_cast<double>(step + 1) * width};
}

std::optional<std::size_t> WatchFrame::rowAt(Point at) const {
    if (rows == 0 || !(at.y >= graphs.y0 && at.y < graphs.y1)) return std::nullopt;
    return std::min(rows - 1, static_cast<std::size_t>((at.y - graphs.y0) / rowHeight()));
}

std::optional<std::size_t> WatchFrame::stepAt(Point at) const {
    if (steps == 0 || !graphs.contains(at)) return std::nullopt;
    const double share = (at.x - graphs.x0) / graphs.width();
    return std::min(steps - 1, static_cast<std::size_t>(share * static_cast<double>(steps)));
}

WatchFrame watchFrame(const std::vector<WatchRow>& rows, std::size_t steps, double width, double height) {
    WatchFrame frame;
    frame.whole = {0, 0, std::max(1.0, width), std::max(1.0, height)};
    frame.rows = rows.size();
    frame.steps = steps;
    const double left = namesWidth(rows, frame.whole.width());
    const double right = std::max(left + 1, frame.whole.x1 - rangeWidth(rows));
    const double room = std::max(1.0, frame.whole.height() - chart::kLowBottom);
    frame.graphs = {left, 0, right,
                    std::min(room, kMostRow * static_cast<double>(std::max<std::size_t>(1, rows.size())))};
    return frame;
}

Drawing watchDrawing(const std::vector<WatchRow>& rows, const WatchFrame& frame, std::size_t step, std::size_t chosen,
                     relief::Language language) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    std::vector<GraphPart> parts;
    for (std::size_t k = 0; k < frame.steps; ++k) parts.push_back(frame.part(k));
    const auto write = [&](Point at, const std::string& words, Anchor anchor, double size, bool strong) {
        Label label;
        label.at = at;
        label.text = plainText(words);
        label.anchor = anchor;
        label.size = size;
        drawing.add({}, strong ? Role::Title : Role::Legend, std::move(label),
                    strong ? Emphasis::Strong : Emphasis::Normal);
    };
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const WatchRow& row = rows[r];
        const Box box = frame.graph(r);
        const bool two = frame.rowHeight() >= kTwoLines;
        const double room = box.x0 - kGap;
        const double middle = box.center().y;
        const std::string value = row.text(step);
        const double valueRoom = two ? 0 : textWidth(value, kChartText) + kGap;
        write({0, two ? box.y0 : middle}, fitting(row.name, std::max(0.0, room - valueRoom), kChartText, r == chosen),
              two ? Anchor::TopLeft : Anchor::Left, kChartText, r == chosen);
        write({two ? 0 : room, two ? box.y0 + 12 : middle}, fitting(value, room, kChartText, false),
              two ? Anchor::TopLeft : Anchor::Right, kChartText, false);
        drawing.add({}, Role::Grid, Rectangle{box, false, 0, 0});
        if (row.fault) {
            const double width = box.width() - 2 * kGap;
            write({box.x0 + kGap, middle}, fitting(relief::sentence(*row.fault, language), width, kChartText, false),
                  Anchor::Left, kChartText, false);
            continue;
        }
        addValueGraph(drawing, box, parts, row.heights, step, 1);
        const GraphRange range = graphRange(row.heights);
        if (range.empty() || !isNumbers(row) || box.height() < kLeastForRange) continue;
        write({box.x1 + 3, box.y0}, relief::numberText(range.high, 3), Anchor::TopLeft, kRangeText, false);
        write({box.x1 + 3, box.y1}, relief::numberText(range.low, 3), Anchor::BottomLeft, kRangeText, false);
    }
    if (rows.empty() || frame.steps == 0) return drawing;
    const chart::Axes axes(drawing, frame.graphs, frame.whole);
    chart::Scale scale{0.5, static_cast<double>(frame.steps) + 0.5, frame.graphs.x0, frame.graphs.x1};
    scale.leastStep = 1;
    axes.below(scale, relief::Message(relief::MessageId::WatchStepAxis));
    return drawing;
}

}  // namespace reliefui
