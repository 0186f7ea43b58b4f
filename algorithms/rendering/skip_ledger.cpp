#include "rendering/skip_ledger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rendering/error_layer.h"

namespace relief {

namespace {

// `of`: the counters whose sum is the total.
struct Entry {
    Ledger ledger;
    const char* name;
    MessageId counter;
    std::array<std::optional<MessageId>, 3> of;
    MessageId what;
    MessageId why;
};

constexpr std::array<Entry, 15> kEntries{{
    {Ledger::Lossless, "stages", MessageId::CountStagesKept, {}, MessageId::SkipStages, MessageId::SkipStagesWhy},
    {Ledger::Lossless,
     "tiles-kept",
     MessageId::CountTilesKept,
     {MessageId::CountTiles},
     MessageId::SkipTiles,
     MessageId::SkipTilesWhy},
    {Ledger::Lossless,
     "maps",
     MessageId::CountMapsNotNeeded,
     {MessageId::CountMapsConsidered},
     MessageId::SkipMaps,
     MessageId::SkipMapsWhy},
    {Ledger::Lossless,
     "polygons-away",
     MessageId::CountPolygonsAway,
     {MessageId::CountPolygons},
     MessageId::SkipPolygonsAway,
     MessageId::SkipPolygonsAwayWhy},
    {Ledger::Lossless,
     "polygons-off-screen",
     MessageId::CountPolygonsOff,
     {MessageId::CountPolygons},
     MessageId::SkipPolygonsOff,
     MessageId::SkipPolygonsOffWhy},
    {Ledger::Lossless, "sky", MessageId::CountSky, {MessageId::CountPixels}, MessageId::SkipSky, MessageId::SkipSkyWhy},
    {Ledger::Lossless,
     "flat-ground",
     MessageId::CountRaysFlat,
     {MessageId::CountRays},
     MessageId::SkipFlat,
     MessageId::SkipFlatWhy},
    {Ledger::Lossless,
     "highest-point",
     MessageId::CountRaysHighest,
     {MessageId::CountRays},
     MessageId::SkipHighest,
     MessageId::SkipHighestWhy},
    {Ledger::Lossless,
     "small-footprints",
     MessageId::CountFootprintsSmall,
     {MessageId::CountFootprints, MessageId::CountFootprintsSmall, MessageId::CountFootprintsTiny},
     MessageId::SkipSmall,
     MessageId::SkipSmallWhy},
    {Ledger::Lossless,
     "sight",
     MessageId::CountFootprintsClear,
     {MessageId::CountFootprints},
     MessageId::SkipSight,
     MessageId::SkipSightWhy},
    {Ledger::Lossless,
     "shadow-away",
     MessageId::CountShadowAway,
     {MessageId::CountHitsLit},
     MessageId::SkipShadowAway,
     MessageId::SkipShadowAwayWhy},
    {Ledger::Lossless,
     "shadow-top",
     MessageId::CountShadowTop,
     {MessageId::CountHitsLit},
     MessageId::SkipShadowTop,
     MessageId::SkipShadowTopWhy},
    {Ledger::Lossless,
     "shadow-bounds",
     MessageId::CountShadowBounds,
     {MessageId::CountHitsLit},
     MessageId::SkipShadowBounds,
     MessageId::SkipShadowBoundsWhy},
    {Ledger::Bounded,
     "little-parallax",
     MessageId::CountRaysParallax,
     {MessageId::CountRays},
     MessageId::SkipParallax,
     MessageId::SkipParallaxWhy},
    {Ledger::Bounded,
     "tiny-footprints",
     MessageId::CountFootprintsTiny,
     {MessageId::CountFootprints, MessageId::CountFootprintsSmall, MessageId::CountFootprintsTiny},
     MessageId::SkipTiny,
     MessageId::SkipTinyWhy},
}};

}  // namespace

std::vector<SkipRow> skipLedger(const Frame& frame, const FrameRequest& request) {
    const auto value = [&](MessageId id) {
        const auto found = frame.counters.find(id);
        return found == frame.counters.end() ? 0.0 : found->second;
    };
    std::vector<SkipRow> rows;
    for (const Entry& entry : kEntries) {
        if (!frame.counters.contains(entry.counter)) continue;
        SkipRow row{entry.ledger,         entry.name,
                    value(entry.counter), 0,
                    Message(entry.what),  Message(entry.why, {{"bound", request.bounded}})};
        for (const std::optional<MessageId> part : entry.of) row.of += part ? value(*part) : 0;
        if (entry.what == MessageId::SkipStages) row.of = kStages;
        rows.push_back(std::move(row));
    }
    return rows;
}

void BoundedSums::addRays(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work) {
    const auto first = part.hits->by.begin() + static_cast<std::ptrdiff_t>(part.index(0, part.rows.begin));
    const auto last = part.hits->by.begin() + static_cast<std::ptrdiff_t>(part.index(0, part.rows.end));
    if (std::find(first, last, HitBy::LittleParallax) == last) return;
    const ErrorLayer error = errorAgainstExact(part, request, maps, work);
    for (auto by = first; by != last; ++by) {
        if (*by != HitBy::LittleParallax) continue;
        const auto i = static_cast<std::size_t>(by - part.hits->by.begin());
        ++error_.rays;
        if (error.kinds[i] == ErrorKind::Wrong) {
            ++error_.wrongOutcomes;
            continue;
        }
        error_.rayMean += static_cast<double>(error.texels[i]);
        error_.rayMax = std::max(error_.rayMax, static_cast<double>(error.texels[i]));
    }
}

void BoundedSums::add(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work) {
    addRays(part, request, maps, work);
    if (!part.plainFilter) return;
    const VisiblePolygons visible = part.visible(request);
    FootprintCounts counts;
    for (int y = part.rows.begin; y < part.rows.end; ++y) {
        work.throwIfStopped();
        for (int x = 0; x < part.width; ++x) {
            const std::optional<FilterQuery> query = filterQuery(part, request, visible, x, y);
            if (!query || !tinyFootprint(*query, part, request)) continue;
            const Color full = part.filter->color(*query, counts, work);
            const Color here = part.color->color.pixels()[part.index(x, y)];
            double most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(static_cast<double>(full[c] - here[c])));
            ++error_.footprints;
            error_.colorMean += most;
            error_.colorMax = std::max(error_.colorMax, most);
        }
    }
}

BoundedError BoundedSums::error() const {
    BoundedError mean = error_;
    const std::int64_t right = mean.rays - mean.wrongOutcomes;
    mean.rayMean = right > 0 ? mean.rayMean / static_cast<double>(right) : 0;
    mean.colorMean = mean.footprints > 0 ? mean.colorMean / static_cast<double>(mean.footprints) : 0;
    return mean;
}

BoundedError measureBounded(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work) {
    BoundedSums sums;
    sums.add(frame, request, maps, work);
    return sums.error();
}

}  // namespace relief
