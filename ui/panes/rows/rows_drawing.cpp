#include "panes/rows/rows_drawing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::PixelSpan;
using relief::RowCurve;

constexpr double kLeft = 40;  // margins, in points
constexpr double kRight = 14;
constexpr double kTop = 18;
constexpr double kLow = 190;       // in points; lower panes have one row of text below the plots
constexpr double kGap = 25;        // between the plots, for the lower one's title
constexpr double kStripRoom = 26;  // a strip and its title
constexpr double kStripHeight = 13;
constexpr double kLeastForStrips = 220;
constexpr double kUpperShare = 0.42;
constexpr double kPixelsPerPoint = 2;  // fine enough for print
constexpr std::int64_t kLens = 40;     // number of pixels shown individually
constexpr double kWeightStep = relief::kAnchorError;
// With more streams than this, one line is drawn for all.
constexpr int kMostStreamLines = 8;

// Smallest and largest value of a range of pixels, without NaN.
struct Limits {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(const std::vector<double>& values, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (std::isnan(values[i])) continue;
            low = std::min(low, values[i]);
            high = std::max(high, values[i]);
        }
    }
    bool any() const { return low <= high; }
};

struct Indices {
    std::size_t from = 0;
    std::size_t to = 0;
};
Indices indices(const RowsData& data, const RowsFrame& frame) {
    const PixelSpan seen = frame.seen(data);
    return {static_cast<std::size_t>(seen.begin - data.row.span.begin),
            static_cast<std::size_t>(seen.end - data.row.span.begin)};
}

void setTexelRange(RowsFrame& frame, const RowsData& data) {
    const auto [from, to] = indices(data, frame);
    Limits limits;
    limits.take(data.row.u, from, to);
    limits.take(data.row.v, from, to);
    for (const RowCurve& curve : data.row.curves) {
        limits.take(curve.u, from, to);
        limits.take(curve.v, from, to);
    }
    if (!limits.any()) return;
    constexpr double kHeadroom = 0.06;
    const double room = std::max((limits.high - limits.low) * kHeadroom, 1e-6);
    frame.low = limits.low - room;
    frame.high = limits.high + room;
}

// A logarithmic axis spans whole decades, down to two below the smallest of the curves' largest errors; the rounding
// step of a weight is always within the range.
void setErrorRange(RowsFrame& frame, const RowsData& data) {
    const auto [from, to] = indices(data, frame);
    double high = 0;
    double low = kWeightStep;
    for (const RowCurve& curve : data.row.curves) {
        Limits limits;
        limits.take(curve.error, from, to);
        if (!limits.any()) continue;
        high = std::max(high, limits.high);
        if (limits.high > 0) low = std::min(low, limits.high);
    }
    if (!frame.logarithmic) {
        constexpr double kHeadroom = 1.1;
        frame.errorLow = 0;
        frame.errorHigh = high > 0 ? high * kHeadroom : 2 * kWeightStep;
        return;
    }
    constexpr double kLowest = -18;
    frame.errorHigh = std::ceil(std::log10(std::max(high, kWeightStep) * 1.3));
    frame.errorLow = std::max(std::floor(std::log10(low)) - 2, kLowest);
}

PixelSpan lensOf(const RowsData& data, const RowsFrame& frame) {
    const PixelSpan seen = frame.seen(data);
    if (seen.size() <= kLens) return seen;
    const std::int64_t middle = std::clamp(data.place.chosen, seen.begin, seen.end - 1);
    const std::int64_t begin = std::clamp(middle - kLens / 2, seen.begin, seen.end - kLens);
    return {begin, begin + kLens};
}

