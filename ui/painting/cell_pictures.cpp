#include "painting/cell_pictures.h"

#include <algorithm>

#include "painting/cell_image.h"

namespace reliefui {

bool CellPictures::Picture::serves(const Cells& cells, const Style& style) const {
    return values == cells.values && map == cells.map && scale == cells.scale &&
           (map != ColorMap::Height || heights == style.heights) &&
           ((map != ColorMap::Distance && map != ColorMap::Difference) || theme == style.theme);
}

// Renders the visible cells with a border around them, so that small movements of the view need no new image; of a
// large grid only this part is rendered.
void CellPictures::Picture::make(const Cells& cells, const Style& style, const CellRange& seen, int cellsPerPixel) {
    constexpr int kMostAround = 384;  // pixels
    step = cellsPerPixel;
    const int around = std::min(kMostAround * step, std::max(seen.i1 - seen.i0, seen.j1 - seen.j0) / 2);
    // Starts at a multiple of `step` wherever the view is, so that the subsampled image does not shimmer as the view
    // moves.
    const auto first = [&](int at) { return std::max(0, at - around) / step * step; };
    range = {first(seen.i0), first(seen.j0), std::min(cells.values->width(), seen.i1 + around),
             std::min(cells.values->height(), seen.j1 + around)};
    const CellImage pixels = cellImage(cells, style, range, step);
    image = QImage(pixels.rgb.data(), pixels.width, pixels.height, pixels.width * 3, QImage::Format_RGB888)
                .convertToFormat(QImage::Format_RGB32);
}

void CellPictures::begin() {
    for (Picture& picture : pictures_) picture.used = false;
}

void CellPictures::end() {
    std::erase_if(pictures_, [](const Picture& picture) { return !picture.used; });
}

void CellPictures::draw(QPainter& painter, const Cells& cells, const ViewMap& map, const Style& style,
                        const Box& screen) {
    const Box visible = map.toDrawing(screen);
    const Box seen = cells.clip.cut(visible);
    const CellRange range = visibleCells(cells, visible);
    if (seen.empty() || range.count() <= 0) return;
    const auto known = std::find_if(pictures_.begin(), pictures_.end(),
                                    [&](const Picture& picture) { return picture.serves(cells, style); });
    const bool fresh = known == pictures_.end();
    Picture& picture = fresh ? pictures_.emplace_back() : *known;
    if (fresh) {
        picture.values = cells.values;
        picture.map = cells.map;
        picture.heights = style.heights;
        picture.theme = style.theme;
        picture.scale = cells.scale;
    }
    picture.used = true;
    // The step keeps the image between one and two times the screen's resolution, and always below this size.
    constexpr double kMostPixels = double{1 << 22};
    const double side = std::min(cells.cellWidth, cells.cellHeight) * map.scale;
    int step = 1;
    while (2 * step * side < 1 || static_cast<double>(range.count()) > kMostPixels * step * step) step *= 2;
    const CellRange& held = picture.range;
    const bool holds = range.i0 >= held.i0 && range.j0 >= held.j0 && range.i1 <= held.i1 && range.j1 <= held.j1;
    if (!holds || step != picture.step) picture.make(cells, style, range, step);
    const Box at = map.toScreen(seen);
    const double pixelX = cells.cellWidth * picture.step;
    const double pixelY = cells.cellHeight * picture.step;
    const QRectF source((seen.x0 - cells.x - picture.range.i0 * cells.cellWidth) / pixelX,
                        (seen.y0 - cells.y - picture.range.j0 * cells.cellHeight) / pixelY, seen.width() / pixelX,
                        seen.height() / pixelY);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, pixelX * map.scale < 1);
    painter.drawImage(QRectF(at.x0, at.y0, at.width(), at.height()), picture.image, source);
}

}  // namespace reliefui
