#include "painting/painter.h"

#include <algorithm>
#include <cmath>

#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>

#include "painting/cell_image.h"
#include "painting/cropped_image.h"
#include "painting/formula_text.h"
#include "painting/tikz.h"

namespace reliefui {

namespace {

QPointF qpoint(Point p) {
    return {p.x, p.y};
}
QPolygonF qpolygon(const std::vector<Point>& points) {
    QPolygonF polygon;
    for (const Point& p : points) polygon << qpoint(p);
    return polygon;
}
QRectF qrect(const Box& b) {
    return {b.x0, b.y0, b.width(), b.height()};
}
QPen qpen(const Stroke& stroke) {
    QPen pen(toColor(stroke.color), stroke.width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
    if (stroke.dash.empty()) return pen;
    QVector<qreal> dash;
    for (const double part : stroke.dash) dash.push_back(part / stroke.width);
    pen.setDashPattern(dash);
    return pen;
}

// Paints every item except labels, which are painted last.
struct ItemPainter {
    QPainter& painter;
    const ViewMap& map;
    const Style& style;
    const Box& screen;
    CellPictures* kept;
    const Item& item;

    Stroke stroke() const { return style.stroke(item); }
    QPen haloPen(double width) const {
        return QPen(toColor(style.halo()), width + 2 * style.screenPixelsPerPoint * 0.7, Qt::SolidLine, Qt::FlatCap,
                    Qt::MiterJoin);
    }

    // On raster devices thin lines are aligned to whole pixels.
    bool onPixels() const { return painter.paintEngine()->type() == QPaintEngine::Raster; }
    double middle(double at) const { return onPixels() ? std::round(at) + 0.5 : at; }

    void operator()(const Rectangle& r) const {
        const Box whole = screenBox(r, map, style.pixelsPerPoint());
        if (!whole.overlaps(screen.grown(50))) return;
        const Box box = whole.cut(screen.grown(100));
        if (r.fill) painter.fillRect(qrect(box), toColor(style.fill(item)));
        if (r.fill && item.emphasis != Emphasis::Strong) return;
        painter.setBrush(Qt::NoBrush);
        const double inner = onPixels() ? 1 : 0;  // the box ends in this pixel
        const QRectF edge = qrect({middle(box.x0), middle(box.y0), middle(box.x1 - inner), middle(box.y1 - inner)});
        // Selected items are outlined so that they are visible on any background.
        if (item.role == Role::Highlight) {
            painter.setPen(haloPen(stroke().width));
            painter.drawRect(edge);
        }
        painter.setPen(qpen(stroke()));
        painter.drawRect(edge);
    }

    void operator()(const Cells& cells) const {
        const CellRange range = visibleCells(cells, map.toDrawing(screen));
        if (range.count() <= 0) return;
        constexpr std::int64_t kMostOnPaper = 4096;
        constexpr std::int64_t kMostOnScreen = 20000;
        const double side = std::min(cells.cellWidth, cells.cellHeight) * map.scale;
        const bool ruled = side >= 8 * style.pixelsPerPoint();
        if (kept == nullptr ? range.count() <= kMostOnPaper : ruled && range.count() <= kMostOnScreen) {
            fillCells(cells, range);
            if (ruled) ruleCells(cells, range);
            writeCells(cells, range);
        } else if (kept != nullptr) {
            kept->draw(painter, cells, map, style, screen);
        } else {
            rasterCells(cells);
        }
    }

    Rgba colorOf(const Cells& cells, int i, int j) const {
        return style.cell(cells.map, static_cast<double>((*cells.values)(i, j)), cells.scale);
    }
    Box seenOf(const Cells& cells, int i, int j) const {
        return map.toScreen(cellBox(cells, i, j)).cut(screen.grown(2));
    }
    void fillCells(const Cells& cells, const CellRange& range) const {
        // In vector output each cell extends under its neighbours, which are painted later: viewers antialias edges,
        // and the background would show through as hairlines. Half a cell, since a viewer's pixels may be large.
        const double under = onPixels() ? 0 : 0.5 * map.scale;
        const Box all = map.toScreen(cells.clip);
        painter.setRenderHint(QPainter::Antialiasing, false);
        for (int j = range.j0; j < range.j1; ++j) {
            for (int i = range.i0; i < range.i1; ++i) {
                Box box = seenOf(cells, i, j);
                box.x1 = std::min(box.x1 + under * cells.cellWidth, all.x1);
                box.y1 = std::min(box.y1 + under * cells.cellHeight, all.y1);
                painter.fillRect(qrect(box), toColor(colorOf(cells, i, j)));
            }
        }
        painter.setRenderHint(QPainter::Antialiasing, true);
    }
    void ruleCells(const Cells& cells, const CellRange& range) const {
        painter.setPen(qpen(style.stroke(Role::Grid, Emphasis::Normal)));
        const Box all = map.toScreen(cells.clip).cut(screen.grown(2));
        for (int j = range.j0; j <= range.j1; ++j) {
            const double y = map.toScreen(Point{0, cells.y + j * cells.cellHeight}).y;
            if (y >= all.y0 && y <= all.y1) painter.drawLine(QPointF(all.x0, middle(y)), QPointF(all.x1, middle(y)));
        }
        for (int i = range.i0; i <= range.i1; ++i) {
            const double x = map.toScreen(Point{cells.x + i * cells.cellWidth, 0}).x;
            if (x >= all.x0 && x <= all.x1) painter.drawLine(QPointF(middle(x), all.y0), QPointF(middle(x), all.y1));
        }
    }
    void writeCells(const Cells& cells, const CellRange& range) const {
        const CellText text = cellText(cells, range, map.scale, style);
        if (text.pixels <= 0) return;
        QFont font("DejaVu Sans");
        font.setPixelSize(std::max(1, static_cast<int>(text.pixels)));
        painter.setFont(font);
        for (int j = range.j0; j < range.j1; ++j) {
            for (int i = range.i0; i < range.i1; ++i) {
                const Box box = seenOf(cells, i, j);
                if (!textFits(text, box.width(), box.height())) continue;
                painter.setPen(toColor(Style::textOn(colorOf(cells, i, j))));
                paintWords(painter, qrect(box), Qt::AlignCenter,
                           QString::fromStdString(cellValueText(cells, (*cells.values)(i, j), text)));
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
        drawImageIn(painter, qrect(map.toScreen(whole)), image, qrect(map.toScreen(cells.clip)));
        painter.restore();
    }

    void operator()(const Area& area) const {
        if (area.line.size() < 2) return;
        QPolygonF polygon;
        polygon << qpoint(map.toScreen(Point{area.line.front().x, area.base}));
        for (const Point& p : area.line) polygon << qpoint(map.toScreen(p));
        polygon << qpoint(map.toScreen(Point{area.line.back().x, area.base}));
        painter.setPen(Qt::NoPen);
        painter.setBrush(toColor(style.fill(item)));
        painter.drawPolygon(polygon);
    }

    void operator()(const Polyline& line) const {
        if (line.points.size() < 2) return;
        std::vector<Point> points;
        for (const Point& p : line.points) points.push_back(map.toScreen(p));
        // Of a line without length Qt writes a path without points, which is a fault in a PDF.
        constexpr double kLength = 1e-3;  // pixels
        const auto same = [&](const Point& p) {
            return std::abs(p.x - points.front().x) < kLength && std::abs(p.y - points.front().y) < kLength;
        };
        if (std::all_of(points.begin(), points.end(), same)) return;
        // When zoomed in far, a line can be thousands of screens long. It is clipped first, because dashing its whole
        // length is slow.
        std::vector<double> before;
        const std::vector<std::vector<Point>> runs = clippedTo(points, screen.grown(100), &before);
        const Stroke s = stroke();
        painter.setBrush(Qt::NoBrush);
        if (hasHalo(item)) {
            painter.setPen(haloPen(s.width));
            for (const auto& run : runs) painter.drawPolyline(qpolygon(run));
        }
        for (std::size_t n = 0; n < runs.size(); ++n) {
            QPen pen = qpen(s);
            if (!s.dash.empty()) pen.setDashOffset(before[n] / s.width);
            painter.setPen(pen);
            painter.drawPolyline(qpolygon(runs[n]));
        }
        if (!line.arrow) return;
        const QPointF tip = qpoint(points.back());
        const QPointF back = tip - qpoint(points[points.size() - 2]);
        if (back.isNull()) return;
        const double angle = std::atan2(back.y(), back.x()) * 180 / M_PI;
        painter.save();
        painter.translate(tip);
        painter.rotate(angle);
        painter.setPen(Qt::NoPen);
        painter.setBrush(toColor(s.color));
        const QPolygonF head(
            {QPointF(0, 0), QPointF(-5 * s.width, -2.4 * s.width), QPointF(-5 * s.width, 2.4 * s.width)});
        painter.drawPolygon(head);
        painter.restore();
    }

    void operator()(const Circle& c) const {
        Stroke s = stroke();
        if (c.rim) s = {Style::rim(), Style::rimWidth(s.width, c.radius * map.scale), {}};
        painter.setPen(qpen(s));
        painter.setBrush(c.fill ? QBrush(toColor(style.fill(item))) : QBrush(Qt::NoBrush));
        painter.drawEllipse(qpoint(map.toScreen(c.center)), c.radius * map.scale, c.radius * map.scale);
    }

    void operator()(const Ring& r) const {
        const Stroke s = stroke();
        const double radius = r.radius * style.pixelsPerPoint();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(toColor(style.halo()), s.width * 2.6));
        painter.drawEllipse(qpoint(map.toScreen(r.center)), radius, radius);
        painter.setPen(QPen(toColor(s.color), s.width));
        painter.drawEllipse(qpoint(map.toScreen(r.center)), radius, radius);
    }

    void operator()(const Marker& m) const {
        const double size = m.size * style.pixelsPerPoint();
        const QPointF at = qpoint(map.toScreen(m.at));
        const Stroke s = stroke();
        const double r = size / 2;
        painter.setPen(shapeFilled(m.shape) ? QPen(toColor(style.halo()), s.width * 0.6)
                                            : QPen(toColor(s.color), s.width));
        painter.setBrush(shapeFilled(m.shape) ? QBrush(toColor(s.color)) : QBrush(Qt::NoBrush));
        if (m.shape == Shape::Cross) {
            painter.setPen(QPen(toColor(s.color), s.width * 1.5));
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
        const Box box = map.toScreen(h.box).cut(screen);
        if (box.empty()) return;
        painter.setPen(qpen(style.stroke(item.role, Emphasis::Faint)));
        const double gap = 5 * style.pixelsPerPoint();
        for (double c = std::floor((box.x0 + box.y0) / gap) * gap; c < box.x1 + box.y1; c += gap) {
            const double from = std::max(box.x0, c - box.y1);
            const double to = std::min(box.x1, c - box.y0);
            if (from < to) painter.drawLine(QPointF(from, c - from), QPointF(to, c - to));
        }
    }

    void operator()(const Label&) const {}
};

// The text of a label with its font(s): the runs of a formula, or the whole text as one run.
class SetText {
  public:
    SetText(const Label& label, const Style& style, bool bold)
        : text_(labelText(label, style.language)),
          formula_(label.formula),
          pixels_(std::max(1, static_cast<int>(std::lround(style.textPixels(label.size))))),
          bold_(bold) {
        if (label.formula) {
            runs_ = formulaRuns(text_);
        } else {
            runs_.push_back({text_, 0});
        }
    }

    int pixels() const { return pixels_; }
    double height() const { return QFontMetricsF(fontOf(0)).height(); }
    double width() const {
        double width = 0;
        for (const FormulaRun& run : runs_) width += advance(run);
        return width;
    }
    // side: of the box at which a text is set that is narrower than measured.
    void draw(QPainter& painter, const QRectF& box, Qt::Alignment side) const {
        if (auto* const tikz = dynamic_cast<TikzDevice*>(painter.device())) {
            painter.setFont(fontOf(0));
            return tikz->words(painter, box, side, QString::fromStdString(text_), formula_);
        }
        if (runs_.size() == 1) {
            painter.setFont(fontOf(0));
            painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, QString::fromStdString(runs_.front().text));
            return;
        }
        const QFontMetricsF metrics(fontOf(0));
        const double line = box.center().y() + (metrics.ascent() - metrics.descent()) / 2;
        double x = box.center().x() - width() / 2;
        for (const FormulaRun& run : runs_) {
            const double shift = run.level < 0 ? kLowered : run.level > 0 ? -kRaised : 0;
            painter.setFont(fontOf(run.level));
            painter.drawText(QPointF(x, line + shift * pixels_), QString::fromStdString(run.text));
            x += advance(run);
        }
    }

  private:
    QFont fontOf(int level) const {
        QFont font("DejaVu Sans");
        font.setPixelSize(level == 0 ? pixels_ : std::max(1, static_cast<int>(std::lround(pixels_ * kScriptSize))));
        font.setBold(bold_);
        return font;
    }
    double advance(const FormulaRun& run) const {
        return QFontMetricsF(fontOf(run.level)).horizontalAdvance(QString::fromStdString(run.text));
    }

    std::string text_;
    bool formula_;
    std::vector<FormulaRun> runs_;
    int pixels_;
    bool bold_;
};

Qt::Alignment sideOf(Anchor anchor) {
    if (anchor == Anchor::Right) return Qt::AlignRight;
    const bool left = anchor == Anchor::TopLeft || anchor == Anchor::Left || anchor == Anchor::BottomLeft;
    return left ? Qt::AlignLeft : Qt::AlignHCenter;
}

void paintLabel(QPainter& painter, const Item& item, const Label& label, const ViewMap& map, const Style& style,
                LabelRoom& room, const Box& screen) {
    const SetText text(label, style, item.emphasis == Emphasis::Strong && !label.plate);
    const double pad = label.plate ? 0.28 * text.pixels() : 0;
    const double width = text.width() + 2 * pad;
    const double height = text.height() * 0.92 + (label.plate ? 0 : 1);
    const Box box = labelBox(label, map, width, height, style.pixelsPerPoint());
    if (box.empty() || !box.overlaps(screen)) return;
    // A label that yields also keeps a distance to the text around it.
    const double air = label.plate ? 0 : 2.5 * style.pixelsPerPoint();
    if (label.yields && !room.free({box.x0 - air, box.y0, box.x1 + air, box.y1})) return;
    room.place(box);
    Rgba color = style.color(item);
    if (label.plate && item.emphasis == Emphasis::Faint) color.a = kFaintPlate;
    if (label.plate) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(toColor(color));
        painter.drawRoundedRect(qrect(box), pad, pad);
        color = Style::textOn(color);
    }
    painter.setPen(toColor(color));
    text.draw(painter, qrect(box), label.plate ? Qt::AlignHCenter : sideOf(label.anchor));
}

}  // namespace

void paint(QPainter& painter, const Drawing& drawing, const ViewMap& map, const Style& style, const Box& screen,
           CellPictures* kept) {
    painter.setRenderHint(QPainter::Antialiasing, true);
    for (const Item& item : drawing.items) {
        std::visit(ItemPainter{painter, map, style, screen, kept, item}, item.primitive);
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

// The legend is laid out in points; it is scaled down if it would not fit on the page.
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

ViewMap legendMap(const Drawing& legend, const Box& page, const Style& style) {
    ViewMap map;
    map.scale = legendScale(legend, page, style);
    map.dx = page.x0 + kFigureMargin * style.pixelsPerPoint() - legend.bounds.x0 * map.scale;
    map.dy = page.y1 - legendHeight(legend, page, style) - legend.bounds.y0 * map.scale;
    return map;
}

Box figureRoom(const Drawing& legend, const Box& page, const Style& style) {
    const double margin = kFigureMargin * style.pixelsPerPoint();
    return {page.x0 + margin, page.y0 + margin, page.x1 - margin, page.y1 - margin - legendHeight(legend, page, style)};
}

void paintFigure(QPainter& painter, const std::vector<const Drawing*>& layers, const Drawing& legend, const Box& page,
                 const Style& style) {
    painter.fillRect(qrect(page), toColor(style.background()));
    Box bounds;
    for (const Drawing* layer : layers) bounds = bounds.joined(layer->bounds);
    const ViewMap map = ViewMap::fitting(bounds, figureRoom(legend, page, style));
    for (const Drawing* layer : layers) paint(painter, *layer, map, style, page);
    const ViewMap below = legendMap(legend, page, style);
    Style legendStyle = style;
    legendStyle.screenPixelsPerPoint *= below.scale / style.pixelsPerPoint();
    paint(painter, legend, below, legendStyle, page);
}

}  // namespace reliefui
