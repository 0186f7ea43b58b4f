#include "rendering/frame_report.h"

#include <algorithm>

namespace relief {

namespace {

void reportFilter(Frame& frame, const FrameTotals& totals) {
    const FilterDescription& filter = frame.filter->description();
    const auto count = [&](MessageId what, double value) { frame.counters[what] = value; };
    if (frame.plainFilter) count(MessageId::CountFootprintsTiny, static_cast<double>(totals.tinyFootprints));
    count(MessageId::CountTexelsRead, static_cast<double>(totals.texels));
    if (!filter.ellipse) return;
    count(MessageId::CountFootprints, static_cast<double>(totals.footprints));
    count(MessageId::CountFootprintsSmall, static_cast<double>(totals.smallFootprints));
    if (!filter.visible) return;
    count(MessageId::CountTexelsTraced, static_cast<double>(totals.texelsTested));
    count(MessageId::CountTexelsHidden, static_cast<double>(totals.texelsHidden));
    count(MessageId::CountTexelsClear, static_cast<double>(totals.texelsSkipped));
    count(MessageId::CountFootprintsClear, static_cast<double>(totals.clearFootprints));
    count(MessageId::CountFootprintsHidden, static_cast<double>(totals.hiddenFootprints));
}

}  // namespace

void reportCounts(Frame& frame, const FrameTotals& totals) {
    const auto count = [&](MessageId what, double value) { frame.counters[what] = value; };
    count(MessageId::CountSteps, static_cast<double>(totals.steps));
    count(MessageId::CountReads, static_cast<double>(totals.reads));
    // The totals include hits kept from an earlier frame. Their rays were not traced in this frame, so the number of
    // rays that start at the highest height is then not reported.
    double& traced = frame.counters[MessageId::CountRaysTraced];
    if (static_cast<double>(totals.traced) > traced) return;
    // Rays that start at the highest height are not traced, and are counted once.
    const auto highest = static_cast<double>(totals.startHighest);
    traced -= highest;
    count(MessageId::CountRaysHighest, highest);
}

void report(Frame& frame, const FrameRequest& request, const VisiblePolygons& visible, const FrameTotals& totals,
            std::uint32_t stale, bool counted) {
    for (std::size_t s = 0; s < kStages; ++s) {
        frame.stages[s].reused = (stale & (1U << s)) == 0;
        frame.stages[s].seconds = static_cast<double>(totals.nanoseconds[s]) * 1e-9;
    }
    const auto count = [&](MessageId what, double value) { frame.counters[what] = value; };
    count(MessageId::CountPolygons, visible.total);
    count(MessageId::CountPolygonsAway, visible.backFacing);
    count(MessageId::CountPolygonsOff, visible.offScreen);
    const double pixels = static_cast<double>(frame.width) * frame.height;
    count(MessageId::CountPixels, pixels);
    if (has(stale, Stage::Rays)) frame.mappingOff = totals.mappingOff;
    if (has(stale, Stage::Rays)) count(MessageId::CountSky, pixels - static_cast<double>(totals.covered));
    count(MessageId::CountRaysTraced, static_cast<double>(totals.traced));
    if (has(stale, Stage::Hits)) {
        // Rays that are kept are not counted as they are made.
        const std::int64_t kept = totals.traced + totals.flatRays + totals.parallaxRays;
        count(MessageId::CountRays, static_cast<double>(has(stale, Stage::Rays) ? totals.covered.load() : kept));
        count(MessageId::CountRaysFlat, static_cast<double>(totals.flatRays));
        if (request.bounded > 0) count(MessageId::CountRaysParallax, static_cast<double>(totals.parallaxRays));
        count(MessageId::CountHits, static_cast<double>(totals.hits));
        count(MessageId::CountMisses, static_cast<double>(totals.misses));
        count(MessageId::CountLimits, static_cast<double>(totals.limits));
        if (counted) reportCounts(frame, totals);
        if (totals.triangles > 0) count(MessageId::CountTriangles, static_cast<double>(totals.triangles));
    }
    if (frame.filter && has(stale, Stage::Color)) reportFilter(frame, totals);
    if (request.shadows && has(stale, Stage::Shadows)) {
        count(MessageId::CountHitsLit, static_cast<double>(totals.shadowHits));
        count(MessageId::CountShadowRays, static_cast<double>(totals.shadowRays));
        count(MessageId::CountShadowBlocked, static_cast<double>(totals.shadowBlocked));
        count(MessageId::CountShadowAway, static_cast<double>(totals.shadowAway));
        count(MessageId::CountShadowTop, static_cast<double>(totals.shadowTop));
        if (totals.shadowSteps > 0) count(MessageId::CountShadowSteps, static_cast<double>(totals.shadowSteps));
        count(MessageId::CountShadowBounds, static_cast<double>(totals.shadowBounds));
        count(MessageId::CountShadowBoundsBlocked, static_cast<double>(totals.shadowBoundsBlocked));
        count(MessageId::CountShadowLimits, static_cast<double>(totals.shadowLimits));
    }
    count(MessageId::CountStagesKept,
          static_cast<double>(std::count_if(frame.stages.begin(), frame.stages.end(),
                                            [](const StageReport& stage) { return stage.reused; })));
}

}  // namespace relief
