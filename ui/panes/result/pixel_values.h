// Prints values onto the pixels of the result when they are large enough.
#pragma once

#include <QPainter>
#include <QStringList>

#include "painting/style.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Short lines with the value of the shown layer at pixel (x, y) of the frame: the three channels as shown, a count, an
// error, the components of a normal; empty if it has no value.
QStringList pixelValues(const Snapshot& snapshot, int x, int y);

// picture: rectangle of the whole picture; room: its visible part.
void paintPixelValues(QPainter& painter, const Snapshot& snapshot, const QRectF& picture, const QRectF& room,
                      const Style& style);

}  // namespace reliefui
