#include "drawings/qpainter_painter.h"

#include <cmath>

#include <QFont>
#include <QFontMetricsF>
#include <QImage>

#include "drawings/cell_image.h"

namespace reliefui {

namespace {

QColor qcolor(Rgba c) {
    return QColor(c.r, c.g, c.b, c.a);
}
QPointF qpoint(Point p) {
    return {p.x, p.y};
}
QRectF qrect(const Box& b) {
    return {b.x0, b.y0, b.width(), b.height()};
}
QPen qpen(const Stroke& stroke) {
    QPen pen(qcolor(stroke.color), stroke.width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
    if (stroke.dash.empty()) return pen;
    QVector<qreal> dash;
    for (const double part : stroke.dash) dash.push_back(part / stroke.width);
    pen.setDashPattern(dash);
    return pen;
}

// Paints all but labels, which come last.
struct ItemPainter {
    QPainter& painter;
    const ViewMap& map;
    const Style& style;
    const Box& screen;
    const Item& item;

    Stroke stroke() const { return style.stroke(item); }
    QPen haloPen(double width) const {
        return QPen(qcolor(style.halo()), width + 2 * style.screenPixelsPerPoint * 0.7, Qt::SolidLine, Qt::FlatCap,
                    Qt::MiterJoin);
    }

    void operator()(const Rectangle& r) const {
        const Box box = screenBox(r, map, style.pixelsPerPoint());
        if (!box.overlaps(screen.grown(50))) return;
        if (r.fill) painter.fillRect(qrect(box), qcolor(style.fill(item)));
        if (r.fill && item.emphasis != Emphasis::Strong) return;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(qpen(stroke()));
        painter.drawRect(qrect(box));
    }

    void operator()(const Cells& cells) const {
        const CellRange range = visibleCells(cells, map.toDrawing(screen));
        if (range.count() <= 0) return;
        constexpr std::int64_t kVectorCells = 4096;
        if (range.count() <= kVectorCells) {
            vectorCells(cells, range);
        } else {
            rasterCells(cells);
        }
    }

    void vectorCells(const Cells& cells, const CellRange& range) const {
        const double side = std::min(cells.cellWidth, cells.cellHeight) * map.scale;
        const CellText text = cellText(cells, range, map.scale, style);
        QFont font("DejaVu Sans");
        if (text.pixels > 0) font.setPixelSize(std::max(1, static_cast<int>(text.pixels)));
        painter.setFont(font);
        for (int j = range.j0; j < range.j1; ++j) {
            for (int i = range.i0; i < range.i1; ++i) {
                const float value = (*cells.values)(i, j);
                const Rgba color = style.cell(cells.map, static_cast<double>(value), cells.low, cells.high);
                const QRectF box = qrect(map.toScreen(cellBox(cells, i, j)));
                painter.setRenderHint(QPainter::Antialiasing, false);
                painter.fillRect(box, qcolor(color));
                painter.setRenderHint(QPainter::Antialiasing, true);
                if (side >= 8 * style.pixelsPerPoint()) {
                    painter.setBrush(Qt::NoBrush);
                    painter.setPen(qpen(style.stroke(Role::Grid, Emphasis::Normal)));
                    painter.drawRect(box);
                }
                if (!textFits(text, box.width(), box.height())) continue;
                painter.setPen(qcolor(Style::textOn(color)));
                painter.drawText(box, Qt::AlignCenter, QString::fromStdString(cellValueText(cells, value, text)));
            }
        }
    }

    void rasterCells(const Cells& cells) const {
        const CellImage pixels = cellImage(cells, style);
        const QImage image(pixels.rgb.data(), pixels.width, pixels.height, pixels.width * 3, QImage::Format_RGB888);
        const Box whole{cells.x, cells.y, cells.x + pixels.width * pixels.step * cells.cellWidth,
                        cells.y + pixels.height * pixels.step * cells.cellHeight};
        painter.save();
        painter.setClipRect(qrect(map.toScreen(cells.clip)), Qt::IntersectClip);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, map.scale * cells.cellWidth * pixels.step < 1);
        painter.drawImage(qrect(map.toScreen(whole)), image);
        painter.restore();
    }

    void operator()(const Area& area) const {
        if (area.line.size() < 2) return;
        QPolygonF polygon;
        polygon << qpoint(map.toScreen(Point{area.line.front().x, area.base}));
        for (const Point& p : area.line) polygon << qpoint(map.toScreen(p));
        polygon << qpoint(map.toScreen(Point{area.line.back().x, area.base}));
        painter.setPen(Qt::NoPen);
        painter.setBrush(qcolor(style.fill(item)));
        painter.drawPolygon(polygon);
    }

    void operator()(const Polyline& line) const {
        if (line.points.size() < 2) return;
        QPolygonF polygon;
        for (const Point& p : line.points) polygon << qpoint(map.toScreen(p));
        const Stroke s = stroke();
        painter.setBrush(Qt::NoBrush);
        if (hasHalo(item)) {
            painter.setPen(haloPen(s.width));
            painter.drawPolyline(polygon);
        }
        painter.setPen(qpen(s));
        painter.drawPolyline(polygon);
        if (!line.arrow) return;
        const QPointF tip = polygon.last();
        const QPointF back = tip - polygon[polygon.size() - 2];
        const double angle = std::atan2(back.y(), back.x()) * 180 / M_PI;
        painter.save();
        painter.translate(tip);
        painter.rotate(angle);
        painter.setPen(Qt::NoPen);
        painter.setBrush(qcolor(s.color));
        const QPolygonF head(
            {QPointF(0, 0), QPointF(-5 * s.width, -2.4 * s.width), QPointF(-5 * s.width, 2.4 * s.width)});
        painter.drawPolygon(head);
        painter.restore();
    }

    void operator()(const Circle& c) const {
        Stroke s = stroke();
        if (c.rim) s = {Style::rim(), Style::rimWidth(s.width, c.radius * map.scale), {}};
        painter.setPen(qpen(s));
        painter.setBrush(c.fill ? QBrush(qcolor(style.fill(item))) : QBrush(Qt::NoBrush));
        painter.drawEllipse(qpoint(map.toScreen(c.center)), c.radius * map.scale, c.radius * map.scale);
    }

    void operator()(const Ring& r) const {
        const Stroke s = stroke();
        const double radius = r.radius * style.pixelsPerPoint();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(qcolor(style.halo()), s.width * 2.6));
        painter.drawEllipse(qpoint(map.toScreen(r.center)), radius, radius);
        painter.setPen(QPen(qcolor(s.color), s.width));
        painter.drawEllipse(qpoint(map.toScreen(r.center)), radius, radius);
    }

