#include "panes/charts/pareto_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "painting/axis_ticks.h"
#include "painting/chart_parts.h"
#include "painting/legend_rows.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::ParetoPoint;

constexpr double kLeft = 44;  // margins, points
constexpr double kRight = 12;
constexpr double kTop = 32;
constexpr double kBottom = 34;
constexpr double kMarkSize = 9;
constexpr double kReach = 9;  // of a click

MessageId measureTitle(relief::ErrorMeasure measure) {
    constexpr MessageId kTitles[] = {MessageId::DrawChartErrorMean, MessageId::DrawChartErrorP95,
                                     MessageId::DrawChartErrorP9999, MessageId::DrawChartErrorMax};
    return kTitles[static_cast<std::size_t>(measure)];
}

// What is no number lies above all others.
bool measurable(double error) {
    return error > 0 && std::isfinite(error);
}

void setRanges(ParetoFrame& frame, const ParetoSource& source) {
    constexpr double kAround = 0.06;     // of the range, left and right
    constexpr double kLeastRange = 0.3;  // decades
    double timeLow = 9, timeHigh = -9, errorLow = 99, errorHigh = -99;
    for (const ParetoPoint& point : source.table.points) {
        timeLow = std::min(timeLow, std::log10(point.nanoseconds));
        timeHigh = std::max(timeHigh, std::log10(point.nanoseconds));
        const double error = point.errorOf(source.measure);
        frame.zeros = frame.zeros || error == 0;
        if (!measurable(error)) continue;
        errorLow = std::min(errorLow, std::log10(error));
        errorHigh = std::max(errorHigh, std::log10(error));
    }
    if (timeLow > timeHigh) timeLow = 1, timeHigh = 2;
    if (errorLow > errorHigh) errorLow = -3, errorHigh = 0;
    const double range = std::max(timeHigh - timeLow, kLeastRange);
    const double middle = (timeLow + timeHigh) / 2;
    frame.timeLow = middle - range * (0.5 + kAround);
    frame.timeHigh = middle + range * (0.5 + kAround);
    constexpr double kHeadroom = 0.12;  // decades: no mark lies on the frame
    frame.errorLow = std::floor(errorLow - kHeadroom);
    frame.errorHigh = std::max(std::ceil(errorHigh + kHeadroom), frame.errorLow + 1);
}

void addTimeAxis(Drawing& drawing, const ParetoFrame& frame, double bottom) {
    constexpr double kApart = 34;
    const double decade = frame.plot.width() / (frame.timeHigh - frame.timeLow);
    // 1, 2, 5 where there is room for them; else powers of ten, as many as can be read.
    const bool fine = decade * std::log10(2.0) >= kApart;
    const int every = fine ? 1 : std::max(1, static_cast<int>(std::ceil(kApart / decade)));
    for (int n = static_cast<int>(std::floor(frame.timeLow)); n <= static_cast<int>(frame.timeHigh); ++n) {
        if (n % every != 0) continue;
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (!fine && factor > 1) break;
            const double value = factor * std::pow(10.0, n);
            const double x = frame.xAt(value);
            if (x < frame.plot.x0 - 0.5 || x > frame.plot.x1 + 0.5) continue;
            chart::line(drawing, {x, frame.plot.y0}, {x, bottom}, Role::Grid);
            chart::line(drawing, {x, bottom}, {x, bottom + chart::kTick});
            chart::text(drawing, {x, bottom}, plainText(tickText(value, value)), Anchor::Top, {0, chart::kTick + 1});
        }
    }
    chart::text(drawing, {frame.plot.x1, bottom}, Message(MessageId::DrawChartTime), Anchor::Right,
                {0, chart::kTick + 21});
}

void addErrorAxis(Drawing& drawing, const ParetoFrame& frame) {
    constexpr double kApart = 17;
    const double range = frame.errorHigh - frame.errorLow;
    const int every = std::max(1, static_cast<int>(std::ceil(range * kApart / frame.plot.height())));
    for (int n = static_cast<int>(frame.errorHigh); n >= static_cast<int>(frame.errorLow); n -= every) {
        chart::side(drawing, frame.plot, frame.yAt(std::pow(10.0, n)), powerOfTen(n));
    }
}

