#include "drawings/vtk_context_painter.h"

#include <cmath>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include "drawings/cell_image.h"
#include "drawings/vtk_cell_texture.h"
#include "drawings/vtk_text.h"

namespace reliefui {

// One drawing in one frame. Lines of one stroke are gathered and drawn together.
struct VtkContextPainter::Pass {
    VtkContextPainter& owner;
    const ViewMap& map;
    const Style& style;
    const Box screen;
    const Item* item = nullptr;
    std::vector<float> lines{};
    Stroke stroke{};

    vtkContext2D& context() const { return *owner.context_; }
    float flip(double y) const { return static_cast<float>(owner.height_ - y); }

    void setPen(const Stroke& s) const {
        context().GetPen()->SetColor(s.color.r, s.color.g, s.color.b, s.color.a);
        context().GetPen()->SetWidth(static_cast<float>(s.width));
        context().GetPen()->SetLineType(vtkPen::SOLID_LINE);
    }
    void setBrush(Rgba c) const { context().GetBrush()->SetColor(c.r, c.g, c.b, c.a); }

    void flush() {
        if (lines.empty()) return;
        setPen(stroke);
        context().DrawLines(lines.data(), static_cast<int>(lines.size() / 2));
        lines.clear();
    }
    void line(Point a, Point b) {
        for (const float number : {static_cast<float>(a.x), flip(a.y), static_cast<float>(b.x), flip(b.y)}) {
            lines.push_back(number);
        }
    }
    // `carry`: where in the dash pattern the line begins; updated.
    void dashed(Point a, Point b, double& carry);
    void begin(const Stroke& s) {
        if (s.color == stroke.color && s.width == stroke.width && s.dash == stroke.dash) return;
        flush();
        stroke = s;
    }
    void polyline(const std::vector<Point>& points) {
        double carry = 0;
        for (std::size_t k = 1; k < points.size(); ++k) dashed(points[k - 1], points[k], carry);
    }
    void outline(const Box& box);
    void polygon(const std::vector<Point>& points, Point at, Rgba fill) {
        flush();
        context().GetPen()->SetLineType(vtkPen::NO_PEN);
        setBrush(fill);
        std::vector<float> corners;
        for (const Point& p : points) {
            corners.push_back(static_cast<float>(at.x + p.x));
            corners.push_back(flip(at.y + p.y));
        }
        context().DrawPolygon(corners.data(), static_cast<int>(points.size()));
    }
    void fillBox(const Box& box, Rgba fill) {
        flush();
        context().GetPen()->SetLineType(vtkPen::NO_PEN);
        setBrush(fill);
        context().DrawRect(static_cast<float>(box.x0), flip(box.y1), static_cast<float>(box.width()),
                           static_cast<float>(box.height()));
    }
    void ring(Point at, double radius, double width, Rgba color) {
        flush();
        context().GetPen()->SetLineType(vtkPen::NO_PEN);
        setBrush(color);
        const auto outer = static_cast<float>(radius + width / 2);
        const auto inner = static_cast<float>(std::max(0.0, radius - width / 2));
        context().DrawEllipseWedge(static_cast<float>(at.x), flip(at.y), outer, outer, inner, inner, 0, 360);
    }
    void text(const std::string& words, const Box& box, double pixels, Rgba color, bool bold) {
        flush();
        vtkTextProperty* property = context().GetTextProp();
        setText(property, color, pixels);
        property->SetBold(bold);
        property->SetJustificationToCentered();
        property->SetVerticalJustificationToCentered();
        // VTK centres on the ink of the letters; whole pixels keep the glyphs sharp.
        context().DrawString(static_cast<float>(std::round(box.center().x)), std::round(flip(box.center().y)),
                             words.c_str());
    }

