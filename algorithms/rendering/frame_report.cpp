#include "rendering/frame_report.h"

#include <algorithm>

namespace relief {

namespace {

void reportFilter(Frame& frame, const FrameTotals& totals) {
    const FilterDescription& filter = frame.filter->description();
    const auto count = [&](const char* name, double value) { frame.counters[name] = value; };
    if (frame.plainFilter) count("footprints not filtered: tiny", static_cast<double>(totals.tinyFootprints));
    count("texels read", static_cast<double>(totals.texels));
    if (!filter.ellipse) return;
    count("footprints", static_cast<double>(totals.footprints));
    count("footprints not needed: smaller than a texel", static_cast<double>(totals.smallFootprints));
    if (!filter.visible) return;
    count("texels traced back", static_cast<double>(totals.texelsTested));
    count("texels hidden", static_cast<double>(totals.texelsHidden));
    count("texels not traced back: nothing near is high enough", static_cast<double>(totals.texelsSkipped));
    count("footprints not traced back", static_cast<double>(totals.clearFootprints));
    count("footprints with nothing visible", static_cast<double>(totals.hiddenFootprints));
}

}  // namespace

void reportCounts(Frame& frame, const FrameTotals& totals) {
    const auto count = [&](const char* name, double value) { frame.counters[name] = value; };
    // Those rays are not traced: they are counted once. Frames whose counts are made later are counted again.
    double& highest = frame.counters["rays not needed: the start is the highest point"];
    double& traced = frame.counters["rays traced"];
    // Hits of an earlier frame that are shown again were not traced in this one.
    traced = std::max(traced + highest - static_cast<double>(totals.startHighest), 0.0);
    highest = static_cast<double>(totals.startHighest);
    count("steps", static_cast<double>(totals.steps));
    count("reads", static_cast<double>(totals.reads));
}

void report(Frame& frame, const FrameRequest& request, const VisiblePolygons& visible, const FrameTotals& totals,
            std::uint32_t stale, bool counted) {
    for (std::size_t s = 0; s < kStages; ++s) {
        frame.stages[s].reused = (stale & (1U << s)) == 0;
        frame.stages[s].seconds = static_cast<double>(totals.nanoseconds[s]) * 1e-9;
    }
    const auto count = [&](const char* name, double value) { frame.counters[name] = value; };
    count("polygons", visible.total);
    count("polygons culled: facing away", visible.backFacing);
    count("polygons culled: off screen", visible.offScreen);
    const double pixels = static_cast<double>(frame.width) * frame.height;
    count("pixels", pixels);
    if (has(stale, Stage::Rays)) frame.mappingOff = totals.mappingOff;
    if (has(stale, Stage::Rays)) count("pixels without a polygon", pixels - static_cast<double>(totals.covered));
    count("rays traced", static_cast<double>(totals.traced));
    if (has(stale, Stage::Hits)) {
        count("rays", static_cast<double>(totals.covered));
        count("rays not needed: flat ground", static_cast<double>(totals.flatRays));
        if (request.bounded > 0) count("rays not traced: little parallax", static_cast<double>(totals.parallaxRays));
        count("hits", static_cast<double>(totals.hits));
        count("misses", static_cast<double>(totals.misses));
        count("step limits", static_cast<double>(totals.limits));
        if (counted) reportCounts(frame, totals);
        if (totals.triangles > 0) count("triangles drawn", static_cast<double>(totals.triangles));
    }
    if (frame.filter && has(stale, Stage::Color)) reportFilter(frame, totals);
    if (request.shadows && has(stale, Stage::Shadows)) {
        count("hits lit", static_cast<double>(totals.shadowHits));
        count("shadow rays", static_cast<double>(totals.shadowRays));
        count("shadow rays blocked", static_cast<double>(totals.shadowBlocked));
        count("shadow rays not needed: turned away from the light", static_cast<double>(totals.shadowAway));
        count("shadow rays not needed: at the top", static_cast<double>(totals.shadowTop));
        if (totals.shadowSteps > 0) count("shadow steps", static_cast<double>(totals.shadowSteps));
        count("shadow step limits", static_cast<double>(totals.shadowLimits));
    }
    count("stages not computed again",
          static_cast<double>(std::count_if(frame.stages.begin(), frame.stages.end(),
                                            [](const StageReport& stage) { return stage.reused; })));
}

}  // namespace relief
