// What the charts pane and its figures show of a snapshot: histograms of its frame, and its methods measured.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panes/charts/charts_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Methods measured on the rays of a view.
struct MeasuredView {
    relief::ParetoTable table;
    std::size_t rays = 0;
    int rounds = 0;
    bool withMaps = false;
    relief::Scenario scenario;  // the part that the rays depend on
    std::shared_ptr<const relief::FloatImage> heights;

    // Whether it is of this snapshot's rays.
    bool of(const Snapshot& snapshot) const;
    // Whether a method is there.
    bool has(const relief::MethodChoice& method) const;
};

// The tracers of the list that know the surface, as they are by default; withMaps: those as well that have to build
// maps, other than pyramids, first, which takes its time. The snapshot's own method in any case.
std::vector<relief::MethodChoice> methodsToMeasure(const Snapshot& snapshot, bool withMaps);

// Takes seconds. Throws Cancelled, InputError.
MeasuredView measureView(const Snapshot& snapshot, bool withMaps, relief::Work& work);
std::shared_ptr<const relief::FrameHistograms> histogramsOf(const Snapshot& snapshot, relief::Work& work);

// Null if nothing is measured.
std::shared_ptr<const ParetoSource> paretoSource(const Snapshot& snapshot, const MeasuredView& measured,
                                                 relief::ErrorMeasure measure);
// Whether the same methods would be measured on the same rays.
bool sameMeasurement(const Snapshot& a, const Snapshot& b);
// Steps of the chosen pixel's ray; 0: there is none.
std::int64_t chosenSteps(const Snapshot& snapshot);

}  // namespace reliefui
