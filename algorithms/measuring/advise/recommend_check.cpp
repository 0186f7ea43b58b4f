// The advice held against the full table.
#include <algorithm>
#include <cmath>

#include "measuring/advise/recommend_trials.h"
#include "measuring/quantiles.h"
#include "measuring/random_rays.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kOtherRays = 77;  // purpose of the seed
constexpr int kTableRounds = 16;

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Every form that was built and keeps the memory, to the end.
void measureAll(const AdviceOptions& options, const AdviceRays& rays, std::vector<AdviceTrial*>& table, Work& work) {
    for (AdviceTrial* trial : table) {
        rays.count(*trial, AdviceRays::kBlocks, work);
        trial->times.clear();
    }
    if (options.form == Form::Scalar) return;
    std::vector<double> middles;
    for (int round = 0; round < kTableRounds; ++round) {
        std::vector<double> times;
        for (AdviceTrial* trial : table) {
            rays.time(*trial, static_cast<std::size_t>(round), work);
            times.push_back(trial->times.back());
        }
        middles.push_back(quantile(times, 0.5));
    }
    for (AdviceTrial* trial : table) {
        for (std::size_t r = 0; r < middles.size(); ++r) trial->times[r] /= middles[r];
        trial->facts.cost = quantile(trial->times, 0.5) * quantile(middles, 0.5);
    }
}

}  // namespace

AdviceRegret adviceRegret(const AdviceOptions& options, Work& work) {
    AdviceRegret result;
    auto begun = Clock::now();
    std::size_t stillClose = 0;
    std::vector<AdviceTrial> trials = runTrials(options, true, stillClose, work);
    const Advice advice = adviceOf(options, trials);
    result.chosen = advice.best().method;
    result.adviceSeconds = secondsSince(begun);
    begun = Clock::now();
    const AdviceRays rays(options, seedFor(options.seed, kOtherRays), work);
    std::vector<AdviceTrial*> table;
    for (AdviceTrial& trial : trials) {
        if (trial.tracer) table.push_back(&trial);
    }
    measureAll(options, rays, table, work);
    result.measured = table.size();
    result.bestCost = std::numeric_limits<double>::infinity();
    const auto keepsBounds = [&](const AdvisedForm& facts) { return rays.keepsBound(facts) && rays.keepsSteps(facts); };
    for (const AdviceTrial* trial : table) {
        const AdvisedForm& facts = trial->facts;
        if (facts.method == result.chosen) {
            result.chosenCost = facts.cost;
            result.chosenBeyond = facts.beyond;
            result.keepsBound = keepsBounds(facts) || !advice.keepsBounds;
        }
        if (keepsBounds(facts) && facts.cost < result.bestCost) {
            result.bestCost = facts.cost;
            result.best = facts.method;
        }
    }
    result.tableSeconds = secondsSince(begun);
    return result;
}

}  // namespace relief
