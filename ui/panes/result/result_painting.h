// Drawn over the picture in the result view: the chosen pixel, its magnifier, the legend of a layer.
#pragma once

#include <QPainter>
#include <QString>

#include "painting/range_legend.h"
#include "painting/style.h"
#include "workspace/snapshot.h"

namespace reliefui {

QString layerTitle(Layer layer);
QString outcomeTitle(relief::Outcome outcome);

// Marks a pixel with a black and white ring, visible on any background. side: size of the pixel on the screen; a large
// pixel is outlined instead.
void paintChosenPixel(QPainter& painter, QPointF at, double side, const Style& style);

// Magnified neighbourhood of a pixel (of the snapshot's image), with the pixel outlined.
inline constexpr int kMagnified = 15;
QSize magnifierSize(const Style& style, int viewWidth);
void paintMagnifier(QPainter& painter, const QImage& image, QPoint pixel, const QRect& frame, const Style& style);

// Values of a numeric layer, for its legend and the dialog for its range.
RangedValues layerValues(const LayerPicture& layer);
// Paints the legend: colours, their meaning and units; empty for the colour layer. Returns its size, also without
// painting if `painter` is null. width: preferred maximum, in pixels.
inline constexpr double kAnyWidth = 1e6;
QSize paintLegend(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style,
                  double width = kAnyWidth);
// Size of the colour scale within the legend of a numeric layer.
QSize scaleSize(const LayerPicture& layer, const Style& style, double width);

// The picture with the layer's legend below it, for export.
QImage withLegend(const QImage& picture, const LayerPicture& layer, const Style& style);

// Number of steps and of values read by the ray of a pixel (index in the frame) in which a polygon is visible.
struct RayCounts {
    std::uint32_t steps = 0;
    std::uint32_t reads = 0;
};
RayCounts rayCounts(const Snapshot& snapshot, std::size_t pixel);

// Values of a pixel of the full-size picture, one per line, including that of the shown layer; `brief`: only place,
// outcome and steps.
QStringList pixelReadout(const Snapshot& snapshot, relief::PixelChoice pixel, bool brief = false);

}  // namespace reliefui
