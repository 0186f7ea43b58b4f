#include "panes/charts/pareto_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::ParetoPoint;

constexpr double kTop = 32;  // in points, above the plot
constexpr double kMarkSize = 9;
constexpr double kReach = 9;  // pick radius of a click, in points

MessageId measureTitle(relief::ErrorMeasure measure) {
    constexpr MessageId kTitles[] = {MessageId::DrawChartErrorMean, MessageId::DrawChartErrorP95,
                                     MessageId::DrawChartErrorP9999, MessageId::DrawChartErrorMax};
    return kTitles[static_cast<std::size_t>(measure)];
}

// Returns false for 0, infinity and NaN, which have no place on the logarithmic scale.
bool measurable(double error) {
    return error > 0 && std::isfinite(error);
}

void setRanges(ParetoFrame& frame, const ParetoSource& source) {
    constexpr double kAround = 0.06;     // margin at the left and right, as a share of the range
    constexpr double kLeastRange = 0.3;  // in decades
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
    constexpr double kHeadroom = 0.12;  // in decades; keeps the marks clear of the frame
    frame.errorLow = std::floor(errorLow - kHeadroom);
    frame.errorHigh = std::max(std::ceil(errorHigh + kHeadroom), frame.errorLow + 1);
}

Drawing axes(const ParetoSource& source, const ParetoFrame& frame) {
    Drawing drawing;
    drawing.bounds = frame.whole;
    const chart::Axes errors(drawing, frame.plot, frame.whole);
    errors.corner(Message(measureTitle(source.measure)));
    // The time axis lies below the row of methods without error.
    Box all = frame.plot;
    all.y1 = std::max(frame.whole.y1 - chart::kBottom, all.y1);
    for (const chart::Tick& tick : chart::ticks(frame.times(), chart::Side::Below)) {
        chart::line(drawing, {tick.at, all.y0}, {tick.at, all.y1}, Role::Grid);
    }
    chart::Axes(drawing, all, frame.whole).below(frame.times(), Message(MessageId::DrawChartTime));
    errors.left(frame.errors(), true);
    errors.sides();
    if (!frame.zeros) return drawing;
    chart::line(drawing, {all.x0, frame.plot.y1 + 3}, {all.x0, all.y1});
    chart::line(drawing, {all.x0, all.y1}, {all.x1, all.y1});
    chart::line(drawing, {all.x0, frame.zero}, {all.x1, frame.zero}, Role::Grid);
    chart::line(drawing, {all.x0 - chart::kTick, frame.zero}, {all.x0, frame.zero});
    chart::text(drawing, {all.x0, frame.zero}, plainText("0"), Anchor::Right, {-chart::kTick - 2, 0});
    return drawing;
}

// The Pareto front of one form (scalar or SIMD), as a staircase: the shortest time in which a method of this form
// reaches an error.
std::vector<Point> frontLine(const ParetoSource& source, relief::Form form, const ParetoFrame& frame,
                             const std::vector<ParetoMark>& marks) {
    std::vector<Point> ends;
    for (const ParetoMark& mark : marks) {
        if (!mark.dominated && source.table.points[mark.point].form == form) ends.push_back(mark.at);
    }
    std::sort(ends.begin(), ends.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y > b.y); });
    std::vector<Point> line;
    for (const Point& end : ends) {
        // not dominated only because it has fewer wrong outcomes
        if (!line.empty() && end.y <= line.back().y) continue;
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

// Interquartile range of the rounds.
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
    // Only for a single measurement: means over several have no quartiles.
    if (source.table.cells == 1) {
        const Box line = whisker(source, frame, mark);
        drawing.add({}, role, Polyline{{{line.x0, mark.at.y}, {line.x1, mark.at.y}}, false}, Emphasis::Faint);
    }
    if (point.name == source.current) drawing.add({}, Role::Hit, Ring{mark.at, kMarkSize * 0.85});
    const Shape shape = point.wrongOutcome > 0 ? Shape::Diamond : Shape::Dot;
    drawing.add({ItemKind::Step, 0, static_cast<std::int64_t>(mark.point), 0}, role,
                Marker{mark.at, shape, mark.dominated ? 0.75 * kMarkSize : kMarkSize});
}

// Places the names next to their marks, as near as possible; those farther away get a line to the mark.
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
            box.y1 > frame.whole.y1 - chart::kBottom) {
            return false;
        }
        for (const ParetoMark& mark : picture_.marks) {
            if (!mark.label.empty() && mark.label.overlaps(box)) return false;
            const Box sign = Box{mark.at.x, mark.at.y, mark.at.x, mark.at.y}.grown(kMarkSize / 2);
            if (&mark != &own && sign.overlaps(box)) return false;
        }
        return true;
    }

    // Number of segments of the fronts, and of whiskers, that the name would cover.
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
        constexpr double kCrossing = 26;  // cost of covering a line, as an equivalent distance in points
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
        if (best == kNone) return;  // no free place; the name appears on hover
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

double ParetoFrame::yAt(double texels) const {
    if (texels == 0) return zero;
    // Not a number: no ray hits where `exact` does.
    if (!std::isfinite(texels)) return plot.y0;
    return errors().at(texels);
}

ParetoFrame paretoFrame(const ParetoSource& source, const Box& room) {
    constexpr double kMostZeroRoom = 0.42;  // as a share of the plot's height
    ParetoFrame frame;
    frame.whole = room;
    setRanges(frame, source);
    frame.plot = chart::plotIn(room, {.top = kTop});
    const double bottom = frame.plot.y1;
    std::size_t zeros = 0;
    for (const ParetoPoint& point : source.table.points) zeros += point.errorOf(source.measure) == 0 ? 1 : 0;
    // Their names need room above and below the marks.
    const double needed = zeros == 0 ? 0 : 24 + 12.0 * static_cast<double>(zeros - 1);
    const double below = std::min(needed, kMostZeroRoom * frame.plot.height());
    frame.plot.y1 = bottom - below;
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
    // Times are comparable only within a form, so each form has a front of its own.
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

void addParetoLegend(LegendRows& rows, const ParetoSource& source) {
    const auto& points = source.table.points;
    if (source.table.bothForms()) {
        rows.line(Role::Series, Message(MessageId::DrawChartSimdFront));
        rows.line(Role::Series, Message(MessageId::DrawChartScalarFront), {}, LegendRows::kLine, Emphasis::Faint);
    } else {
        rows.line(Role::Series, Message(MessageId::DrawChartFront));
    }
    rows.sign(Role::Layer, Marker{{}, Shape::Dot, 0.75 * kMarkSize}, Message(MessageId::DrawChartDominated));
    if (std::any_of(points.begin(), points.end(), [](const ParetoPoint& p) { return p.wrongOutcome > 0; })) {
        rows.sign(Role::Layer, Marker{{}, Shape::Diamond, 0.8 * kMarkSize}, Message(MessageId::DrawChartWrong));
    }
    if (!source.current.empty()) rows.sign(Role::Hit, Ring{{}, 4.5}, Message(MessageId::DrawChartCurrent));
    if (!source.table.leftOut.empty()) {
        rows.words(Message(MessageId::DrawChartLeftOut, {{"methods", joined(source.table.leftOut)}}));
    }
    if (source.table.cpu.empty()) return;
    rows.words(
        Message(MessageId::DrawChartMachine,
                {{"cpu", source.table.cpu}, {"threads", source.table.threads}, {"compiler", source.table.compiler}}));
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
