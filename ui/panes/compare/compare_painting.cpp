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

QRectF fitted(const QRectF& room, const QSize& size) {
    const double scale = std::min(room.width() / size.width(), room.height() / size.height());
    const QSizeF side = QSizeF(size) * scale;
    return {room.center() - QPointF(side.width() / 2, side.height() / 2), side};
}

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

ComparePage comparePage(const CompareSource& source, const Box& page, const Style& style) {
    ComparePage parts;
    const double unit = style.pixelsPerPoint();
    parts.legend = compareLegend(source, page.width() / unit - 12, style.language);
    if (parts.legend.bounds.height() * unit > kMostLegend * page.height()) {
        // What the numbers are they say themselves; what the colours are only the scale.
        parts.legend =
            source.mode == relief::CompareMode::Difference ? compareScale(source, style.language) : Drawing();
    }
    parts.room = figureRoom(parts.legend, page, style);
    const double width = std::max(kLeastSide, parts.room.width() / unit);
    parts.leastHeight = page.height() - parts.room.height() + unit * compareLeastHeight(source, width, style.language);
    parts.layout = compareLayout(source, width, std::max(kLeastSide, parts.room.height() / unit), style.language);
    return parts;
}

void paintCompare(QPainter& painter, const ComparedView& view, const relief::Comparison& how, const ComparePage& parts,
                  const Box& page, const Style& style, std::optional<relief::PixelChoice> pixel,
                  const std::function<QRectF(const QRectF& room)>& place) {
    const double unit = style.pixelsPerPoint();
    const ViewMap map{unit, parts.room.x0, parts.room.y0};
    const auto rectangle = [&](const Box& points) {
        const Box b = map.toScreen(points);
        return QRectF(b.x0, b.y0, b.width(), b.height());
    };
    // The ground, and the legend.
    paintFigure(painter, {}, parts.legend, page, style);
    const QSize size(view.scenario.width, view.scenario.height);
    for (std::size_t n = 0; n < view.pictures.size() && n < parts.layout.rooms.size(); ++n) {
        const ComparedPicture& picture = view.pictures[n];
        const Box& clip = parts.layout.clips[n];
        if (clip.empty() || picture.picture.isNull()) continue;
        const QRectF room = rectangle(parts.layout.rooms[n]);
        const QRectF target = place ? place(room) : fitted(room, size);
        painter.save();
        painter.setClipRect(rectangle(clip), Qt::IntersectClip);
        drawReduced(painter, picture.shown(how, view.isReference(picture)), target, view.coarse);
        if (parts.layout.veiled[n]) {
            QColor veil = toColor(style.background());
            veil.setAlpha(kVeil);
            painter.fillRect(rectangle(clip), veil);
        } else if (pixel) {
            const double scale = target.width() / size.width();
            const QPointF at(target.x() + (pixel->x + 0.5) * scale, target.y() + (pixel->y + 0.5) * scale);
            paintChosenPixel(painter, at, scale, style);
        }
        painter.restore();
    }
    paint(painter, parts.layout.drawing, map, style, page);
}

}  // namespace reliefui
