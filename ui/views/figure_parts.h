// What figure.cpp is made of: the views that are more than drawings.
#pragma once

#include <QImage>
#include <QPainter>

#include "views/figure.h"

namespace reliefui {

// Nothing to draw: says so.
Drawing emptyDrawing(relief::MessageId why);

// Height over width: of most views; those below have their own.
inline constexpr double kDrawingAspect = 0.56;
// High enough for every value to be written into its texel, where that needs no page higher than wide.
double pyramidAspect(const Snapshot& snapshot, const FigureRequest& request);
double resultAspect(const Snapshot& snapshot, const FigureRequest& request);
double compareAspect(const ComparedView& view, relief::CompareMode mode);
double tableAspect(const Snapshot& snapshot, const FigureRequest& request);

void paintPyramid(QPainter& painter, const Snapshot& snapshot, const PyramidOptions& options, const Box& page,
                  const Style& style);
// With the legend of its layer, if it has one, below it.
void paintResult(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style);
void paintComparison(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                     const Style& style);
void paintByHand(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style);
void paintDuel(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
               const Style& style);
// Of "steps" and "skipped".
void paintTable(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                const Style& style);

// The 3-D trace and the slabs, drawn by OpenGL without a window, and without a display. Throw WorkError where there is
// no OpenGL.
QImage traceImage(const Snapshot& snapshot, const FigureRequest& request, const QSize& size);
QImage slabsImage(const Snapshot& snapshot, const FigureRequest& request, const QSize& size);

}  // namespace reliefui