    void operator()(const Marker& m) const {
        const double size = m.size * style.pixelsPerPoint();
        const QPointF at = qpoint(map.toScreen(m.at));
        const Stroke s = stroke();
        const double r = size / 2;
        painter.setPen(shapeFilled(m.shape) ? QPen(qcolor(style.halo()), s.width * 0.6)
                                            : QPen(qcolor(s.color), s.width));
        painter.setBrush(shapeFilled(m.shape) ? QBrush(qcolor(s.color)) : QBrush(Qt::NoBrush));
        if (m.shape == Shape::Cross) {
            painter.setPen(QPen(qcolor(s.color), s.width * 1.5));
            painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
            painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
            return;
        }
        if (m.shape == Shape::Dot || m.shape == Shape::DotSmall || m.shape == Shape::Ring) {
            const double radius = m.shape == Shape::DotSmall ? r * 0.6 : r;
            painter.drawEllipse(at, radius, radius);
            return;
        }
        QPolygonF polygon;
        for (const Point& p : shapePolygon(m.shape, size)) polygon << at + qpoint(p);
        painter.drawPolygon(polygon);
    }

    void operator()(const Hatch& h) const {
        painter.fillRect(qrect(map.toScreen(h.box)), QBrush(qcolor(style.color(item.role)), Qt::BDiagPattern));
    }

