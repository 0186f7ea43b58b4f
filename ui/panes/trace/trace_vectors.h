// The 3-D trace as vectors, for SVG, PDF and TikZ: the same scene and camera as the pane, which VTK can only render to
// pixels. The relief is painted cell by cell, from behind; the parts of all other objects that it hides are left out,
// and those of the ray are dashed.
#pragma once

#include <QPainter>

#include "panes/trace/trace3d_scene.h"
#include "panes/trace/trace_figure.h"

namespace reliefui {

// page: the box that the picture fills, with its legend.
void paintTraceVectors(QPainter& painter, const Box& page, const Style& style, const Snapshot& snapshot, int step,
                       const TraceOptions& options);

// The camera that a figure of this size has without one from a pane. reliefHeight: of the page, without its legend.
Turntable traceCamera(const TraceScene& scene, double width, double reliefHeight);
// Height of the legend on a page, in its units; 0 if there is no room for it.
double traceLegendHeight(const Drawing& legend, const Box& page, const Style& style);

}  // namespace reliefui