void placePlots(RowsFrame& frame, const RowsData& data) {
    constexpr double kLeastSide = 8;
    const double right = std::max(frame.whole.x1 - kRight, kLeft + kLeastSide);
    const std::size_t mostStrips = frame.whole.height() < kLeastForStrips         ? 0
                                   : frame.whole.height() < 1.6 * kLeastForStrips ? 1
                                                                                  : kMostRowCurves;
    for (std::size_t c = 0; c < data.row.curves.size() && frame.stripCurves.size() < mostStrips; ++c) {
        const bool spans = data.row.curves[c].options.variant == relief::RowVariant::Subspan;
        if (streamsOf(data.row.curves[c]) > 1 || spans) frame.stripCurves.push_back(c);
    }
    const double strips = kStripRoom * static_cast<double>(frame.stripCurves.size());
    const double bottom = chart::bottomOf(frame.whole.height(), kLow);
    const double room = std::max(frame.whole.height() - kTop - bottom - kGap - strips, 2 * kLeastSide);
    const double middle = kTop + kUpperShare * room;
    frame.upper = {kLeft, kTop, right, middle};
    for (std::size_t s = 0; s < frame.stripCurves.size(); ++s) {
        const double top = middle + kStripRoom * static_cast<double>(s + 1) - kStripHeight;
        frame.strips.push_back({kLeft, top, right, top + kStripHeight});
    }
    frame.lower = {kLeft, middle + strips + kGap, right, kTop + room + strips + kGap};
}

// A line through a range of pixels, thinned to a limited number of points: of the pixels that share a column, the one
// with the largest value, or the first. The line has gaps where there is no value.
using Value = std::function<double(std::size_t)>;
std::vector<std::vector<Point>> lineOf(const RowsData& data, const RowsFrame& frame, std::size_t step,
                                       std::size_t first, bool largest, const Value& value, const Value& toY) {
    const auto [from, to] = indices(data, frame);
    const double columns = std::max(1.0, frame.upper.width() * kPixelsPerPoint);
    const auto count = static_cast<double>(to - from) / static_cast<double>(step);
    const std::size_t each = step * static_cast<std::size_t>(std::max(1.0, std::ceil(count / columns)));
    std::vector<std::vector<Point>> lines(1);
    const std::size_t begin = from + (first + step - from % step) % step;
    for (std::size_t i = begin; i < to; i += each) {
        std::size_t best = i;
        double most = value(i);
        for (std::size_t k = i + step; largest && k < std::min(i + each, to); k += step) {
            const double other = value(k);
            if (std::isnan(most) || other > most) best = k, most = other;
        }
        if (std::isnan(most)) {
            if (!lines.back().empty()) lines.emplace_back();
            continue;
        }
        lines.back().push_back({frame.xAt(data.row.x[best]), toY(best)});
    }
    // The last pixel is always included, so that the line extends over the whole row.
    if (!largest && to > from && !std::isnan(value(to - 1)) && !lines.back().empty()) {
        lines.back().push_back({frame.xAt(data.row.x[to - 1]), toY(to - 1)});
    }
    return lines;
}

void addLines(Drawing& drawing, std::vector<std::vector<Point>> lines, Role role, int number, Emphasis emphasis) {
    for (std::vector<Point>& points : lines) {
        if (points.size() < 2) continue;
        drawing.add({}, role, Polyline{std::move(points)}, emphasis, {number, 1});
    }
}

void addCoordinates(Drawing& drawing, const RowsData& data, const RowsFrame& frame, std::size_t c) {
    const RowCurve& curve = data.row.curves[c];
    const auto number = static_cast<int>(c);
    for (const bool second : {true, false}) {
        const std::vector<double>& values = second ? curve.v : curve.u;
        const auto value = [&](std::size_t i) { return values[i]; };
        const auto toY = [&](std::size_t i) { return frame.yAt(values[i]); };
        addLines(drawing, lineOf(data, frame, 1, 0, false, value, toY), second ? Role::SeriesDashed : Role::Series,
                 number, Emphasis::Normal);
    }
    // The curves' numbers are placed at different positions, because most curves coincide.
    const auto [from, to] = indices(data, frame);
    const double place = (static_cast<double>(c) + 0.7) / (static_cast<double>(data.row.curves.size()) + 0.4);
    const std::size_t i = from + static_cast<std::size_t>(static_cast<double>(to - from) * place);
    if (i < to && !std::isnan(curve.u[i]))
        addCurveNumber(drawing, {frame.xAt(data.row.x[i]), frame.yAt(curve.u[i])}, c, {});
}

