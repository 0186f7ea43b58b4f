// Speed of the compared methods and filters on the rays or pixels of the view.
#include "measuring/bench/filter_queries.h"
#include "measuring/bench/pareto.h"
#include "measuring/bench/view_bench.h"
#include "measuring/quantiles.h"
#include "panes/compare/compare_data.h"
#include "rendering/base_level.h"
#include "workspace/discard.h"

namespace reliefui {

namespace {

using relief::CompareSubject;

constexpr int kRounds = 7;
// Largest number of pixels used to time filters: some of the frame's tiles.
constexpr std::size_t kFilteredPixels = 16384;

void addMethodRates(ComparedView& view, const Snapshot& snapshot, relief::Work& work) {
    std::vector<relief::MethodChoice> methods;
    const auto ofView = [&](const ComparedPicture& picture) {
        return relief::methodOfView(*snapshot.request, picture.choice);
    };
    for (const ComparedPicture& picture : view.pictures) {
        if (picture.traces && !picture.problem) methods.push_back(ofView(picture));
    }
    const relief::RayBlock rays = relief::sampledRays(*snapshot.frame, kComparedRays);
    if (methods.empty() || rays.size() == 0) return;
    const std::vector<relief::BenchRow> rows =
        relief::benchRaysOfView(snapshot.request->field, rays, methods, kRounds, *snapshot.maps, work);
    view.rays = rays.size();
    for (ComparedPicture& picture : view.pictures) {
        for (const relief::BenchRow& row : rows) {
            if (relief::shortMethodName(row.method) != relief::shortMethodName(ofView(picture))) continue;
            picture.rate = row.rate / 1e6;
            picture.spread = row.spread;
            picture.steps = row.stepsMean;
        }
    }
}

void addFilterRates(ComparedView& view, const Snapshot& snapshot, relief::Work& work) {
    std::vector<const relief::TextureFilter*> filters;
    std::vector<ComparedPicture*> timed;
    for (ComparedPicture& picture : view.pictures) {
        if (!picture.traces || !picture.frame || !picture.frame->filter) continue;
        filters.push_back(picture.frame->filter.get());
        timed.push_back(&picture);
    }
    const std::vector<glm::ivec2> pixels = relief::sampledTiles(*snapshot.frame, kFilteredPixels);
    const relief::FilterQueries queries(*snapshot.frame, *snapshot.request, pixels);
    if (filters.empty() || queries.size() == 0) return;
    queries.rates(filters, 1, work);  // warm-up
    const auto rates = queries.rates(filters, kRounds, work);
    view.rays = queries.size();
    for (std::size_t f = 0; f < filters.size(); ++f) {
        timed[f]->rate = relief::quantile(rates[f], 0.5) / 1e6;
        timed[f]->spread = relief::relativeSpread(rates[f]);
    }
}

}  // namespace

std::shared_ptr<const ComparedView> withRates(const ComparedView& view, const Snapshot& snapshot, relief::Work& work) {
    auto timed = makeFreedInBackground<ComparedView>(view);
    const CompareSubject subject = view.scenario.comparison.subject;
    if (subject == CompareSubject::Methods) addMethodRates(*timed, snapshot, work);
    if (subject == CompareSubject::Filters) addFilterRates(*timed, snapshot, work);
    timed->rounds = kRounds;
    timed->rated = true;
    return timed;
}

}  // namespace reliefui
