#include "panes/charts/charts_drawing.h"

#include <algorithm>
#include <cmath>

#include "measuring/text_table.h"
#include "painting/axis_ticks.h"
#include "painting/chart_parts.h"
#include "painting/legend_rows.h"
#include "painting/paragraph.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::FrameHistograms;
using relief::Message;
using relief::MessageId;

constexpr double kLeft = 34;  // margins of a histogram, points
constexpr double kRight = 10;
constexpr double kTop = 17;
constexpr double kBottom = 18;

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
    constexpr double kLeastSide = 10;
    HistogramPicture picture;
    picture.plot = {room.x0 + kLeft, room.y0 + kTop, std::max(room.x1 - kRight, room.x0 + kLeft + kLeastSide),
                    std::max(room.y1 - kBottom, room.y0 + kTop + kLeastSide)};
    picture.countHigh = std::max(std::ceil(std::log10(static_cast<double>(std::max<std::int64_t>(most, 1)))), 1.0);
    picture.drawing.bounds = room;
    const int lines = chart::title(picture.drawing, std::move(title), room);
    picture.plot.y0 = std::min(picture.plot.y0 + (lines - 1) * chart::kTitleLine, picture.plot.y1 - kLeastSide);
    constexpr double kApart = 15;
    const int decades = static_cast<int>(picture.countHigh);
    const int every = std::max(1, static_cast<int>(std::ceil(decades * kApart / picture.plot.height())));
    for (int n = 0; n <= decades; n += every) {
        const auto count = static_cast<std::int64_t>(std::pow(10.0, n));
        chart::side(picture.drawing, picture.plot, picture.yAt(count), powerOfTen(n));
    }
    chart::line(picture.drawing, {picture.plot.x0, picture.plot.y0}, {picture.plot.x0, picture.plot.y1});
    chart::line(picture.drawing, {picture.plot.x0, picture.plot.y1}, {picture.plot.x1, picture.plot.y1});
    // What the numbers count stands below them, in the corner that is free; small enough for it in either language.
    Label counted;
    counted.at = {picture.plot.x0, picture.plot.y1};
    counted.text = Message(MessageId::DrawChartRays);
    counted.anchor = Anchor::Right;
    counted.offset = {-1, chart::kTick + 7};
    counted.size = 0.68;
    picture.drawing.add({}, Role::Legend, std::move(counted));
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

void addTick(HistogramPicture& picture, double x, std::string value) {
    const double y = picture.plot.y1;
    chart::line(picture.drawing, {x, y}, {x, y + chart::kTick});
    chart::text(picture.drawing, {x, y}, plainText(std::move(value)), Anchor::Top, {0, chart::kTick + 1});
}

std::string countText(double value) {
    return relief::readable(value, 3);
}

}  // namespace

