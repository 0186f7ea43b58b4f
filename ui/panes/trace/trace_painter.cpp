#include "panes/trace/trace_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainterPath>

#include "painting/painter.h"
#include "painting/text_width.h"
#include "panes/trace/trace3d_marks.h"
#include "panes/trace/tubes.h"
#include "panes/trace/visible_region.h"

namespace reliefui {

namespace {

QPointF qpoint(Point p) {
    return {p.x, p.y};
}

// Moves the corners away from the middle.
QPolygonF grown(QPolygonF polygon, double by) {
    QPointF middle;
    for (const QPointF& p : polygon) middle += p / polygon.size();
    for (QPointF& p : polygon) {
        const QPointF out = p - middle;
        const double length = std::hypot(out.x(), out.y());
        if (length > 0) p += out * (by / length);
    }
    return polygon;
}

}  // namespace

Rgba faded(Rgba color, double opacity) {
    color.a = static_cast<std::uint8_t>(std::lround(color.a * opacity));
    return color;
}

void TracePainter::relief() const {
    const double point = style_.pixelsPerPoint();
    // Without lines of the mesh, each face extends under its neighbours, which are painted later: viewers antialias
    // edges, and the background would show through as hairlines.
    const double under = 0.2 * point;
    constexpr double kLeastCell = 3;  // in points; smaller cells are not outlined
    const Place middle{scene_.patch.center().x, -scene_.patch.center().y, scene_.scale};
    const bool lined = eye_.unit(middle) * mesh_.stride() >= kLeastCell * point;
    const QPen pen(toColor(faded({0, 0, 0, 255}, 0.25)), 0.3 * point, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    for (const TraceMesh::Face& face : mesh_.faces(eye_, style_.theme)) {
        const QPolygonF polygon = projected(face.corners);
        if (polygon.isEmpty()) continue;
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(toColor(face.color));
        painter_.drawPolygon(grown(polygon, under));
        if (!lined) continue;
        painter_.setPen(pen);
        for (const auto& line : face.lines) {
            QPolygonF corners;
            for (const std::size_t k : line) corners << polygon[static_cast<int>(k)];
            painter_.drawPolyline(corners);
        }
    }
}

void TracePainter::line(const std::vector<Place>& places, Rgba color, double width, bool hidden) const {
    Runs runs;
    for (std::size_t k = 1; k < places.size(); ++k) addRuns(runs, places[k - 1], places[k]);
    painter_.setBrush(Qt::NoBrush);
    for (const auto& [seen, run] : runs) {
        if (!seen && !hidden) continue;
        constexpr double kHiddenWidth = 0.6;
        QPen pen(toColor(color), seen ? width : kHiddenWidth * width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
        if (!seen) pen.setDashPattern({3, 2});
        painter_.setPen(pen);
        painter_.drawPolyline(run);
    }
}

void TracePainter::tube(const std::vector<Place>& places, double radius, Rgba color, bool hidden) const {
    const Place middle = between(places.front(), places.back(), 0.5);
    line(places, color, std::max(2 * radius * eye_.unit(middle), 0.25 * style_.pixelsPerPoint()), hidden);
}

void TracePainter::surface(const std::function<Place(double, double)>& at, Rgba color) const {
    constexpr int kCells = 64;
    const auto regions = positiveRegion(kCells, kCells, [&](double u, double v) {
        const Place p = at(u, v);
        return ahead(p) ? clearance(p) : -1;
    });
    QPainterPath path;
    for (const auto& region : regions) {
        QPolygonF polygon;
        for (const Point& p : region) polygon << qpoint(eye_.project(at(p.x, p.y)));
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    if (path.isEmpty()) return;
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(toColor(color));
    painter_.drawPath(path);
}

void TracePainter::quad(const std::array<Place, 4>& q, Rgba color) const {
    surface([&](double u, double v) { return between(between(q[0], q[1], u), between(q[3], q[2], u), v); }, color);
}

void TracePainter::ball(const BodyShape& shape, Rgba color, bool far) const {
    // In the slab's metric, where it is round.
    const double stretch = shape.stretch();
    const Place c = shape.center();
    const Place e = eye_.place();
    Place axis{e[0] - c[0], c[1] - e[1], (e[2] - c[2]) / stretch};
    const double away = std::hypot(axis[0], axis[1], axis[2]);
    if (away <= shape.body().radius) return;
    for (double& part : axis) part /= away;
    const double flat = std::hypot(axis[0], axis[1]);
    const Place u = flat > 0 ? Place{-axis[1] / flat, axis[0] / flat, 0} : Place{1, 0, 0};
    const Place v{axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0]};
    const double rim = std::acos(shape.body().radius / away);
    surface(
        [&](double around, double out) {
            const double angle = 2 * std::numbers::pi * around;
            const double polar = far ? rim + out * (std::numbers::pi - rim) : out * rim;
            Place n;
            for (std::size_t k = 0; k < 3; ++k) {
                n[k] = std::cos(polar) * axis[k] + std::sin(polar) * (std::cos(angle) * u[k] + std::sin(angle) * v[k]);
            }
            return shape.onSphere(n[0], n[1], n[2]);
        },
        color);
}

void TracePainter::disk(const Place& at, double radius, Rgba color) const {
    if (!visible(at)) return;
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(toColor(color));
    const double r = radius * eye_.unit(at);
    painter_.drawEllipse(qpoint(eye_.project(at)), r, r);
}

void TracePainter::hit(const Place& at, double radius) const {
    if (!ahead(at)) return;
    // In the pane the disk is drawn in front of a surface that it touches, as of a hit slightly below it.
    const bool seen = mesh_.clearance(at, eye_) > -kHitDisk * radius;
    const double unit = radius * eye_.unit(at);
    if (seen) {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(Qt::white);
        painter_.drawEllipse(qpoint(eye_.project(at)), kHitDisk * unit, kHitDisk * unit);
    }
    QPen pen(Qt::black, (kHitOuter - kHitInner) * unit, Qt::SolidLine, Qt::FlatCap);
    if (!seen) pen.setDashPattern({1, 1});
    painter_.setPen(pen);
    painter_.setBrush(Qt::NoBrush);
    const double r = (kHitOuter + kHitInner) / 2 * unit;
    painter_.drawEllipse(qpoint(eye_.project(at)), r, r);
}

void TracePainter::words(const Place& at, const std::string& text, double size, Anchor anchor) {
    if (!ahead(at)) return;
    const Point p = eye_.project(at);
    if (!room_.contains(p)) return;
    const double unit = style_.pixelsPerPoint();
    const double width = textWidth(text, size) * unit;
    const double height = 1.2 * style_.textPixels(size);
    const double air = 0.3 * style_.textPixels(size);
    const double x = anchor == Anchor::Right ? p.x - air - width : p.x + air;
    const double y = anchor == Anchor::TopLeft ? p.y : p.y - height;
    painter_.fillRect(QRectF(x - air / 2, y, width + air, height), toColor(faded(style_.background(), 0.7)));
    labels_.add({}, Role::Label,
                Label{.at = {anchor == Anchor::Right ? x + width : x, y + height / 2},
                      .text = plainText(text),
                      .anchor = anchor == Anchor::Right ? Anchor::Right : Anchor::Left,
                      .size = size});
}

void TracePainter::note(const std::string& text) {
    constexpr double kSize = 0.7;
    const double margin = kFigureMargin * style_.pixelsPerPoint();
    labels_.add({}, Role::Label,
                Label{.at = {room_.x0 + margin, room_.y1 - margin / 2},
                      .text = plainText(text),
                      .anchor = Anchor::BottomLeft,
                      .size = kSize});
}

void TracePainter::paintWords() const {
    paint(painter_, labels_, {}, style_, room_);
}

// Empty if a place is behind the eye, or all are outside the room.
QPolygonF TracePainter::projected(const std::vector<Place>& places) const {
    QPolygonF polygon;
    for (const Place& p : places) {
        if (!ahead(p)) return {};
        polygon << qpoint(eye_.project(p));
    }
    const bool seen = polygon.boundingRect().intersects(QRectF(room_.x0, room_.y0, room_.width(), room_.height()));
    return seen ? polygon : QPolygonF();
}

// A run that goes on extends the last one.
void TracePainter::addRun(Runs& runs, const Place& from, const Place& to, bool seen) const {
    if (!ahead(from) || !ahead(to)) return;
    const QPointF first = qpoint(eye_.project(from));
    const bool goesOn =
        !runs.empty() && runs.back().first == seen && (runs.back().second.back() - first).manhattanLength() < 1e-6;
    if (!goesOn) runs.push_back({seen, QPolygonF({first})});
    runs.back().second << qpoint(eye_.project(to));
}

// Adds the visible and the hidden runs of a segment.
void TracePainter::addRuns(Runs& runs, const Place& from, const Place& to) const {
    constexpr double kSample = 1.0 / 250;  // of the scene's diagonal
    constexpr int kMost = 500;
    constexpr int kHalvings = 10;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const int samples = std::clamp(static_cast<int>(std::ceil(length / (kSample * scene_.diagonal()))), 1, kMost);
    const auto at = [&](double f) { return between(from, to, f); };
    double begin = 0;
    bool seen = visible(from);
    for (int k = 1; k <= samples; ++k) {
        const double f = static_cast<double>(k) / samples;
        const bool now = visible(at(f));
        if (now == seen) continue;
        double low = static_cast<double>(k - 1) / samples;
        double high = f;
        for (int n = 0; n < kHalvings; ++n) {
            const double middle = (low + high) / 2;
            (visible(at(middle)) == seen ? low : high) = middle;
        }
        addRun(runs, at(begin), at(high), seen);
        begin = high;
        seen = now;
    }
    addRun(runs, at(begin), to, seen);
}

}  // namespace reliefui
