// What lies over the picture in the result view: the chosen pixel, its magnifier, the legend of a layer.
#pragma once

#include <QPainter>
#include <QString>

#include "painting/range_legend.h"
#include "painting/style.h"
#include "workspace/snapshot.h"

namespace reliefui {

QString layerTitle(Layer layer);
QString outcomeTitle(relief::Outcome outcome);

// A ring around the point, black in white: seen on any ground. side: of the pixel on the screen; large pixels are
// outlined instead.
void paintChosenPixel(QPainter& painter, QPointF at, double side, const Style& style);

// The neighbourhood of a pixel (of the snapshot's image), enlarged, its middle outlined.
inline constexpr int kMagnified = 15;
QSize magnifierSize(const Style& style, int viewWidth);
void paintMagnifier(QPainter& painter, const QImage& image, QPoint pixel, const QRect& frame, const Style& style);

// A layer of numbers, for its legend and the choice of its range.
RangedValues layerValues(const LayerPicture& layer);
// Colours and what they mean, with units; nothing for the colour layer. Returns its size when `painter` is null. width:
// pixels that it should not exceed.
inline constexpr double kAnyWidth = 1e6;
QSize paintLegend(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style,
                  double width = kAnyWidth);
// Of the part of it that is the scale of a layer of numbers.
QSize scaleSize(const LayerPicture& layer, const Style& style, double width);

// The picture with the layer's legend below it, for export.
QImage withLegend(const QImage& picture, const LayerPicture& layer, const Style& style);

// Decision records and values read by the ray of a pixel (index in the frame) that sees a polygon.
struct RayCounts {
    std::uint32_t steps = 0;
    std::uint32_t reads = 0;
};
RayCounts rayCounts(const Snapshot& snapshot, std::size_t pixel);

// Values of a pixel of the full-size picture, one thing a line, and what the shown layer says; `brief`:
// place, outcome and steps.
QStringList pixelReadout(const Snapshot& snapshot, relief::PixelChoice pixel, bool brief = false);

}  // namespace reliefui
