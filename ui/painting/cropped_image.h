// Images of which a part shows, in every format of a figure.
#pragma once

#include <QImage>
#include <QPainter>

namespace reliefui {

// Draws the image into `target`, of which only `seen` shows: the painter's clip, or a part of it. Qt writes no clips
// into SVG files, so that there the image itself is cropped.
void drawImageIn(QPainter& painter, const QRectF& target, const QImage& image, const QRectF& seen);

}  // namespace reliefui
