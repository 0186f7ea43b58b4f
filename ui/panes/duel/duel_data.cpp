#include "panes/duel/duel_data.h"

#include <algorithm>
#include <filesystem>

#include "measuring/bench/measured_method.h"
#include "measuring/bench/pareto.h"
#include "panes/profile/profile_figure.h"
#include "rendering/base_level.h"
#include "scenario/variation.h"

namespace reliefui {

std::optional<std::size_t> Duel::firstMoment() const {
    if (!first) return std::nullopt;
    return steps.momentOf(*first, judgements[*first].step);
}

DuelSource Duel::source() const {
    DuelSource out;
    out.profile = profileSource(*snapshot);
    out.profile.steps = nullptr;
    out.profile.hit = exact;
    out.profile.exact = {};  // marked by the duel itself
    for (const relief::DuelRun& run : runs) {
        const bool farther =
            run.hit.outcome == relief::Outcome::Hit &&
            (out.profile.hit.outcome != relief::Outcome::Hit || run.hit.lambda > out.profile.hit.lambda);
        if (farther) out.profile.hit = run.hit;
    }
    out.runs = &runs;
    out.judgements = &judgements;
    out.exact = exact;
    out.first = first;
    return out;
}

double Duel::closeUp() const {
    const auto moment = firstMoment();
    if (!moment) return 0;
    const relief::Judgement& fault = judgements[*first];
    double end = std::max(fault.from, fault.to);
    if (exact.outcome == relief::Outcome::Hit) end = std::max(end, exact.lambda);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::size_t step = steps.moments[*moment][r];
        if (step < runs[r].steps.size()) end = std::max(end, duelPlace(runs[r].steps[step]));
    }
    return std::min(end, 1.0);
}

bool Duel::within(double lambda, std::size_t moment) const {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::size_t step = steps.moments[moment][r];
        if (step < runs[r].steps.size() && duelPlace(runs[r].steps[step]) > lambda) return false;
    }
    return true;
}

std::vector<relief::MethodChoice> duelRivals(const relief::Scenario& scenario) {
    if (scenario.other && scenario.comparison.others.empty()) return {};
    return relief::rivalsOf(scenario);
}

std::shared_ptr<const Duel> makeDuel(std::shared_ptr<const Snapshot> snapshot,
                                     const std::vector<relief::MethodChoice>& rivals, relief::Work& work) {
    auto duel = std::make_shared<Duel>();
    duel->snapshot = snapshot;
    const PixelTrace& shown = snapshot->trace;
    const relief::HeightField& field = snapshot->request->field;
    duel->exact = shown.exact;
    const auto trace = [&](const relief::MethodChoice& method) {
        relief::RayBlock rays;
        rays.push(shown.ray);
        relief::HitBlock hits;
        relief::StepLog log;
        const relief::MethodChoice inView = relief::methodOfView(*snapshot->request, method);
        relief::makeTracer(inView, field, *snapshot->maps, work)->trace(rays, hits, log, work);
        duel->runs.push_back({relief::shortMethodName(method), hits[0], std::move(log.steps)});
    };
    if (shown.fromFile) {
        trace(snapshot->scenario.method);
    } else {
        const relief::MethodChoice& method = snapshot->scenario.method;
        duel->runs.push_back({relief::shortMethodName(method), shown.hit, shown.steps});
    }
    for (const relief::MethodChoice& rival : rivals) {
        if (relief::supports(rival, field.surface(), field.address())) trace(rival);
    }
    if (snapshot->other) {
        const std::string name = std::filesystem::path(snapshot->scenario.other.steps).filename().string();
        duel->runs.push_back({name, snapshot->other->hit, snapshot->other->steps});
    }
    for (const relief::DuelRun& run : duel->runs) {
        duel->judgements.push_back(relief::judge(run, duel->exact, shown.ray, field));
    }
    duel->steps = relief::lockStep(duel->runs);
    // The method whose steps all panes show comes first: its own error is the one to be explained.
    const std::size_t own = duel->own();
    duel->first = duel->judgements[own].kind != relief::Departure::None
                      ? own
                      : relief::firstToDepart(duel->steps, duel->judgements);
    return duel;
}

}  // namespace reliefui
