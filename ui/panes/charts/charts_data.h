// Data that the charts pane and its figures show for a snapshot: histograms of its frame, and measurements of methods.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panes/charts/charts_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Measurements of methods on the rays of a view.
struct MeasuredView {
    relief::ParetoTable table;
    std::size_t rays = 0;
    int rounds = 0;
    bool withMaps = false;
    relief::Scenario scenario;  // the part on which the rays depend
    std::shared_ptr<const void> heights;

    // Returns true if the measurements used this snapshot's rays.
    bool of(const Snapshot& snapshot) const;
    // Returns true if this method was measured.
    bool has(const relief::MethodChoice& method) const;
};

// The tracers that support the surface, with default options. withMaps: also those that first have to build maps other
// than pyramids, which takes longer. The snapshot's own method is always included.
std::vector<relief::MethodChoice> methodsToMeasure(const Snapshot& snapshot, bool withMaps);

// Takes seconds. Throws Cancelled, InputError.
MeasuredView measureView(const Snapshot& snapshot, bool withMaps, relief::Work& work);
std::shared_ptr<const relief::FrameHistograms> histogramsOf(const Snapshot& snapshot, relief::Work& work);

// Returns null if nothing was measured.
std::shared_ptr<const ParetoSource> paretoSource(const Snapshot& snapshot, const MeasuredView& measured,
                                                 relief::ErrorMeasure measure);
// Returns true if both snapshots would give the same methods measured on the same rays.
bool sameMeasurement(const Snapshot& a, const Snapshot& b);
// Number of steps of the chosen pixel's ray; 0 without a ray.
std::int64_t chosenSteps(const Snapshot& snapshot);

}  // namespace reliefui
