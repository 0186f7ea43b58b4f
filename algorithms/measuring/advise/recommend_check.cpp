// Compares the advice with a complete measurement of all forms.
#include <algorithm>
#include <cmath>

#include "measuring/advise/recommend_trials.h"
#include "measuring/quantiles.h"
#include "measuring/random_rays.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kOtherRays = 77;  // stream number for seedFor()
constexpr int kTableRounds = 16;

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Measures every form that was built and keeps the memory limit, without dropping any.
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

bool keepsBounds(std::span<const CheckedRelief> reliefs) {
    return std::all_of(reliefs.begin(), reliefs.end(),
                       [](const CheckedRelief& relief) { return relief.advice.keepsBound; });
}

std::string regretText(std::span<const CheckedRelief> reliefs) {
    constexpr int kDigits = 3;
    const auto percent = [](double share) { return readable(100 * share, kDigits); };
    std::vector<TableRow> rows{{"", "regret %", "beyond %", "chosen", "best in the full table"}};
    std::vector<double> regrets;
    double advised = 0;
    double measured = 0;
    for (const auto& [name, advice] : reliefs) {
        const bool valid = advice.anyIsValid();
        if (valid) regrets.push_back(advice.regret());
        advised += advice.adviceSeconds;
        measured += advice.tableSeconds;
        rows.push_back({name, valid ? percent(advice.regret()) : "-",
                        percent(advice.chosenBeyond) + (advice.keepsBound ? "" : "!"), methodText(advice.chosen),
                        valid ? methodText(advice.best) : "no method stays within all bounds"});
    }
    const auto summary = [&](double share) {
        return regrets.empty() ? std::string("-") : percent(quantile(regrets, share)) + "%";
    };
    return textTable(rows, 1, 3) + "regret: median " + summary(0.5) + ", worst " + summary(1) + "; advice " +
           readable(advised, kDigits) + " s, full tables " + readable(measured, kDigits) + " s\n";
}

}  // namespace relief