    void operator()(const Rectangle& r);
    void operator()(const Cells& cells);
    void smallCells(const Cells& cells, const CellRange& range);
    void operator()(const Area& area);
    void operator()(const Polyline& l);
    void operator()(const Circle& c);
    void operator()(const Ring& r);
    void operator()(const Marker& m);
    void operator()(const Hatch& h);
    void operator()(const Label&) {}
    void label(const Label& l, LabelRoom& room);
};

void VtkContextPainter::Pass::dashed(Point a, Point b, double& carry) {
    if (stroke.dash.empty()) {
        line(a, b);
        return;
    }
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double period = 0;
    for (const double part : stroke.dash) period += part;
    // Far more dashes than fit on a screen: a line that is mostly outside.
    if (length <= 0 || length > 4000 * period) return;
    const auto at = [&](double d) { return Point{a.x + (b.x - a.x) * d / length, a.y + (b.y - a.y) * d / length}; };
    for (double from = -carry; from < length; from += period) {
        double start = from;
        for (std::size_t k = 0; k + 1 < stroke.dash.size(); k += 2) {
            const double end = start + stroke.dash[k];
            if (end > 0 && start < length) line(at(std::max(0.0, start)), at(std::min(length, end)));
            start = end + stroke.dash[k + 1];
        }
    }
    carry = std::fmod(carry + length, period);
}

void VtkContextPainter::Pass::outline(const Box& box) {
    // Whole pixels, and corners closed by half a width.
    const double x0 = std::round(box.x0) + 0.5;
    const double y0 = std::round(box.y0) + 0.5;
    const double x1 = std::round(box.x1) - 0.5;
    const double y1 = std::round(box.y1) - 0.5;
    const double corner = stroke.dash.empty() ? stroke.width / 2 : 0;
    double carry = 0;
    dashed({x0 - corner, y0}, {x1 + corner, y0}, carry);
    carry = 0;
    dashed({x0 - corner, y1}, {x1 + corner, y1}, carry);
    carry = 0;
    dashed({x0, y0}, {x0, y1}, carry);
    carry = 0;
    dashed({x1, y0}, {x1, y1}, carry);
}

void VtkContextPainter::Pass::operator()(const Rectangle& r) {
    const Box whole = screenBox(r, map, style.pixelsPerPoint());
    if (!whole.overlaps(screen.grown(50))) return;
    // Far zoomed in, only what is near the screen: dashes are counted out.
    const Box box = whole.cut(screen.grown(100));
    if (r.fill) fillBox(box.cut(screen), style.fill(*item));
    if (r.fill && item->emphasis != Emphasis::Strong) return;
    begin(style.stroke(*item));
    outline(box);
}

void VtkContextPainter::Pass::operator()(const Cells& cells) {
    const CellRange range = visibleCells(cells, map.toDrawing(screen));
    if (range.count() <= 0) return;
    flush();
    VtkCellTexture* texture = nullptr;
    for (const auto& known : owner.textures_) {
        if (known->serves(cells, style)) texture = known.get();
    }
    if (texture == nullptr) {
        texture = owner.textures_.emplace_back(std::make_unique<VtkCellTexture>(cells, style)).get();
    }
    texture->used = true;
    const double side = std::min(cells.cellWidth, cells.cellHeight) * map.scale;
    constexpr std::int64_t kMostSmallCells = 20000;
    if (side >= 8 * style.pixelsPerPoint() && range.count() <= kMostSmallCells) {
        smallCells(cells, range);
    } else {
        texture->draw(cells, map, style, screen, owner.height_, owner.viewport_);
    }
}

void VtkContextPainter::Pass::smallCells(const Cells& cells, const CellRange& range) {
    const auto colorOf = [&](int i, int j) {
        return style.cell(cells.map, static_cast<double>((*cells.values)(i, j)), cells.low, cells.high);
    };
    for (int j = range.j0; j < range.j1; ++j) {
        for (int i = range.i0; i < range.i1; ++i) {
            const Box box = map.toScreen(cellBox(cells, i, j)).cut(screen.grown(2));
            fillBox({std::round(box.x0), std::round(box.y0), std::round(box.x1), std::round(box.y1)}, colorOf(i, j));
        }
    }
    begin(style.stroke(Role::Grid, Emphasis::Normal));
    const Box all = map.toScreen(cells.clip).cut(screen.grown(2));
    for (int j = range.j0; j <= range.j1; ++j) {
        const double y = std::round(map.toScreen(Point{0, cells.y + j * cells.cellHeight}).y) + 0.5;
        if (y >= all.y0 && y <= all.y1) line({all.x0, y}, {all.x1, y});
    }
    for (int i = range.i0; i <= range.i1; ++i) {
        const double x = std::round(map.toScreen(Point{cells.x + i * cells.cellWidth, 0}).x) + 0.5;
        if (x >= all.x0 && x <= all.x1) line({x, all.y0}, {x, all.y1});
    }
    flush();
    const CellText size = cellText(cells, range, map.scale, style);
    if (size.pixels <= 0) return;
    for (int j = range.j0; j < range.j1; ++j) {
        for (int i = range.i0; i < range.i1; ++i) {
            const Box box = map.toScreen(cellBox(cells, i, j)).cut(screen);
            if (!textFits(size, box.width(), box.height())) continue;
            const std::string value = cellValueText(cells, (*cells.values)(i, j), size);
            if (value.empty()) continue;
            text(value, box, size.pixels, Style::textOn(colorOf(i, j)), false);
        }
    }
}

void VtkContextPainter::Pass::operator()(const Area& area) {
    if (area.line.size() < 2) return;
    flush();
    context().GetPen()->SetLineType(vtkPen::NO_PEN);
    setBrush(style.fill(*item));
    std::vector<float> strip;
    const float base = flip(map.toScreen(Point{0, area.base}).y);
    for (const Point& p : area.line) {
        const Point at = map.toScreen(p);
        for (const float number : {static_cast<float>(at.x), flip(at.y), static_cast<float>(at.x), base}) {
            strip.push_back(number);
        }
    }
    context().DrawQuadStrip(strip.data(), static_cast<int>(strip.size() / 2));
}

void VtkContextPainter::Pass::operator()(const Polyline& l) {
    if (l.points.size() < 2) return;
    std::vector<Point> points;
    for (const Point& p : l.points) points.push_back(map.toScreen(p));
    const Stroke own = style.stroke(*item);
    if (hasHalo(*item)) {
        begin({style.halo(), own.width + 2 * style.screenPixelsPerPoint * 0.7, {}});
        polyline(points);
    }
    begin(own);
    polyline(points);
    if (!l.arrow) return;
    const Point tip = points.back();
    const Point from = points[points.size() - 2];
    const double length = std::hypot(tip.x - from.x, tip.y - from.y);
    if (length <= 0) return;
    const Point d{(tip.x - from.x) / length * own.width, (tip.y - from.y) / length * own.width};
    polygon({{0, 0}, {-5 * d.x - 2.4 * d.y, -5 * d.y + 2.4 * d.x}, {-5 * d.x + 2.4 * d.y, -5 * d.y - 2.4 * d.x}}, tip,
            own.color);
}

void VtkContextPainter::Pass::operator()(const Circle& c) {
    const Stroke own = style.stroke(*item);
    const Point at = map.toScreen(c.center);
    if (c.fill) ring(at, c.radius * map.scale / 2, c.radius * map.scale, style.fill(*item));
    const double radius = c.radius * map.scale;
    ring(at, radius, c.rim ? Style::rimWidth(own.width, radius) : own.width, c.rim ? Style::rim() : own.color);
}

void VtkContextPainter::Pass::operator()(const Ring& r) {
    const Stroke own = style.stroke(*item);
    const double radius = r.radius * style.pixelsPerPoint();
    ring(map.toScreen(r.center), radius, own.width * 2.6, style.halo());
    ring(map.toScreen(r.center), radius, own.width, own.color);
}

void VtkContextPainter::Pass::operator()(const Marker& m) {
    const double size = m.size * style.pixelsPerPoint();
    const Point at = map.toScreen(m.at);
    const Stroke own = style.stroke(*item);
    const Rgba color = own.color;
    const double r = size / 2;
    if (m.shape == Shape::Cross) {
        begin({color, own.width * 1.5, {}});
        line({at.x - r, at.y - r}, {at.x + r, at.y + r});
        line({at.x - r, at.y + r}, {at.x + r, at.y - r});
    } else if (m.shape == Shape::Ring) {
        ring(at, r, own.width, color);
    } else if (m.shape == Shape::Dot || m.shape == Shape::DotSmall) {
        const double radius = m.shape == Shape::DotSmall ? r * 0.6 : r;
        ring(at, radius / 2, radius, color);
        ring(at, radius, own.width * 0.6, style.halo());
    } else if (shapeFilled(m.shape)) {
        polygon(shapePolygon(m.shape, size), at, color);
    } else {
        std::vector<Point> points = shapePolygon(m.shape, size);
        for (Point& p : points) p = {p.x + at.x, p.y + at.y};
        points.push_back(points.front());
        begin({color, own.width, {}});
        polyline(points);
    }
}

void VtkContextPainter::Pass::operator()(const Hatch& h) {
    const Box box = map.toScreen(h.box).cut(screen);
    if (box.empty()) return;
    begin(style.stroke(item->role, Emphasis::Faint));
    const double gap = 5 * style.pixelsPerPoint();
    for (double c = std::floor((box.x0 + box.y0) / gap) * gap; c < box.x1 + box.y1; c += gap) {
        const double xa = std::max(box.x0, c - box.y1);
        const double xb = std::min(box.x1, c - box.y0);
        if (xa < xb) line({xa, c - xa}, {xb, c - xb});
    }
}

void VtkContextPainter::Pass::label(const Label& l, LabelRoom& room) {
    const double pixels = std::round(style.textPixels(l.size));
    const std::string words = labelText(l, style.language);
    const bool bold = item->emphasis == Emphasis::Strong && !l.plate;
    const double pad = l.plate ? 0.28 * pixels : 0;
    const double width = textWidth(words, pixels) * (bold ? 1.1 : 1.0) + 2 * pad;
    const double height = pixels * 1.16;
    const Box box = labelBox(l, map, width, height, style.pixelsPerPoint());
    if (box.empty() || !box.overlaps(screen)) return;
    if (!room.place(box) && l.yields) return;
    Rgba color = style.color(*item);
    if (l.plate && item->emphasis == Emphasis::Faint) color.a = kFaintPlate;
    if (l.plate) {
        fillBox(box, color);
        color = Style::textOn(color);
    }
    text(words, box, pixels, color, bold);
}

VtkContextPainter::VtkContextPainter() = default;
VtkContextPainter::~VtkContextPainter() = default;

void VtkContextPainter::begin(vtkContext2D* context, vtkViewport* viewport, int width, int height) {
    context_ = context;
    viewport_ = viewport;
    width_ = width;
    height_ = height;
    for (const auto& texture : textures_) texture->used = false;
}

void VtkContextPainter::paint(const Drawing& drawing, const ViewMap& map, const Style& style) {
    Pass pass{*this, map, style, Box{0, 0, static_cast<double>(width_), static_cast<double>(height_)}};
    for (const Item& item : drawing.items) {
        pass.item = &item;
        std::visit(pass, item.primitive);
    }
    pass.flush();
    LabelRoom room;
    for (const bool strong : {true, false}) {
        for (const Item& item : drawing.items) {
            const auto* label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || strong != (item.emphasis == Emphasis::Strong)) continue;
            pass.item = &item;
            pass.label(*label, room);
        }
    }
    pass.flush();
}

void VtkContextPainter::end(vtkWindow* window) {
    std::erase_if(textures_, [&](const std::unique_ptr<VtkCellTexture>& texture) {
        if (!texture->used) texture->release(window);
        return !texture->used;
    });
}

}  // namespace reliefui