    void operator()(const Label&) const {}
};

void paintLabel(QPainter& painter, const Item& item, const Label& label, const ViewMap& map, const Style& style,
                LabelRoom& room, const Box& screen) {
    QFont font("DejaVu Sans");
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(style.textPixels(label.size)))));
    font.setBold(item.emphasis == Emphasis::Strong && !label.plate);
    const QString text = QString::fromStdString(labelText(label, style.language));
    const QFontMetricsF metrics(font);
    const double pad = label.plate ? 0.28 * font.pixelSize() : 0;
    const double width = metrics.horizontalAdvance(text) + 2 * pad;
    const double height = metrics.height() * 0.92 + (label.plate ? 0 : 1);
    const Box box = labelBox(label, map, width, height, style.pixelsPerPoint());
    if (box.empty() || !box.overlaps(screen)) return;
    if (!room.place(box) && label.yields) return;
    Rgba color = style.color(item);
    if (label.plate && item.emphasis == Emphasis::Faint) color.a = kFaintPlate;
    if (label.plate) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(qcolor(color));
        painter.drawRoundedRect(qrect(box), pad, pad);
        color = Style::textOn(color);
    }
    painter.setFont(font);
    painter.setPen(qcolor(color));
    painter.drawText(qrect(box), Qt::AlignCenter | Qt::TextDontClip, text);
}

}  // namespace

void paint(QPainter& painter, const Drawing& drawing, const ViewMap& map, const Style& style, const Box& screen) {
    painter.setRenderHint(QPainter::Antialiasing, true);
    for (const Item& item : drawing.items) {
        std::visit(ItemPainter{painter, map, style, screen, item}, item.primitive);
    }
    LabelRoom room;
    for (const bool strong : {true, false}) {
        for (const Item& item : drawing.items) {
            const auto* label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || strong != (item.emphasis == Emphasis::Strong)) continue;
            paintLabel(painter, item, *label, map, style, room, screen);
        }
    }
}

namespace {

constexpr double kFigureMargin = 6;  // points

// The legend is made in points; it shrinks rather than leave the page.
double legendScale(const Drawing& legend, const Box& page, const Style& style) {
    const double room = page.width() - 2 * kFigureMargin * style.pixelsPerPoint();
    const double scale = style.pixelsPerPoint();
    return legend.bounds.width() * scale > room ? room / legend.bounds.width() : scale;
}

double legendHeight(const Drawing& legend, const Box& page, const Style& style) {
    if (legend.bounds.empty()) return 0;
    return legend.bounds.height() * legendScale(legend, page, style) + kFigureMargin * style.pixelsPerPoint();
}

}  // namespace

Box figureRoom(const Drawing& legend, const Box& page, const Style& style) {
    const double margin = kFigureMargin * style.pixelsPerPoint();
    return {page.x0 + margin, page.y0 + margin, page.x1 - margin, page.y1 - margin - legendHeight(legend, page, style)};
}

void paintFigure(QPainter& painter, const std::vector<const Drawing*>& layers, const Drawing& legend, const Box& page,
                 const Style& style) {
    painter.fillRect(qrect(page), qcolor(style.background()));
    ViewMap legendMap;
    legendMap.scale = legendScale(legend, page, style);
    legendMap.dx = page.x0 + kFigureMargin * style.pixelsPerPoint() - legend.bounds.x0 * legendMap.scale;
    legendMap.dy = page.y1 - legendHeight(legend, page, style) - legend.bounds.y0 * legendMap.scale;
    Box bounds;
    for (const Drawing* layer : layers) bounds = bounds.joined(layer->bounds);
    const ViewMap map = ViewMap::fitting(bounds, figureRoom(legend, page, style));
    for (const Drawing* layer : layers) paint(painter, *layer, map, style, page);
    paint(painter, legend, legendMap, style, page);
}

}  // namespace reliefui
