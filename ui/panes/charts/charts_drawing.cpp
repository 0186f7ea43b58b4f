#include "panes/charts/charts_drawing.h"

#include <algorithm>
#include <cmath>

#include "measuring/text_table.h"
#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "painting/paragraph.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::FrameHistograms;
using relief::Message;
using relief::MessageId;

Role roleOf(BarKind kind) {
    switch (kind) {
        case BarKind::Behind:
            return Role::Overshoot;
        case BarKind::Wrong:
            return Role::Limit;
        default:
            return Role::Layer;
    }
}

HistogramPicture emptyHistogram(const Box& room, std::int64_t most, Message title) {
    constexpr double kTop = 17;  // in points
    HistogramPicture picture;
    picture.countHigh = std::max(std::ceil(std::log10(static_cast<double>(std::max<std::int64_t>(most, 1)))), 1.0);
    picture.drawing.bounds = room;
    const int lines = chart::title(picture.drawing, std::move(title), room);
    picture.plot = chart::plotIn(room, {.top = kTop + (lines - 1) * chart::kTitleLine, .bottom = kTop + 1});
    const chart::Axes axes(picture.drawing, picture.plot, room);
    axes.left(picture.counts(), true);
    axes.sides();
    // The label of the count axis stands in the free corner below its numbers, at a size that fits in either language.
    const Message counted(MessageId::DrawChartRays);
    picture.drawing.add({}, Role::Legend,
                        Label{.at = {picture.plot.x0, picture.plot.y1},
                              .text = counted,
                              .anchor = Anchor::Right,
                              .size = chart::fittingSize(chart::widthOf(counted), chart::kLeft - 3),
                              .offset = {-2, chart::kTick + 7}});
    return picture;
}

void addBar(HistogramPicture& picture, const HistogramBar& bar) {
    picture.bars.push_back(bar);
    if (bar.rays == 0) return;
    const Box body{bar.box.x0, picture.yAt(bar.rays), bar.box.x1, bar.box.y1};
    picture.drawing.add({}, roleOf(bar.kind), Rectangle{body, true, 0, 0},
                        bar.kind == BarKind::Behind ? Emphasis::Normal : Emphasis::Strong);
    if (bar.kind == BarKind::Behind) picture.drawing.add({}, Role::Overshoot, Hatch{body});
}

void addTick(HistogramPicture& picture, double x, Message word) {
    const double y = picture.plot.y1;
    chart::line(picture.drawing, {x, y}, {x, y + chart::kTick});
    chart::text(picture.drawing, {x, y}, std::move(word), Anchor::Top, {0, chart::kTick + 1});
}

std::string countText(double value) {
    return relief::readable(value, 3);
}

}  // namespace

HistogramPicture stepsHistogram(const FrameHistograms& data, std::int64_t chosen, const Box& room) {
    std::int64_t most = 1;
    for (const std::int64_t rays : data.steps) most = std::max(most, rays);
    HistogramPicture picture = emptyHistogram(
        room, most,
        Message(MessageId::DrawChartSteps,
                {{"mean", countText(data.stepsMean)}, {"p95", data.stepsP95}, {"most", data.stepsMost}}));
    if (data.steps.empty()) return picture;
    const Box& plot = picture.plot;
    const double side = plot.width() / static_cast<double>(data.steps.size());
    constexpr double kGap = 0.08;  // between bars, as a share of their width
    for (std::size_t b = 0; b < data.steps.size(); ++b) {
        const double x = plot.x0 + side * static_cast<double>(b);
        const auto low = static_cast<double>(b) * data.stepWidth;
        addBar(picture, {BarKind::Steps,
                         {x + kGap * side, plot.y0, x + (1 - kGap) * side, plot.y1},
                         low,
                         low + data.stepWidth,
                         data.steps[b],
                         b});
    }
    const double range = static_cast<double>(data.steps.size()) * data.stepWidth;
    // Bins of a single number have their tick at the middle of the bar, wider bins at its left edge.
    const double shift = data.stepWidth == 1 ? 0.5 : 0;
    const chart::Scale numbers{.low = -shift,
                               .high = range - shift,
                               .from = plot.x0,
                               .to = plot.x1,
                               .leastStep = static_cast<double>(data.stepWidth)};
    chart::Axes(picture.drawing, plot, room).below(numbers);
    if (chosen > 0 && static_cast<double>(chosen) <= range) {
        const double x = numbers.at(static_cast<double>(chosen) + (data.stepWidth == 1 ? 0 : 0.5));
        picture.drawing.add({ItemKind::Ray, 0, 0, 0}, Role::Hit, Marker{{x, plot.y0 + 3}, Shape::TriangleDown, 7});
        picture.drawing.add({ItemKind::Ray, 0, 0, 0}, Role::Hit, Polyline{{{x, plot.y0}, {x, plot.y1}}, false},
                            Emphasis::Faint);
    }
    return picture;
}