double HistogramPicture::yAt(std::int64_t rays) const {
    const double value = rays > 0 ? std::log10(static_cast<double>(rays)) : kCountLow;
    return plot.y1 - (value - kCountLow) / (countHigh - kCountLow) * plot.height();
}

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
    constexpr double kGap = 0.08;  // between bars
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
    constexpr double kApart = 32;
    const double range = static_cast<double>(data.steps.size()) * data.stepWidth;
    const double step = std::max<double>(data.stepWidth, niceStep(range, plot.width() / kApart));
    // Marks of single numbers stand below the middles of their bars, of wider bins where they begin.
    const double shift = data.stepWidth == 1 ? 0.5 : 0;
    const auto xAt = [&](double steps) { return plot.x0 + (steps + shift) / range * plot.width(); };
    for (const double value : ticks(0, range - shift, step)) addTick(picture, xAt(value), tickText(value, step));
    if (chosen > 0 && static_cast<double>(chosen) <= range) {
        const double x =
            data.stepWidth == 1 ? xAt(static_cast<double>(chosen)) : xAt(static_cast<double>(chosen) + 0.5);
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
    constexpr double kSingle = 16;  // width of the bars of exact and of wrong rays
    constexpr double kGap = 10;
    const double inner0 = plot.x0 + 4 + kSingle + kGap;
    const double inner1 = plot.x1 - 4 - kSingle - kGap;
    addBar(picture, {BarKind::Exact, {plot.x0 + 4, plot.y0, plot.x0 + 4 + kSingle, plot.y1}, 0, 0, data.exact, 0});
    addTick(picture, plot.x0 + 4 + kSingle / 2, "0");
    addBar(picture, {BarKind::Wrong, {plot.x1 - 4 - kSingle, plot.y0, plot.x1 - 4, plot.y1}, 0, 0, data.wrong, 0});
    chart::text(picture.drawing, {plot.x1 - 4 - kSingle / 2, plot.y1}, Message(MessageId::DrawChartWrongBar),
                Anchor::Top, {0, chart::kTick + 1});
    const std::size_t bins = data.before.size();
    if (bins == 0 || inner1 <= inner0) return picture;
    const double side = (inner1 - inner0) / static_cast<double>(bins);
    for (std::size_t b = 0; b < bins; ++b) {
        const double x = inner0 + side * static_cast<double>(b);
        const auto edge = [&](std::size_t n) {
            return std::pow(10.0, data.lowDecade + static_cast<double>(n) / FrameHistograms::kErrorBins);
        };
        // Side by side: on a logarithmic scale one above the other would say nothing.
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
    constexpr double kApart = 24;
    const double decade = side * FrameHistograms::kErrorBins;
    const int every = std::max(1, static_cast<int>(std::ceil(kApart / decade)));
    constexpr double kWord = 16;  // of the bar beside it
    for (int n = 0; n * decade <= inner1 - inner0 - kWord; n += every) {
        addTick(picture, inner0 + n * decade, powerOfTen(data.lowDecade + n));
    }
    return picture;
}

namespace {

// Side by side where that gives the parts a better shape.
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
    // Beside the chart one above the other, else side by side.
    const Point middle = rest.center();
    if (rest.width() > 1.3 * rest.height()) {
        out.steps = {rest.x0, rest.y0, middle.x - kGap / 2, rest.y1};
        out.errors = {middle.x + kGap / 2, rest.y0, rest.x1, rest.y1};
    } else {
        out.steps = {rest.x0, rest.y0, rest.x1, middle.y - kGap / 2};
        out.errors = {rest.x0, middle.y + kGap / 2, rest.x1, rest.y1};
    }
    return out;
}

void append(Drawing& to, const Drawing& from) {
    to.items.insert(to.items.end(), from.items.begin(), from.items.end());
}

}  // namespace

ChartsPicture chartsPicture(const ChartsSource& source, double width, double height, relief::Language language) {
    ChartsPicture picture;
    picture.drawing.bounds = {0, 0, width, height};
    const Rooms where = rooms(source.shown, width, height);
    if (!where.pareto.empty()) {
        if (source.pareto) {
            picture.pareto = paretoPicture(*source.pareto, where.pareto);
            append(picture.drawing, picture.pareto->drawing);
        } else {
            addParagraph(picture.drawing, where.pareto.center(), Message(source.missing), where.pareto.width(),
                         language, chart::kTextSize);
        }
    }
    if (!where.steps.empty() && source.histograms) {
        picture.steps = stepsHistogram(*source.histograms, source.chosenSteps, where.steps);
        picture.errors = errorHistogram(*source.histograms, where.errors);
        append(picture.drawing, picture.steps->drawing);
        append(picture.drawing, picture.errors->drawing);
    }
    return picture;
}

Drawing chartsLegend(const ChartsSource& source, double width, relief::Language language) {
    Drawing pareto;
    if (source.pareto && source.shown != ChartsShown::Histograms) {
        pareto = paretoLegend(*source.pareto, width, language);
    }
    if (source.shown == ChartsShown::Pareto || !source.histograms) return pareto;
    LegendRows rows(width, language);
    const auto entry = [&](Role role, MessageId what) {
        const Message text(what);
        const Point at = rows.place(LegendRows::kSign + rows.textRoom(text) + LegendRows::kBetween);
        const Box box{at.x, at.y - 4, at.x + 9, at.y + 4};
        rows.add(role, Rectangle{box, true, 0, 0}, {}, role == Role::Overshoot ? Emphasis::Normal : Emphasis::Strong);
        if (role == Role::Overshoot) rows.add(role, Hatch{box});
        rows.text({at.x + LegendRows::kSign, at.y}, text);
    };
    entry(Role::Layer, MessageId::DrawChartShort);
    entry(Role::Overshoot, MessageId::DrawChartPast);
    Drawing own = rows.take();
    if (pareto.items.empty()) return own;
    // Below the chart's.
    const double below = pareto.bounds.y1;
    for (Item& item : own.items) {
        if (auto* box = std::get_if<Rectangle>(&item.primitive)) box->box.y0 += below, box->box.y1 += below;
        if (auto* hatch = std::get_if<Hatch>(&item.primitive)) hatch->box.y0 += below, hatch->box.y1 += below;
        if (auto* label = std::get_if<Label>(&item.primitive)) label->at.y += below;
    }
    append(pareto, own);
    Box lower = own.bounds;
    lower.y0 += below, lower.y1 += below;
    pareto.bounds = pareto.bounds.joined(lower);
    return pareto;
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