// If the pixels are far enough apart, each is drawn as a dot in the colour of its stream.
void addPixels(Drawing& drawing, const RowsData& data, const RowsFrame& frame, std::size_t c) {
    constexpr double kApart = 5;  // in points
    const RowCurve& curve = data.row.curves[c];
    const auto [from, to] = indices(data, frame);
    if (streamsOf(curve) < 2 || frame.upper.width() < kApart * static_cast<double>(to - from)) return;
    for (std::size_t i = from; i < to; ++i) {
        if (std::isnan(curve.error[i])) continue;
        const double x = frame.xAt(data.row.x[i]);
        for (const Point at : {Point{x, frame.yAt(curve.u[i])}, Point{x, frame.errorAt(curve.error[i])}}) {
            drawing.add({}, Role::Stream, Marker{at, Shape::Dot, 4}, Emphasis::Normal,
                        {static_cast<int>(curve.stream[i]), 1});
        }
    }
}

void addErrors(Drawing& drawing, const RowsData& data, const RowsFrame& frame, std::size_t c) {
    const RowCurve& curve = data.row.curves[c];
    const auto toY = [&](std::size_t i) { return frame.errorAt(curve.error[i]); };
    const int streams = streamsOf(curve);
    if (streams == 1 || streams > kMostStreamLines) {
        const auto value = [&](std::size_t i) { return curve.error[i]; };
        addLines(drawing, lineOf(data, frame, 1, 0, true, value, toY), Role::Series, static_cast<int>(c),
                 Emphasis::Normal);
    } else {
        const bool opposed = curve.options.variant == relief::RowVariant::Opposed;
        const auto offset =
            static_cast<std::size_t>(std::max<std::int64_t>(curve.valid.begin - data.row.span.begin, 0));
        for (int s = 0; s < streams; ++s) {
            const auto value = [&](std::size_t i) {
                return curve.stream[i] == s ? curve.error[i] : std::numeric_limits<double>::quiet_NaN();
            };
            const std::size_t step = opposed ? 1 : static_cast<std::size_t>(streams);
            const std::size_t first = opposed ? 0 : (offset + static_cast<std::size_t>(s)) % step;
            addLines(drawing, lineOf(data, frame, step, first, true, value, toY), Role::Stream, s, Emphasis::Normal);
        }
    }
    const PixelSpan seen = frame.seen(data);
    if (curve.valid.empty() || curve.worstPixel < seen.begin || curve.worstPixel >= seen.end) return;
    const double x = frame.xAt(static_cast<double>(curve.worstPixel) + 0.5);
    addCurveNumber(drawing, {x, frame.errorAt(curve.worst)}, c, {0, -7});
}

// Marks the restarts at the lower side, in a row for each curve; omitted if they would be too dense.
void addRestarts(Drawing& drawing, const RowsData& data, const RowsFrame& frame) {
    constexpr double kApart = 3;  // in points
    const PixelSpan seen = frame.seen(data);
    double y = frame.lower.y1;
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        const std::vector<std::int64_t>& exact = data.row.curves[c].exact;
        const auto first = std::lower_bound(exact.begin(), exact.end(), seen.begin);
        const auto last = std::lower_bound(first, exact.end(), seen.end);
        if (first == last || static_cast<double>(last - first) * kApart > frame.lower.width()) continue;
        for (auto pixel = first; pixel != last; ++pixel) {
            const double x = frame.xAt(static_cast<double>(*pixel) + 0.5);
            drawing.add({}, Role::Series, Polyline{{{x, y - chart::kTick}, {x, y}}}, Emphasis::Normal,
                        {static_cast<int>(c), 1});
        }
        y -= chart::kTick + 2;
    }
}

void addClosedForm(Drawing& drawing, const RowsData& data, const RowsFrame& frame) {
    if (!data.affine || data.affine->x < frame.from || data.affine->x > frame.to) return;
    drawing.add({}, Role::Highlight,
                Marker{{frame.xAt(data.affine->x), frame.errorAt(data.affine->error)}, Shape::SquareHollow, 7});
}

}  // namespace

void addCurveNumber(Drawing& drawing, Point at, std::size_t curve, Point offset, Anchor anchor) {
    drawing.add({}, Role::Series,
                Label{.at = at,
                      .text = plainText(std::to_string(curve + 1)),
                      .anchor = anchor,
                      .size = 0.8,
                      .offset = offset,
                      .plate = true},
                Emphasis::Normal, {static_cast<int>(curve), 1});
}

double RowsFrame::errorAt(double error) const {
    return error > 0 || !logarithmic ? std::clamp(errors().at(error), lower.y0, lower.y1) : lower.y1;
}

