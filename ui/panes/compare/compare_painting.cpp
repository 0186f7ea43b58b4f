#include "panes/compare/compare_painting.h"

#include <algorithm>
#include <cmath>

#include "painting/cropped_image.h"
#include "painting/painter.h"
#include "panes/result/result_painting.h"

namespace reliefui {

namespace {

// Largest share of the page's height for the legend, so that enough remains for the pictures.
constexpr double kMostLegend = 0.14;
constexpr int kVeil = 150;         // opacity, of 255
constexpr double kLeastSide = 10;  // in points

// Qt's own downscaling averages only four pixels, which could remove detail that then seems to be lost by a method.
void drawReduced(QPainter& painter, const QImage& image, const QRectF& target, bool smooth) {
    const double scale = target.width() / std::max(1, image.width());
    constexpr double kHalf = 0.6;
    if (scale < kHalf && target.width() >= 1 && target.height() >= 1) {
        const double device = painter.device()->devicePixelRatioF();
        const QSize size = (target.size() * device).toSize().expandedTo({1, 1});
        painter.drawImage(target, image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        return;
    }
    // Enlarged pixels keep sharp edges.
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
        // The numbers are self-explanatory, so the pane's legend only contains the colour scale.
        parts.legend = compareScale(source, legendWidth, style.language);
    }
    parts.room = figureRoom(parts.legend, page, style);
    const double width = std::max(kLeastSide, parts.room.width() / unit);
    parts.leastHeight = page.height() - parts.room.height() + unit * compareLeastHeight(source, width, style.language);
    parts.layout = compareLayout(source, width, std::max(kLeastSide, parts.room.height() / unit), style.language);
    return parts;
}

namespace {

// Paints everything except the pictures: background and legend below them, text above them. draw: called for each
// visible picture n to paint it into its box (in the painter's units), clipped to the part that is seen.
void paintAround(QPainter& painter, const ComparePage& parts, const Box& page, const Style& style,
                 const std::function<void(std::size_t n, const QRectF& room, const QRectF& seen)>& draw) {
    const ViewMap map{style.pixelsPerPoint(), parts.room.x0, parts.room.y0};
    const auto rectangle = [&](const Box& points) {
        const Box b = map.toScreen(points);
        return QRectF(b.x0, b.y0, b.width(), b.height());
    };
    paintFigure(painter, {}, parts.legend, page, style);
    for (std::size_t n = 0; n < parts.layout.rooms.size(); ++n) {
        if (parts.layout.clips[n].empty()) continue;
        painter.save();
        const QRectF seen = rectangle(parts.layout.clips[n]);
        painter.setClipRect(seen, Qt::IntersectClip);
        draw(n, rectangle(parts.layout.rooms[n]), seen);
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
    paintAround(painter, parts, page, style, [&](std::size_t n, const QRectF& room, const QRectF&) {
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
    paintAround(painter, parts, page, style, [&](std::size_t n, const QRectF& room, const QRectF& seen) {
        if (n >= pictures.size() || pictures[n].isNull()) return;
        QRectF target(room.topLeft(), QSizeF(room.width(), room.width() * pictures[n].height() / pictures[n].width()));
        const bool pixels = room.width() - pictures[n].width() < 1 && room.width() >= pictures[n].width() - 1e-6;
        if (pixels) target = {QPointF(room.topLeft().toPoint()), QSizeF(pictures[n].size())};
        // A picture that is not divided is drawn whole, although its box may be a fraction of a pixel lower.
        drawImageIn(painter, target, pictures[n], seen == room ? target : seen);
        if (scenario.pixel) markPixel(painter, *scenario.pixel, scenario.width, target, style);
    });
}

}  // namespace reliefui
