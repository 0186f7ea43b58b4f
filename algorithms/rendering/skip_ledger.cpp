#include "rendering/skip_ledger.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/error_layer.h"

namespace relief {

namespace {

// Counters are named as the renderer reports them; `of` are the counters whose sum is the whole.
struct Entry {
    Ledger ledger;
    const char* name;
    const char* counter;
    std::array<const char*, 3> of;
    MessageId what;
    MessageId why;
};

constexpr std::array<Entry, 13> kEntries{{
    {Ledger::Lossless, "stages", "stages not computed again", {}, MessageId::SkipStages, MessageId::SkipStagesWhy},
    {Ledger::Lossless, "maps", "maps not needed", {"maps considered"}, MessageId::SkipMaps, MessageId::SkipMapsWhy},
    {Ledger::Lossless,
     "polygons-away",
     "polygons culled: facing away",
     {"polygons"},
     MessageId::SkipPolygonsAway,
     MessageId::SkipPolygonsAwayWhy},
    {Ledger::Lossless,
     "polygons-off-screen",
     "polygons culled: off screen",
     {"polygons"},
     MessageId::SkipPolygonsOff,
     MessageId::SkipPolygonsOffWhy},
    {Ledger::Lossless, "sky", "pixels without a polygon", {"pixels"}, MessageId::SkipSky, MessageId::SkipSkyWhy},
    {Ledger::Lossless,
     "flat-ground",
     "rays not needed: flat ground",
     {"rays"},
     MessageId::SkipFlat,
     MessageId::SkipFlatWhy},
    {Ledger::Lossless,
     "highest-point",
     "rays not needed: the start is the highest point",
     {"rays"},
     MessageId::SkipHighest,
     MessageId::SkipHighestWhy},
    {Ledger::Lossless,
     "small-footprints",
     "footprints not needed: smaller than a texel",
     {"footprints", "footprints not needed: smaller than a texel", "footprints not filtered: tiny"},
     MessageId::SkipSmall,
     MessageId::SkipSmallWhy},
    {Ledger::Lossless,
     "sight",
     "footprints not traced back",
     {"footprints"},
     MessageId::SkipSight,
     MessageId::SkipSightWhy},
    {Ledger::Lossless,
     "shadow-away",
     "shadow rays not needed: turned away from the light",
     {"hits lit"},
     MessageId::SkipShadowAway,
     MessageId::SkipShadowAwayWhy},
    {Ledger::Lossless,
     "shadow-top",
     "shadow rays not needed: at the top",
     {"hits lit"},
     MessageId::SkipShadowTop,
     MessageId::SkipShadowTopWhy},
    {Ledger::Bounded,
     "little-parallax",
     "rays not traced: little parallax",
     {"rays"},
     MessageId::SkipParallax,
     MessageId::SkipParallaxWhy},
    {Ledger::Bounded,
     "tiny-footprints",
     "footprints not filtered: tiny",
     {"footprints", "footprints not needed: smaller than a texel", "footprints not filtered: tiny"},
     MessageId::SkipTiny,
     MessageId::SkipTinyWhy},
}};

}  // namespace

std::vector<SkipRow> skipLedger(const Frame& frame, const FrameRequest& request) {
    const auto value = [&](const char* name) {
        const auto found = frame.counters.find(name);
        return found == frame.counters.end() ? 0.0 : found->second;
    };
    std::vector<SkipRow> rows;
    for (const Entry& entry : kEntries) {
        if (!frame.counters.contains(entry.counter)) continue;
        SkipRow row{entry.ledger,         entry.name,
                    value(entry.counter), 0,
                    Message(entry.what),  Message(entry.why, {{"bound", request.bounded}})};
        for (const char* const part : entry.of) row.of += part == nullptr ? 0 : value(part);
        if (entry.what == MessageId::SkipStages) row.of = kStages;
        rows.push_back(std::move(row));
    }
    return rows;
}

BoundedError measureBounded(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work) {
    BoundedError out;
    if (std::count(frame.hits->by.begin(), frame.hits->by.end(), HitBy::LittleParallax) > 0) {
        const ErrorLayer error = errorAgainstExact(frame, request, maps, work);
        double sum = 0;
        for (std::size_t i = 0; i < error.texels.size(); ++i) {
            if (frame.hits->by[i] != HitBy::LittleParallax) continue;
            ++out.rays;
            if (error.kinds[i] == ErrorKind::Wrong) {
                ++out.wrongOutcomes;
                continue;
            }
            sum += static_cast<double>(error.texels[i]);
            out.rayMax = std::max(out.rayMax, static_cast<double>(error.texels[i]));
        }
        out.rayMean = out.rays > out.wrongOutcomes ? sum / static_cast<double>(out.rays - out.wrongOutcomes) : 0;
    }
    if (!frame.plainFilter) return out;
    const VisiblePolygons visible = frame.visible(request);
    FootprintCounts counts;
    double sum = 0;
    for (int y = 0; y < frame.height; ++y) {
        work.throwIfStopped();
        for (int x = 0; x < frame.width; ++x) {
            const std::optional<FilterQuery> query = filterQuery(frame, request, visible, x, y);
            if (!query || !tinyFootprint(*query, frame, request)) continue;
            const Color full = frame.filter->color(*query, counts, work);
            const Color here = frame.color->color(x, y);
            double most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(static_cast<double>(full[c] - here[c])));
            ++out.footprints;
            sum += most;
            out.colorMax = std::max(out.colorMax, most);
        }
    }
    out.colorMean = out.footprints > 0 ? sum / static_cast<double>(out.footprints) : 0;
    return out;
}

}  // namespace relief