Drawing axes(const ParetoSource& source, const ParetoFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    chart::text(drawing, {frame.whole.x0, frame.plot.y0}, Message(measureTitle(source.measure)), Anchor::BottomLeft,
                {2, -4});
    const double bottom = frame.whole.y1 - kBottom;
    addTimeAxis(drawing, frame, bottom);
    addErrorAxis(drawing, frame);
    chart::line(drawing, {frame.plot.x0, frame.plot.y0}, {frame.plot.x0, frame.plot.y1});
    chart::line(drawing, {frame.plot.x0, frame.plot.y1}, {frame.plot.x1, frame.plot.y1});
    if (frame.zeros) {
        chart::line(drawing, {frame.plot.x0, frame.plot.y1 + 3}, {frame.plot.x0, bottom});
        chart::line(drawing, {frame.plot.x0, bottom}, {frame.plot.x1, bottom});
        chart::side(drawing, frame.plot, frame.zero, "0");
    }
    return drawing;
}

// The Pareto front of one form, as a staircase: the least time in which any method of the form reaches an error.
std::vector<Point> frontLine(const ParetoSource& source, relief::Form form, const ParetoFrame& frame,
                             const std::vector<ParetoMark>& marks) {
    std::vector<Point> ends;
    for (const ParetoMark& mark : marks) {
        if (!mark.dominated && source.table.points[mark.point].form == form) ends.push_back(mark.at);
    }
    std::sort(ends.begin(), ends.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y > b.y); });
    std::vector<Point> line;
    for (const Point& end : ends) {
        if (!line.empty() && end.y <= line.back().y) continue;  // there for fewer wrong outcomes
        if (line.empty()) {
            line.push_back({end.x, frame.plot.y0});
        } else {
            line.push_back({end.x, line.back().y});
        }
        line.push_back(end);
    }
    if (!line.empty()) line.push_back({frame.plot.x1, line.back().y});
    return line;
}

Role roleOf(const ParetoSource& source, const ParetoMark& mark) {
    return mark.dominated || source.old ? Role::Layer : Role::Series;
}

// The middle half of the rounds.
Box whisker(const ParetoSource& source, const ParetoFrame& frame, const ParetoMark& mark) {
    const ParetoPoint& point = source.table.points[mark.point];
    const double factor = source.table.cells == 1 ? 1 + point.spread / 2 : 1;
    const auto clamped = [&](double x) { return std::clamp(x, frame.plot.x0, frame.plot.x1); };
    return {clamped(frame.xAt(point.nanoseconds / factor)), mark.at.y - 0.5,
            clamped(frame.xAt(point.nanoseconds * factor)), mark.at.y + 0.5};
}

void addMark(Drawing& drawing, const ParetoSource& source, const ParetoFrame& frame, const ParetoMark& mark) {
    const ParetoPoint& point = source.table.points[mark.point];
    const Role role = roleOf(source, mark);
    // Of one measurement only: a mean has no quartiles.
    if (source.table.cells == 1) {
        const Box line = whisker(source, frame, mark);
        drawing.add({}, role, Polyline{{{line.x0, mark.at.y}, {line.x1, mark.at.y}}, false}, Emphasis::Faint);
    }
    if (point.name == source.current) drawing.add({}, Role::Hit, Ring{mark.at, kMarkSize * 0.85});
    const Shape shape = point.wrongOutcome > 0 ? Shape::Diamond : Shape::Dot;
    drawing.add({ItemKind::Step, 0, static_cast<std::int64_t>(mark.point), 0}, role,
                Marker{mark.at, shape, mark.dominated ? 0.75 * kMarkSize : kMarkSize});
}

// Names beside their marks, as near as they find room; farther ones with a line to the mark.
class Names {
  public:
    Names(const ParetoSource& source, ParetoPicture& picture) : source_(source), picture_(picture) {}

