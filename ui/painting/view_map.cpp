#include "painting/view_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefui {

ViewMap ViewMap::fitting(const Box& bounds, const Box& screen) {
    ViewMap map;
    if (bounds.width() <= 0 || bounds.height() <= 0 || screen.empty()) return map;
    map.scale = std::min(screen.width() / bounds.width(), screen.height() / bounds.height());
    if (!(map.scale > 0)) map.scale = 1;
    map.dx = screen.center().x - bounds.center().x * map.scale;
    map.dy = screen.center().y - bounds.center().y * map.scale;
    return map;
}

Box screenBox(const Rectangle& rectangle, const ViewMap& map, double pixelsPerPoint) {
    Box box = map.toScreen(rectangle.box);
    const double smallest = rectangle.minSide * pixelsPerPoint;
    const auto grow = [&](double& low, double& high) {
        const double lack = (smallest - (high - low)) / 2;
        if (lack > 0) {
            low -= lack;
            high += lack;
        }
        // Limits the inset so that it never inverts a box.
        const double inset = std::min(rectangle.inset * pixelsPerPoint, (high - low) / 3);
        low += inset;
        high -= inset;
    };
    grow(box.x0, box.x1);
    grow(box.y0, box.y1);
    return box;
}

CellRange visibleCells(const Cells& cells, const Box& visible) {
    CellRange range;
    if (!cells.values) return range;
    const Box seen = visible.cut(cells.clip);
    if (seen.empty()) return range;
    const auto first = [](double low, double start, double side, int count) {
        return static_cast<int>(std::clamp(std::floor((low - start) / side), 0.0, static_cast<double>(count)));
    };
    const auto last = [](double high, double start, double side, int count) {
        return static_cast<int>(std::clamp(std::ceil((high - start) / side), 0.0, static_cast<double>(count)));
    };
    range.i0 = first(seen.x0, cells.x, cells.cellWidth, cells.values->width());
    range.i1 = last(seen.x1, cells.x, cells.cellWidth, cells.values->width());
    range.j0 = first(seen.y0, cells.y, cells.cellHeight, cells.values->height());
    range.j1 = last(seen.y1, cells.y, cells.cellHeight, cells.values->height());
    return range;
}

Box cellBox(const Cells& cells, int i, int j) {
    const Box box{cells.x + i * cells.cellWidth, cells.y + j * cells.cellHeight, cells.x + (i + 1) * cells.cellWidth,
                  cells.y + (j + 1) * cells.cellHeight};
    return box.cut(cells.clip);
}

