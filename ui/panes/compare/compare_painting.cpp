#include "panes/compare/compare_painting.h"

#include <algorithm>
#include <cmath>

#include "painting/painter.h"
#include "panes/result/result_painting.h"

namespace reliefui {

namespace {

// Of the page's height: what explains must leave room for what is explained.
constexpr double kMostLegend = 0.14;
constexpr int kVeil = 150;         // of 255
constexpr double kLeastSide = 10;  // points

// Qt's own reduction looks at four pixels only; detail that a method lost must not come from that.
void drawReduced(QPainter& painter, const QImage& image, const QRectF& target, bool smooth) {
    const double scale = target.width() / std::max(1, image.width());
    constexpr double kHalf = 0.6;
    if (scale < kHalf && target.width() >= 1 && target.height() >= 1) {
        const double device = painter.device()->devicePixelRatioF();
        const QSize size = (target.size() * device).toSize().expandedTo({1, 1});
        painter.drawImage(target, image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        return;
    }
    // Pixels stay sharp when enlarged.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 1 || smooth);
    painter.drawImage(target, image);
}

}  // namespace

ComparePage comparePage(const CompareSource& source, const Box& page, const Style& style, bool whole) {
    ComparePage parts;
    const double unit = style.pixelsPerPoint();
    const double legendWidth = page.width() / unit - 2 * kFigureMargin;
    parts.legend = compareLegend(source, legendWidth, style.language);
    if (!whole && parts.legend.bounds.height() * unit > kMostLegend * page.height()) {
        // What the numbers are they say themselves; what the colours are only the scale.
        parts.legend = compareScale(source, legendWidth, style.language);
    }
    parts.room = figureRoom(parts.legend, page, style);
    const double width = std::max(kLeastSide, parts.room.width() / unit);
    parts.leastHeight = page.height() - parts.room.height() + unit * compareLeastHeight(source, width, style.language);
    parts.layout = compareLayout(source, width, std::max(kLeastSide, parts.room.height() / unit), style.language);
    return parts;
}

namespace {

// The rooms of pictures that are seen, in the painter's units, between ground and legend below and words above them.
// draw: puts picture n into its room, clipped to what of it is seen.
void paintAround(QPainter& painter, const ComparePage& parts, const Box& page, const Style& style,
                 const std::function<void(std::size_t n, const QRectF& room)>& draw) {
    const ViewMap map{style.pixelsPerPoint(), parts.room.x0, parts.room.y0};
    const auto rectangle = [&](const Box& points) {
        const Box b = map.toScreen(points);
        return QRectF(b.x0, b.y0, b.width(), b.height());
    };
    paintFigure(painter, {}, parts.legend, page, style);
    for (std::size_t n = 0; n < parts.layout.rooms.size(); ++n) {
        if (parts.layout.clips[n].empty()) continue;
        painter.save();
        painter.setClipRect(rectangle(parts.layout.clips[n]), Qt::IntersectClip);
        draw(n, rectangle(parts.layout.rooms[n]));
        painter.restore();
    }
    paint(painter, parts.layout.drawing, map, style, page);
}

void markPixel(QPainter& painter, const relief::PixelChoice& pixel, int width, const QRectF& picture,
               const Style& style) {
    const double side = picture.width() / width;
    paintChosenPixel(painter, {picture.x() + (pixel.x + 0.5) * side, picture.y() + (pixel.y + 0.5) * side}, side,
                     style);
}

}  // namespace

void paintCompare(QPainter& painter, const ComparedView& view, const relief::Comparison& how, const ComparePage& parts,
                  const Box& page, const Style& style, std::optional<relief::PixelChoice> pixel,
                  const std::function<QRectF(const QRectF& room)>& place) {
    paintAround(painter, parts, page, style, [&](std::size_t n, const QRectF& room) {
        if (n >= view.pictures.size() || view.pictures[n].picture.isNull()) return;
        const ComparedPicture& picture = view.pictures[n];
        const QRectF target = place(room);
        drawReduced(painter, picture.shown(how, view.isReference(picture)), target, view.coarse);
        if (parts.layout.veiled[n]) {
            QColor veil = toColor(style.background());
            veil.setAlpha(kVeil);
            painter.fillRect(room, veil);
        } else if (pixel) {
            markPixel(painter, *pixel, view.scenario.width, target, style);
        }
    });
}

void paintRedrawn(QPainter& painter, const std::vector<QImage>& pictures, const ComparePage& parts, const Box& page,
                  const Style& style, const relief::Scenario& scenario) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    paintAround(painter, parts, page, style, [&](std::size_t n, const QRectF& room) {
        if (n >= pictures.size() || pictures[n].isNull()) return;
        QRectF target(room.topLeft(), QSizeF(room.width(), room.width() * pictures[n].height() / pictures[n].width()));
        const bool pixels = room.width() - pictures[n].width() < 1 && room.width() >= pictures[n].width() - 1e-6;
        if (pixels) target = {QPointF(room.topLeft().toPoint()), QSizeF(pictures[n].size())};
        painter.drawImage(target, pictures[n]);
        if (scenario.pixel) markPixel(painter, *scenario.pixel, scenario.width, target, style);
    });
}

}  // namespace reliefui