    void place() {
        std::vector<std::size_t> order(picture_.marks.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto rank = [&](std::size_t m) {
            const ParetoMark& mark = picture_.marks[m];
            return source_.table.points[mark.point].name == source_.current ? 0 : (mark.dominated ? 2 : 1);
        };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
        for (const std::size_t m : order) placeOne(picture_.marks[m]);
    }

  private:
    static constexpr double kRow = 11.5;
    static constexpr double kBeside = 7;

    bool free(const ParetoMark& own, const Box& box) const {
        const ParetoFrame& frame = picture_.frame;
        if (box.x0 < frame.plot.x0 + 2 || box.x1 > frame.whole.x1 || box.y0 < frame.plot.y0 ||
            box.y1 > frame.whole.y1 - kBottom) {
            return false;
        }
        for (const ParetoMark& mark : picture_.marks) {
            if (!mark.label.empty() && mark.label.overlaps(box)) return false;
            const Box sign = Box{mark.at.x, mark.at.y, mark.at.x, mark.at.y}.grown(kMarkSize / 2);
            if (&mark != &own && sign.overlaps(box)) return false;
        }
        return true;
    }

    // Pieces of the front's line, and spreads, that the name would lie on.
    int crossings(const Box& box) const {
        int count = 0;
        for (const ParetoMark& mark : picture_.marks) {
            if (whisker(source_, picture_.frame, mark).overlaps(box)) ++count;
        }
        return count + crossings(picture_.front, box) + crossings(picture_.scalarFront, box);
    }
    static int crossings(const std::vector<Point>& front, const Box& box) {
        int count = 0;
        for (std::size_t i = 1; i < front.size(); ++i) {
            const Point a = front[i - 1];
            const Point b = front[i];
            const Box piece{std::min(a.x, b.x) - 0.5, std::min(a.y, b.y) - 0.5, std::max(a.x, b.x) + 0.5,
                            std::max(a.y, b.y) + 0.5};
            if (piece.overlaps(box)) ++count;
        }
        return count;
    }

    void placeOne(ParetoMark& mark) {
        const ParetoPoint& point = source_.table.points[mark.point];
        const std::string name = point.label(source_.table.bothForms());
        const double width = textWidth(name);
        constexpr double kNone = 1e9;
        constexpr double kCrossing = 26;  // points that a name goes farther to stand clear
        double best = kNone;
        for (int row = 0; row <= 14; ++row) {
            for (const double sign : {-1.0, 1.0}) {
                const double y = mark.at.y + sign * row * kRow;
                for (const bool left : {false, true}) {
                    const double x = left ? mark.at.x - kBeside - width : mark.at.x + kBeside;
                    const Box box{x, y - kRow / 2, x + width, y + kRow / 2};
                    const double cost = row * kRow + (left ? 3 : 0) + (sign > 0 ? 1 : 0) + kCrossing * crossings(box);
                    if (cost >= best || !free(mark, box)) continue;
                    best = cost;
                    mark.label = box;
                }
            }
        }
        if (best == kNone) return;  // hover tells it
        const bool left = mark.label.x1 < mark.at.x;
        const double y = mark.label.center().y;
        const Role role = roleOf(source_, mark);
        if (std::abs(y - mark.at.y) > kRow / 2) {
            const Point end{left ? mark.label.x1 + 1 : mark.label.x0 - 1, y};
            picture_.drawing.add({}, role, Polyline{{mark.at, end}, false}, Emphasis::Faint);
        }
        const bool plain = mark.dominated || source_.old;
        chart::text(picture_.drawing, {left ? mark.label.x1 : mark.label.x0, y}, plainText(name),
                    left ? Anchor::Right : Anchor::Left, {}, plain ? Role::Layer : Role::Legend,
                    point.name == source_.current ? Emphasis::Strong : Emphasis::Normal);
    }

    const ParetoSource& source_;
    ParetoPicture& picture_;
};

std::string degreesText(const std::string& elevation) {
    return elevation == relief::elevationText(std::nullopt) ? elevation : elevation + "°";
}

std::string joined(const std::vector<std::string>& all) {
    constexpr std::size_t kMost = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i) text += (i == 0 ? "" : ", ") + all[i];
    return all.size() > kMost ? text + ", …" : text;
}

}  // namespace

Message paretoTitle(const relief::ParetoTable& table) {
    if (table.cells != 1) {
        std::vector<std::string> elevations;
        for (const std::string& elevation : table.elevations) elevations.push_back(degreesText(elevation));
        return Message(
            MessageId::DrawChartCells,
            {{"cells", table.cells}, {"heights", joined(table.heights)}, {"elevations", joined(elevations)}});
    }
    const std::string& height = table.heights.front();
    const std::size_t gap = height.rfind(' ');
    return Message(MessageId::DrawChartCell, {{"height", height.substr(0, gap)},
                                              {"size", height.substr(gap + 1)},
                                              {"elevation", degreesText(table.elevations.front())}});
}

double ParetoFrame::xAt(double nanoseconds) const {
    return plot.x0 + (std::log10(nanoseconds) - timeLow) / (timeHigh - timeLow) * plot.width();
}

double ParetoFrame::yAt(double texels) const {
    if (texels == 0) return zero;
    // No number: no ray hits where `exact` does.
    if (!std::isfinite(texels)) return plot.y0;
    return plot.y1 - (std::log10(texels) - errorLow) / (errorHigh - errorLow) * plot.height();
}

