#include "panes/result/result_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/result/result_painting.h"

namespace reliefui {

namespace {

// The legend of the result's layer, for a page so many points wide: pixels of a screen, of which there are 96 an inch.
constexpr double kPixelsPerPoint = 96.0 / 72;

// The same on every page, and where it is measured.
QFont legendFont() {
    constexpr int kPixels = 13;
    QFont font;
    font.setPixelSize(kPixels);
    return font;
}

// What the legend measures by are pixels of a screen.
Style onScreen(Style style) {
    style.projector = false;
    style.screenPixelsPerPoint = kPixelsPerPoint;
    return style;
}

QSizeF legendOf(const Snapshot& snapshot, const Style& style) {
    QImage nothing(1, 1, QImage::Format_RGB32);
    QPainter painter(&nothing);
    painter.setFont(legendFont());
    const QSize size = paintLegend(&painter, snapshot.layer, {}, onScreen(style));
    return size.isValid() ? QSizeF(size) / kPixelsPerPoint : QSizeF(0, 0);
}

}  // namespace

std::shared_ptr<const Figure> resultFigure(std::shared_ptr<const Snapshot> snapshot) {
    return paintedFigure(
        [snapshot](QPainter& painter, const Box& page, const Style& style) {
            const QImage& image = snapshot->layer.image;
            painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
            const double high = page.width() * image.height() / std::max(1, image.width());
            painter.drawImage(QRectF(page.x0, page.y0, page.width(), high), image);
            if (page.y0 + high < page.y1 - 1) {
                painter.save();
                painter.translate(page.x0, page.y1);
                const double unit = style.screenPixelsPerPoint / kPixelsPerPoint;
                painter.scale(unit, unit);
                painter.setFont(legendFont());
                paintLegend(&painter, snapshot->layer, QPoint(0, 0), onScreen(style));
                painter.restore();
            }
            if (snapshot->scenario.pixel) {
                const double side = page.width() / std::max(1, snapshot->scenario.width);
                const Point at{page.x0 + (snapshot->scenario.pixel->x + 0.5) * side,
                               page.y0 + (snapshot->scenario.pixel->y + 0.5) * side};
                Drawing ring;
                ring.add({}, Role::Hit, Ring{at, 5});
                reliefui::paint(painter, ring, ViewMap{}, style, page);
            }
        },
        [snapshot](const FigurePage& page) {
            const QImage& image = snapshot->layer.image;
            const double picture = static_cast<double>(image.height()) / std::max(1, image.width());
            return picture + legendOf(*snapshot, page.style).height() / (page.widthMm / kMmPerPoint);
        });
}

}  // namespace reliefui
