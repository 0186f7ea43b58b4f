#include "painting/cropped_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPaintEngine>

namespace reliefui {

namespace {

// The part of an image's side, in its pixels, that lies between low and high; the image begins at `start`.
std::pair<double, double> sideIn(double low, double high, double start, double pixel, int count) {
    const auto at = [&](double place) { return std::clamp((place - start) / pixel, 0.0, static_cast<double>(count)); };
    return {at(low), at(high)};
}

// Returns true for a whole number of pixels, up to rounding errors.
bool isWhole(double pixels) {
    return std::abs(pixels - std::round(pixels)) < 1e-3;
}

}  // namespace

void drawImageIn(QPainter& painter, const QRectF& target, const QImage& image, const QRectF& seen) {
    if (painter.paintEngine()->type() != QPaintEngine::SVG || seen.contains(target)) {
        return painter.drawImage(target, image);
    }
    const double pixelX = target.width() / image.width(), pixelY = target.height() / image.height();
    const auto [x0, x1] = sideIn(seen.left(), seen.right(), target.x(), pixelX, image.width());
    const auto [y0, y1] = sideIn(seen.top(), seen.bottom(), target.y(), pixelY, image.height());
    const QRect whole(QPoint(static_cast<int>(x0), static_cast<int>(y0)),
                      QPoint(static_cast<int>(std::ceil(x1)) - 1, static_cast<int>(std::ceil(y1)) - 1));
    if (whole.isEmpty()) return;
    // Where an edge cuts through pixels and they are large, each becomes `fine` x `fine`, so that the cut is exact to a
    // fraction of one.
    constexpr int kLongest = 1024;  // longest side of the enlarged image, in pixels, which bounds the file
    constexpr int kFinest = 16;     // largest enlargement; a cut is exact to 1/16 pixel
    const bool cutsPixels = !isWhole(x0) || !isWhole(x1) || !isWhole(y0) || !isWhole(y1);
    const int fine = cutsPixels ? std::clamp(kLongest / std::max(whole.width(), whole.height()), 1, kFinest) : 1;
    const auto from = [&](double at, int first) { return static_cast<int>(std::lround((at - first) * fine)); };
    const QRect part(QPoint(from(x0, whole.x()), from(y0, whole.y())),
                     QPoint(from(x1, whole.x()) - 1, from(y1, whole.y()) - 1));
    if (part.isEmpty()) return;
    const QRectF shown(target.x() + (whole.x() + part.x() * 1.0 / fine) * pixelX,
                       target.y() + (whole.y() + part.y() * 1.0 / fine) * pixelY, part.width() * pixelX / fine,
                       part.height() * pixelY / fine);
    painter.drawImage(shown, image.copy(whole).scaled(whole.size() * fine).copy(part));
}

}  // namespace reliefui
