// Values written onto the pixels of the result where they are large enough.
#pragma once

#include <QPainter>
#include <QStringList>

#include "painting/style.h"
#include "workspace/snapshot.h"

namespace reliefui {

// What the shown layer holds of pixel (x, y) of the frame, in short lines: the three channels as shown, a count, an
// error, the parts of a normal; nothing where it says nothing of it.
QStringList pixelValues(const Snapshot& snapshot, int x, int y);

// picture: where the whole picture lies; room: the part of it that is seen.
void paintPixelValues(QPainter& painter, const Snapshot& snapshot, const QRectF& picture, const QRectF& room,
                      const Style& style);

}  // namespace reliefui