HistogramPicture errorHistogram(const FrameHistograms& data, const Box& room) {
    std::int64_t most = std::max({data.exact, data.wrong, std::int64_t{1}});
    for (const auto* counts : {&data.before, &data.behind}) {
        for (const std::int64_t rays : *counts) most = std::max(most, rays);
    }
    const double share = data.rays > 0 ? 100 * static_cast<double>(data.exact) / static_cast<double>(data.rays) : 0;
    HistogramPicture picture = emptyHistogram(
        room, most,
        Message(MessageId::DrawChartErrors, {{"right", countText(share)}, {"most", countText(data.largest)}}));
    const Box& plot = picture.plot;
    constexpr double kSingle = 16;  // width of the bars for exact rays and for wrong outcomes, in points
    constexpr double kGap = 10;
    const double inner0 = plot.x0 + 4 + kSingle + kGap;
    const double inner1 = plot.x1 - 4 - kSingle - kGap;
    addBar(picture, {BarKind::Exact, {plot.x0 + 4, plot.y0, plot.x0 + 4 + kSingle, plot.y1}, 0, 0, data.exact, 0});
    addTick(picture, plot.x0 + 4 + kSingle / 2, plainText("0"));
    addBar(picture, {BarKind::Wrong, {plot.x1 - 4 - kSingle, plot.y0, plot.x1 - 4, plot.y1}, 0, 0, data.wrong, 0});
    const Message wrong(MessageId::DrawChartWrongBar);
    addTick(picture, plot.x1 - 4 - kSingle / 2, wrong);
    const std::size_t bins = data.before.size();
    if (bins == 0 || inner1 <= inner0) return picture;
    const double side = (inner1 - inner0) / static_cast<double>(bins);
    for (std::size_t b = 0; b < bins; ++b) {
        const double x = inner0 + side * static_cast<double>(b);
        const auto edge = [&](std::size_t n) {
            return std::pow(10.0, data.lowDecade + static_cast<double>(n) / FrameHistograms::kErrorBins);
        };
        // The two bars stand side by side: stacked bars cannot be read on a logarithmic scale.
        addBar(picture, {BarKind::Before,
                         {x + 0.06 * side, plot.y0, x + 0.5 * side, plot.y1},
                         edge(b),
                         edge(b + 1),
                         data.before[b],
                         b});
        addBar(picture, {BarKind::Behind,
                         {x + 0.5 * side, plot.y0, x + 0.94 * side, plot.y1},
                         edge(b),
                         edge(b + 1),
                         data.behind[b],
                         b});
    }
    // The axis ends before the label of the bar for wrong outcomes.
    const double end = std::min(inner1, plot.x1 - 4 - kSingle / 2 - chart::widthOf(wrong) / 2 - 9);
    const double decades = (end - inner0) / (side * FrameHistograms::kErrorBins);
    chart::Axes(picture.drawing, plot, room)
        .below({double(data.lowDecade), data.lowDecade + decades, inner0, end, chart::Numbers::Powers});
    return picture;
}