PixelSpan RowsFrame::seen(const RowsData& data) const {
    const auto begin = static_cast<std::int64_t>(std::floor(from));
    const auto end = static_cast<std::int64_t>(std::ceil(to));
    return {std::clamp(begin, data.row.span.begin, data.row.span.end),
            std::clamp(end, data.row.span.begin, data.row.span.end)};
}

RowsFrame rowsFrame(const RowsData& data, const RowsOptions& options, const RowsRange& range, double width,
                    double height) {
    RowsFrame frame;
    frame.whole = {0, 0, width, height};
    frame.logarithmic = options.logarithmic;
    frame.from = static_cast<double>(data.row.span.begin);
    frame.to = static_cast<double>(std::max(data.row.span.end, data.row.span.begin + 1));
    if (range.to > range.from) {
        frame.from = std::max(frame.from, range.from);
        frame.to = std::max(std::min(frame.to, range.to), frame.from + 1);
    }
    placePlots(frame, data);
    setTexelRange(frame, data);
    setErrorRange(frame, data);
    frame.lens = lensOf(data, frame);
    return frame;
}

Drawing rowsPlots(const RowsData& data, const RowsFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    const double weight = frame.errorAt(kWeightStep);
    if (frame.logarithmic || kWeightStep < frame.errorHigh) {
        drawing.add({}, Role::Miss, Polyline{{{frame.lower.x0, weight}, {frame.lower.x1, weight}}, false});
        drawing.add({}, Role::Legend,
                    Label{.at = {frame.lower.x0, weight},
                          .text = Message(MessageId::DrawRowWeight),
                          .size = chart::kTextSize,
                          .offset = {10, weight - frame.lower.y0 < 14 ? 7.0 : -6.0}});
    }
    const double chosen = static_cast<double>(data.place.chosen) + 0.5;
    if (chosen >= frame.from && chosen <= frame.to) {
        const double x = frame.xAt(chosen);
        for (const Box& plot : {frame.upper, frame.lower}) {
            drawing.add({ItemKind::Ray, 0, 0, 0}, Role::Hit, Polyline{{{x, plot.y0}, {x, plot.y1}}, false},
                        Emphasis::Faint);
        }
        const bool right = x > frame.upper.center().x;
        drawing.add({}, Role::Legend,
                    Label{.at = {x, frame.upper.y0},
                          .text = Message(MessageId::DrawRowChosen, {{"x", data.place.chosen}}),
                          .anchor = right ? Anchor::Right : Anchor::Left,
                          .size = chart::kTextSize,
                          .offset = {right ? -4.0 : 4.0, 6}});
    }
    if (frame.seen(data).empty()) return drawing;
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        addCoordinates(drawing, data, frame, c);
        addErrors(drawing, data, frame, c);
    }
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) addPixels(drawing, data, frame, c);
    addRestarts(drawing, data, frame);
    addClosedForm(drawing, data, frame);
    addStrips(drawing, data, frame);
    return drawing;
}

RowsReading rowsReading(const RowsData& data, const RowsFrame& frame, Point at) {
    RowsReading reading;
    for (std::size_t s = 0; s < frame.strips.size(); ++s) {
        const Box& strip = frame.strips[s];
        if (!strip.contains(at)) continue;
        const double part = (at.x - strip.x0) / strip.width() * static_cast<double>(frame.lens.size());
        reading.inside = true;
        reading.pixel = std::min(frame.lens.begin + static_cast<std::int64_t>(part), frame.lens.end - 1);
        reading.curve = frame.stripCurves[s];
        return reading;
    }
    const bool above = frame.upper.contains(at);
    const PixelSpan seen = frame.seen(data);
    if (seen.empty() || (!above && !frame.lower.contains(at))) return reading;
    reading.inside = true;
    reading.pixel = std::clamp(static_cast<std::int64_t>(std::floor(frame.pixelAt(at.x))), seen.begin, seen.end - 1);
    const auto i = static_cast<std::size_t>(reading.pixel - data.row.span.begin);
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        const RowCurve& curve = data.row.curves[c];
        if (std::isnan(curve.error[i])) continue;
        const double away =
            above ? std::min(std::abs(frame.yAt(curve.u[i]) - at.y), std::abs(frame.yAt(curve.v[i]) - at.y))
                  : std::abs(frame.errorAt(curve.error[i]) - at.y);
        if (away < best) best = away, reading.curve = c;
    }
    return reading;
}

}  // namespace reliefui