namespace {

ItemId texelUnder(const Item& item, const Cells& cells, Point p) {
    if (!cells.clip.contains(p)) return {};
    const CellRange range = visibleCells(cells, {p.x, p.y, p.x, p.y});
    const int i = std::min(range.i0, cells.values->width() - 1);
    const int j = std::min(range.j0, cells.values->height() - 1);
    ItemId id = item.id;
    id.kind = ItemKind::Texel;
    id.i = i + cells.firstI;
    id.j = j + cells.firstJ;
    return id;
}

bool near(Point a, Point b, double distance) {
    return std::hypot(a.x - b.x, a.y - b.y) <= distance;
}

double distanceToSegment(Point p, Point a, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

struct Picker {
    const Item& item;
    const ViewMap& map;
    Point at;  // on the screen
    double pixelsPerPoint;
    double tolerance;

    ItemId here(bool hit) const { return hit ? item.id : ItemId{}; }

    ItemId operator()(const Rectangle& r) const { return here(screenBox(r, map, pixelsPerPoint).contains(at)); }
    ItemId operator()(const Cells& c) const { return texelUnder(item, c, map.toDrawing(at)); }
    ItemId operator()(const Area&) const { return {}; }
    ItemId operator()(const Polyline& line) const {
        for (std::size_t k = 1; k < line.points.size(); ++k) {
            const Point a = map.toScreen(line.points[k - 1]);
            const Point b = map.toScreen(line.points[k]);
            if (distanceToSegment(at, a, b) <= tolerance) return item.id;
        }
        return {};
    }
    ItemId operator()(const Circle& c) const {
        return here(near(map.toScreen(c.center), at, c.radius * map.scale + tolerance));
    }
    ItemId operator()(const Ring& r) const {
        return here(near(map.toScreen(r.center), at, r.radius * pixelsPerPoint + tolerance));
    }
    ItemId operator()(const Marker& m) const {
        return here(near(map.toScreen(m.at), at, m.size * pixelsPerPoint / 2 + tolerance));
    }
    ItemId operator()(const Hatch& h) const { return here(map.toScreen(h.box).contains(at)); }
    ItemId operator()(const Label&) const { return {}; }
};

}  // namespace

ItemId pick(const Drawing& drawing, const ViewMap& map, Point at, double pixelsPerPoint, double tolerance) {
    for (auto item = drawing.items.rbegin(); item != drawing.items.rend(); ++item) {
        if (!item->id) continue;
        if (const ItemId id = std::visit(Picker{*item, map, at, pixelsPerPoint, tolerance}, item->primitive)) {
            return id;
        }
    }
    return {};
}

bool LabelRoom::free(const Box& box) const {
    return std::none_of(placed_.begin(), placed_.end(), [&](const Box& other) { return other.overlaps(box); });
}

bool LabelRoom::place(const Box& box) {
    if (!free(box)) return false;
    take(box);
    return true;
}

Box labelBox(const Label& label, const ViewMap& map, double width, double height, double pixelsPerPoint) {
    if (!label.room.empty()) {
        const Box room = map.toScreen(label.room);
        const bool fits = room.width() >= width + 2 && room.height() >= height + 2;
        if (!fits && !label.evades) return {};
        // A label that does not fit into its texel is placed to its upper right.
        if (!fits) {
            const double x = std::max(room.x1, room.center().x + 3 * pixelsPerPoint) + pixelsPerPoint;
            const double y = std::min(room.y0, room.center().y - 3 * pixelsPerPoint) - pixelsPerPoint;
            return {x, y - height, x + width, y};
        }
    }
    Point at = map.toScreen(label.at);
    at.x += label.offset.x * pixelsPerPoint;
    at.y += label.offset.y * pixelsPerPoint;
    double x = at.x;
    double y = at.y - height / 2;
    switch (label.anchor) {
        case Anchor::TopLeft:
            y = at.y;
            break;
        case Anchor::Left:
            break;
        case Anchor::BottomLeft:
            y = at.y - height;
            break;
        case Anchor::Center:
            x = at.x - width / 2;
            break;
        case Anchor::Top:
            x = at.x - width / 2;
            y = at.y;
            break;
        case Anchor::Bottom:
            x = at.x - width / 2;
            y = at.y - height;
            break;
        case Anchor::Right:
            x = at.x - width;
            break;
    }
    return {x, y, x + width, y + height};
}

bool clip(Segment& segment, const Box& box) {
    double from = 0;
    double to = 1;
    const double dx = segment.second.x - segment.first.x;
    const double dy = segment.second.y - segment.first.y;
    const auto slab = [&](double origin, double run, double low, double high) {
        if (run == 0) return origin >= low && origin <= high;
        const double a = (low - origin) / run;
        const double b = (high - origin) / run;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
        return from <= to;
    };
    if (!slab(segment.first.x, dx, box.x0, box.x1) || !slab(segment.first.y, dy, box.y0, box.y1)) return false;
    const Point origin = segment.first;
    if (to < 1) segment.second = {origin.x + to * dx, origin.y + to * dy};
    if (from > 0) segment.first = {origin.x + from * dx, origin.y + from * dy};
    return true;
}

std::vector<std::vector<Point>> clippedTo(const std::vector<Point>& line, const Box& box, std::vector<double>* before) {
    std::vector<std::vector<Point>> runs;
    double length = 0;
    bool open = false;  // the current piece continues with the next segment
    for (std::size_t k = 1; k < line.size(); ++k) {
        const Point a = line[k - 1];
        const Point b = line[k];
        Segment piece{a, b};
        const bool seen = clip(piece, box);
        if (seen && (!open || !(piece.first == a))) {
            runs.push_back({piece.first});
            if (before != nullptr) before->push_back(length + std::hypot(piece.first.x - a.x, piece.first.y - a.y));
        }
        if (seen) runs.back().push_back(piece.second);
        open = seen && piece.second == b;
        if (before != nullptr) length += std::hypot(b.x - a.x, b.y - a.y);
    }
    return runs;
}

std::vector<Point> ellipseLine(Point centre, Point a, Point b) {
    constexpr int kAround = 120;
    std::vector<Point> line;
    for (int n = 0; n <= kAround; ++n) {
        const double angle = std::numbers::pi + 2 * std::numbers::pi * n / kAround;
        const double x = std::cos(angle), y = std::sin(angle);
        line.push_back({centre.x + a.x * x + b.x * y, centre.y + a.y * x + b.y * y});
    }
    return line;
}

void addLine(Drawing& drawing, const std::vector<Point>& line, const Box& plot, ItemId id, Role role, Emphasis emphasis,
             LevelTint tint) {
    for (std::vector<Point>& run : clippedTo(line, plot)) {
        drawing.add(id, role, Polyline{std::move(run)}, emphasis, tint);
    }
}

void addFill(Drawing& drawing, const std::vector<Point>& line, double y, const Box& plot, Role role) {
    Area area;
    area.base = std::clamp(y, plot.y0, plot.y1);
    for (const Point& p : line) {
        if (p.x >= plot.x0 && p.x <= plot.x1) area.line.push_back({p.x, std::clamp(p.y, plot.y0, plot.y1)});
    }
    drawing.add({}, role, std::move(area), Emphasis::Faint);
}

void addEllipse(Drawing& drawing, Point centre, double rx, double ry, const Box& plot, ItemId id, Role role,
                Emphasis emphasis) {
    const std::vector<Point> line = ellipseLine(centre, {rx, 0}, {0, ry});
    if (emphasis == Emphasis::Strong) {
        std::vector<Point> half(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(line.size() / 2 + 1));
        addFill(drawing, half, centre.y, plot, role);
        for (Point& p : half) p.y = 2 * centre.y - p.y;
        addFill(drawing, half, centre.y, plot, role);
    }
    addLine(drawing, line, plot, id, role, emphasis);
}

std::vector<Point> shapePolygon(Shape shape, double size) {
    const double r = size / 2;
    switch (shape) {
        case Shape::Bar:
            return {{-r * 0.4, -r}, {r * 0.4, -r}, {r * 0.4, r}, {-r * 0.4, r}};
        case Shape::TriangleRight:
            return {{-r * 0.8, -r}, {r, 0}, {-r * 0.8, r}};
        case Shape::TriangleDown:
            return {{-r, -r * 0.8}, {r, -r * 0.8}, {0, r}};
        case Shape::TriangleUpHollow:
            return {{-r, r * 0.8}, {0, -r}, {r, r * 0.8}};
        case Shape::Diamond:
            return {{0, -r}, {r, 0}, {0, r}, {-r, 0}};
        case Shape::SquareHollow:
            return {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
        default:
            return {};
    }
}

bool hasHalo(const Item& item) {
    return item.emphasis != Emphasis::Faint && item.role != Role::Frame && item.role != Role::Plateau &&
           item.role != Role::Series && item.role != Role::SeriesDashed && item.role != Role::Stream;
}

bool shapeFilled(Shape shape) {
    return shape != Shape::TriangleUpHollow && shape != Shape::SquareHollow && shape != Shape::Ring;
}

}  // namespace reliefui
