// The 3-D trace as a figure.
#pragma once

#include <optional>

#include "panes/figure.h"
#include "panes/step_colors.h"
#include "panes/turntable.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Share of the width that the patch fills at most, without a camera; leaves room for labels at the sides.
inline constexpr double kTraceRoom = 0.78;

// Exaggeration of the heights and camera; without a camera, the view is from the side of the ray. turn: of an orbit, in
// degrees.
struct TraceOptions {
    double exaggeration = 1;
    StepColors colors = StepColors::Decision;
    std::optional<Turntable> camera{};
    std::optional<double> turn{};
};

// As pixels it is rendered with OpenGL (throws WorkError if it is not available); as vectors it is painted, see
// trace_vectors.h.
std::shared_ptr<const Figure> traceFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                          const TraceOptions& options);

}  // namespace reliefui