namespace {

// The parts are placed side by side if that gives them a better aspect ratio.
struct Rooms {
    Box pareto, steps, errors;
};
Rooms rooms(ChartsShown shown, double width, double height) {
    constexpr double kParetoShare = 0.6;
    constexpr double kGap = 8;
    constexpr double kWide = 1.7;
    const Box all{0, 0, width, height};
    if (shown == ChartsShown::Pareto) return {all, {}, {}};
    Rooms out;
    Box rest = all;
    const bool wide = width > kWide * height;
    if (shown == ChartsShown::All) {
        out.pareto = wide ? Box{0, 0, kParetoShare * width, height} : Box{0, 0, width, kParetoShare * height};
        rest = wide ? Box{out.pareto.x1 + kGap, 0, width, height} : Box{0, out.pareto.y1 + kGap, width, height};
    }
    // Next to the chart, one above the other; otherwise side by side.
    const Point middle = rest.center();
    constexpr double kLeastTitle = 150;  // width in which the histograms' titles are legible
    if (rest.width() > std::max(1.3 * rest.height(), 2 * kLeastTitle)) {
        out.steps = {rest.x0, rest.y0, middle.x - kGap / 2, rest.y1};
        out.errors = {middle.x + kGap / 2, rest.y0, rest.x1, rest.y1};
    } else {
        out.steps = {rest.x0, rest.y0, rest.x1, middle.y - kGap / 2};
        out.errors = {rest.x0, middle.y + kGap / 2, rest.x1, rest.y1};
    }
    return out;
}

}  // namespace

ChartsPicture chartsPicture(const ChartsSource& source, double width, double height, relief::Language language) {
    ChartsPicture picture;
    picture.drawing.bounds = {0, 0, width, height};
    const Rooms where = rooms(source.shown, width, height);
    if (!where.pareto.empty()) {
        if (source.pareto) {
            picture.pareto = paretoPicture(*source.pareto, where.pareto);
            picture.drawing.append(picture.pareto->drawing);
        } else {
            addParagraph(picture.drawing, where.pareto.center(), Message(source.missing), where.pareto.width(),
                         language, chart::kTextSize);
        }
    }
    if (!where.steps.empty() && !source.histograms) {
        const Box both = where.steps.joined(where.errors);
        addParagraph(picture.drawing, both.center(), source.uncounted, both.width(), language, chart::kTextSize);
    } else if (!where.steps.empty()) {
        picture.steps = stepsHistogram(*source.histograms, source.chosenSteps, where.steps);
        picture.errors = errorHistogram(*source.histograms, where.errors);
        picture.drawing.append(picture.steps->drawing);
        picture.drawing.append(picture.errors->drawing);
    }
    return picture;
}

Drawing chartsLegend(const ChartsSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    if (source.pareto && source.shown != ChartsShown::Histograms) addParetoLegend(rows, *source.pareto);
    if (source.shown == ChartsShown::Pareto || !source.histograms) return rows.take();
    rows.newRow();
    rows.swatch(Role::Layer, Message(MessageId::DrawChartShort));
    rows.swatch(Role::Overshoot, Message(MessageId::DrawChartPast), {}, true);
    return rows.take();
}

ChartsReading chartsReading(const ChartsPicture& picture, Point at) {
    ChartsReading reading;
    if (picture.pareto) reading.point = paretoPointAt(*picture.pareto, at);
    if (reading.point) return reading;
    for (const auto* histogram : {&picture.steps, &picture.errors}) {
        if (!*histogram) continue;
        for (const HistogramBar& bar : (*histogram)->bars) {
            if (bar.box.contains(at)) reading.bar = bar;
        }
    }
    return reading;
}

}  // namespace reliefui