ParetoFrame paretoFrame(const ParetoSource& source, const Box& room) {
    constexpr double kLeastSide = 20;
    constexpr double kMostZeroRoom = 0.42;  // of the plot
    ParetoFrame frame;
    frame.whole = room;
    setRanges(frame, source);
    const double right = std::max(room.x1 - kRight, room.x0 + kLeft + kLeastSide);
    const double bottom = std::max(room.y1 - kBottom, room.y0 + kTop + kLeastSide);
    std::size_t zeros = 0;
    for (const ParetoPoint& point : source.table.points) zeros += point.errorOf(source.measure) == 0 ? 1 : 0;
    // Their names need room above and below them.
    const double wanted = zeros == 0 ? 0 : 24 + 12.0 * static_cast<double>(zeros - 1);
    const double below = std::min(wanted, kMostZeroRoom * (bottom - room.y0 - kTop));
    frame.plot = {room.x0 + kLeft, room.y0 + kTop, right, bottom - below};
    frame.zero = bottom - below / 2;
    return frame;
}

ParetoPicture paretoPicture(const ParetoSource& source, const Box& room) {
    ParetoPicture picture;
    picture.frame = paretoFrame(source, room);
    picture.drawing = axes(source, picture.frame);
    chart::title(picture.drawing, source.title, room, source.old ? Role::Layer : Role::Legend);
    const std::vector<bool> dominated = relief::dominatedPoints(source.table.points, source.measure);
    for (std::size_t p = 0; p < dominated.size(); ++p) {
        const ParetoPoint& point = source.table.points[p];
        picture.marks.push_back(
            {p,
             {picture.frame.xAt(point.nanoseconds), picture.frame.yAt(point.errorOf(source.measure))},
             dominated[p],
             Box{}});
    }
    // Times compare within a form only: each has a line of its own.
    picture.front = frontLine(source, relief::Form::Simd, picture.frame, picture.marks);
    picture.scalarFront = frontLine(source, relief::Form::Scalar, picture.frame, picture.marks);
    if (picture.front.empty()) std::swap(picture.front, picture.scalarFront);
    picture.drawing.add({ItemKind::Surface, 0, 0, 0}, source.old ? Role::Layer : Role::Series,
                        Polyline{picture.front, false});
    if (!picture.scalarFront.empty()) {
        picture.drawing.add({}, source.old ? Role::Layer : Role::Series, Polyline{picture.scalarFront, false},
                            Emphasis::Faint);
    }
    Names(source, picture).place();
    for (const bool back : {true, false}) {
        for (const ParetoMark& mark : picture.marks) {
            if (mark.dominated == back) addMark(picture.drawing, source, picture.frame, mark);
        }
    }
    return picture;
}

Drawing paretoLegend(const ParetoSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    const auto entry = [&](Role role, const Primitive& sign, MessageId what) {
        const Message text(what);
        const Point at = rows.place(LegendRows::kSign + rows.textRoom(text) + LegendRows::kBetween);
        Primitive own = sign;
        const Point middle{at.x + 5, at.y};
        if (auto* marker = std::get_if<Marker>(&own)) marker->at = middle;
        if (auto* ring = std::get_if<Ring>(&own)) ring->center = middle;
        rows.add(role, own);
        rows.text({at.x + LegendRows::kSign, at.y}, text);
    };
    rows.line(Role::Series, Message(MessageId::DrawChartFront));
    entry(Role::Layer, Marker{{}, Shape::Dot, 0.75 * kMarkSize}, MessageId::DrawChartDominated);
    const auto& points = source.table.points;
    if (std::any_of(points.begin(), points.end(), [](const ParetoPoint& p) { return p.wrongOutcome > 0; })) {
        entry(Role::Layer, Marker{{}, Shape::Diamond, 0.8 * kMarkSize}, MessageId::DrawChartWrong);
    }
    if (!source.current.empty()) entry(Role::Hit, Ring{{}, 4.5}, MessageId::DrawChartCurrent);
    const auto words = [&](const Message& message) {
        rows.text(rows.place(rows.textRoom(message) + LegendRows::kBetween), message);
    };
    if (!source.table.leftOut.empty()) {
        words(Message(MessageId::DrawChartLeftOut, {{"methods", joined(source.table.leftOut)}}));
    }
    if (!source.table.cpu.empty()) {
        words(Message(
            MessageId::DrawChartMachine,
            {{"cpu", source.table.cpu}, {"threads", source.table.threads}, {"compiler", source.table.compiler}}));
    }
    return rows.take();
}

std::optional<std::size_t> paretoPointAt(const ParetoPicture& picture, Point at) {
    std::optional<std::size_t> nearest;
    double best = kReach;
    for (const ParetoMark& mark : picture.marks) {
        const double away = std::hypot(mark.at.x - at.x, mark.at.y - at.y);
        if (away < best) best = away, nearest = mark.point;
    }
    if (nearest) return nearest;
    for (const ParetoMark& mark : picture.marks) {
        if (mark.label.contains(at)) return mark.point;
    }
    return std::nullopt;
}

}  // namespace reliefui
