#include "panes/result/result_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/result/result_painting.h"
#include "workspace/resized_snapshot.h"

namespace reliefui {

namespace {

// The layer's legend is laid out in pixels of a screen with 96 per inch.
constexpr double kPixelsPerPoint = 96.0 / kPointsPerInch;

// A fixed font, so that the legend is the same on every page as where it is measured.
QFont legendFont() {
    constexpr int kPixels = 13;
    QFont font;
    font.setPixelSize(kPixels);
    return font;
}

// The style with the screen's pixels as unit, which the legend uses.
Style onScreen(Style style) {
    style.projector = false;
    style.screenPixelsPerPoint = kPixelsPerPoint;
    return style;
}

// Size of the legend on a page `width` screen pixels wide.
QSizeF legendOf(const Snapshot& snapshot, const Style& style, double width) {
    QImage nothing(1, 1, QImage::Format_RGB32);
    QPainter painter(&nothing);
    painter.setFont(legendFont());
    const QSize size = paintLegend(&painter, snapshot.layer, {}, onScreen(style), width);
    return size.isValid() ? QSizeF(size) / kPixelsPerPoint : QSizeF(0, 0);
}

// Draws what stands over the picture, which is `pixels` wide in the scenario.
void paintAnnotations(QPainter& painter, const std::vector<Annotation>& notes, const Box& picture, int pixels,
                      const Style& style) {
    const AnnotationFrame frame = resultAnnotations(picture, picture, pixels, style.pixelsPerPoint());
    reliefui::paint(painter, annotationDrawing(notes, frame, style.language), ViewMap{}, style, picture);
}

void paintResult(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style) {
    const QImage& image = snapshot.layer.image;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image.width() != static_cast<int>(page.width()));
    const double high = page.width() * image.height() / std::max(1, image.width());
    painter.drawImage(QRectF(page.x0, page.y0, page.width(), high), image);
    if (page.y0 + high < page.y1 - 1) {
        painter.save();
        painter.translate(page.x0, page.y1);
        const double unit = style.screenPixelsPerPoint / kPixelsPerPoint;
        painter.scale(unit, unit);
        painter.setFont(legendFont());
        paintLegend(&painter, snapshot.layer, QPoint(0, 0), onScreen(style), page.width() / unit);
        painter.restore();
    }
    if (!snapshot.scenario.pixel) return;
    const double side = page.width() / std::max(1, snapshot.scenario.width);
    Drawing ring;
    ring.add(
        {}, Role::Hit,
        Ring{{page.x0 + (snapshot.scenario.pixel->x + 0.5) * side, page.y0 + (snapshot.scenario.pixel->y + 0.5) * side},
             5});
    reliefui::paint(painter, ring, ViewMap{}, style, page);
}

}  // namespace

AnnotationFrame resultAnnotations(const Box& picture, const Box& seen, int pixels, double unit) {
    const double side = picture.width() / std::max(1, pixels);
    const Point origin{picture.x0, picture.y0};
    return {"result",
            [origin, side](Point p) {
                return Point{origin.x + p.x * side, origin.y + p.y * side};
            },
            [origin, side](Point p) {
                return Point{(p.x - origin.x) / side, (p.y - origin.y) / side};
            },
            seen, unit};
}

std::shared_ptr<const Figure> resultFigure(std::shared_ptr<const Snapshot> snapshot,
                                           const std::vector<Annotation>& notes) {
    return computedFigure([snapshot, notes](const FigurePage& requested, relief::Work& work) {
        const int pixels = requested.picturePixels(requested.widthMm / kMmPerPoint);
        auto drawn = std::make_shared<Snapshot>(*resized(snapshot, pixels, work));
        colorLayer(drawn->layer, snapshot->layer.range);
        const auto paint = [drawn, notes, pixels = snapshot->scenario.width](QPainter& painter, const Box& page,
                                                                             const Style& style) {
            paintResult(painter, *drawn, page, style);
            const QImage& image = drawn->layer.image;
            const double high = page.width() * image.height() / std::max(1, image.width());
            paintAnnotations(painter, notes, {page.x0, page.y0, page.x1, page.y0 + high}, pixels, style);
        };
        const auto aspect = [drawn](const FigurePage& page) {
            const double picture = static_cast<double>(drawn->scenario.height) / std::max(1, drawn->scenario.width);
            const double points = page.widthMm / kMmPerPoint;
            return picture + legendOf(*drawn, page.style, points * kPixelsPerPoint).height() / points;
        };
        return paintedFigure(paint, redrawnCaption(figureCaption(snapshot)), aspect);
    });
}

}  // namespace reliefui
