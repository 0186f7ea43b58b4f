#include "measuring/advise/recommend.h"

#include <algorithm>
#include <cmath>

#include "measuring/advise/recommend_trials.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// Shares of the given time: for building all maps, for one map, for the filters.
constexpr double kBuilding = 0.55;
constexpr double kOneMap = 0.2;
constexpr double kFilters = 0.2;
// Share of the given time for rebuilding maps of forms that are named, at least, also when the time is up.
constexpr double kVerifying = 0.1;
constexpr int kRounds = 32;
constexpr int kFewestRounds = 3;
// A form whose first measurement is this many times the best cost is dropped. The factor for counts is smaller because,
// unlike times, they do not scatter.
constexpr double kOutAtOnce = 4;
constexpr double kOutByCounts = 1.5;
// Rays of a picture of one million pixels, with whose time the building time of a map is compared.
constexpr double kPictureRays = 1e6;

// Returns the factor above the best cost at which a form is dropped after this many rounds.
double outAfter(int rounds) {
    return 1 + std::max(1.6 / std::sqrt(static_cast<double>(rounds)) - 0.2, 0.08);
}

// As adviceOf(), for a relief with these figures.
Advice ranked(const AdviceOptions& options, const std::vector<AdviceTrial>& trials, const ReliefFigures& relief);

// Returns true if the advice names the method as one that keeps the bounds.
bool names(const Advice& advice, const MethodChoice& method) {
    const auto is = [&](std::optional<std::size_t> form) { return form && advice.forms[*form].method == method; };
    return is(advice.chosen) || is(advice.next) || is(advice.withoutMap) || is(advice.rebuilt);
}

class Elimination {
  public:
    Elimination(const AdviceOptions& options, bool keepAll, Work& work)
        : options_(options), keepAll_(keepAll), work_(work), rays_(options, options.seed, work), maps_(options, work) {}

    std::vector<AdviceTrial> run(std::size_t& stillClose) {
        const std::vector<MethodChoice> forms =
            options_.forms.empty() ? adviceForms(options_.field, lowest(), options_.maxSteps, options_.form)
                                   : options_.forms;
        // Each form is one step, and so is each round of the remaining forms; building maps and tracing rays are nested
        // stages.
        WholeProgress progress(work_.progress(), "recommend", static_cast<std::int64_t>(forms.size()) + kRounds);
        for (const MethodChoice& form : forms) {
            trials_.emplace_back();
            trials_.back().facts.method = form;
        }
        screen(progress);
        if (options_.form == Form::Simd) {
            rounds(stillClose, progress);
        } else {
            byCounts();
        }
        for (AdviceTrial* trial : live()) verify(*trial);
        verifyNamed();
        return std::move(trials_);
    }

  private:
    double lowest() const { return options_.views.front() ? *options_.views.front() : kLowestRandomElevation; }
    // When the time for comparing forms is up, in seconds since the beginning.
    double formsUntil() const { return (1 - (options_.filters ? kFilters : 0)) * options_.seconds; }
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

    void drop(AdviceTrial& trial, Verdict verdict) const {
        trial.facts.verdict = verdict;
        if (!keepAll_) trial.tracer.reset();
    }

    // Builds each form, counts it on one block of rays and times it once.
    void screen(WholeProgress& progress) {
        const double building = elapsed() + kBuilding * options_.seconds;
        double best = std::numeric_limits<double>::infinity();
        for (AdviceTrial& trial : trials_) {
            maps_.make(trial, std::min(kOneMap * options_.seconds, building - elapsed()));
            progress.advance();
            if (!trial.tracer) continue;
            rays_.count(trial, 1, work_);
            // Forms without a guarantee are tested on all rays at once: if such a form broke the error bound only
            // later, it would already have eliminated better forms.
            if (trial.facts.guarantee == Guarantee::Approximate && rays_.keepsBound(trial.facts)) {
                rays_.count(trial, AdviceRays::kBlocks, work_);
            }
            rays_.time(trial, 0, work_);
            setTime(trial, trial.times.front());
            if (!rays_.keepsBound(trial.facts)) {
                drop(trial, Verdict::Error);
                continue;
            }
            if (!rays_.keepsSteps(trial.facts)) {
                drop(trial, Verdict::Steps);
                continue;
            }
            best = std::min(best, trial.facts.cost);
            if (trial.facts.cost > kOutAtOnce * best) drop(trial, Verdict::Slow);
            trial.times.clear();
        }
    }

    void setTime(AdviceTrial& trial, double seconds) const {
        trial.facts.secondsPerRay = seconds;
        if (options_.form == Form::Simd) trial.facts.cost = seconds;
    }

    std::vector<AdviceTrial*> live() {
        std::vector<AdviceTrial*> all;
        for (AdviceTrial& trial : trials_) {
            if (trial.facts.verdict == Verdict::Kept && trial.tracer) all.push_back(&trial);
        }
        return all;
    }

    void rounds(std::size_t& stillClose, WholeProgress& progress) {
        std::vector<double> middles;  // median time of each round, over the forms in it
        const double until = formsUntil();
        std::vector<AdviceTrial*> in = live();
        for (int round = 0; round < kRounds && in.size() > 1; ++round) {
            if (round >= kFewestRounds && elapsed() > until) {
                stillClose = static_cast<std::size_t>(std::count_if(in.begin(), in.end(), [&](const AdviceTrial* t) {
                    return t->facts.cost <= (1 + 0.01 * kClosePercent) * in.front()->facts.cost;
                }));
                if (stillClose == 1) stillClose = 0;
                break;
            }
            std::vector<double> times;
            for (AdviceTrial* trial : in) {
                rays_.time(*trial, static_cast<std::size_t>(round), work_);
                times.push_back(trial->times.back());
            }
            middles.push_back(quantile(times, 0.5));
            judge(in, middles);
            progress.advance();
        }
    }

    // Sets the costs to the median over the rounds, each round normalised by its median time; drops forms that are too
    // expensive; sorts the rest by cost.
    void judge(std::vector<AdviceTrial*>& in, const std::vector<double>& middles) {
        const double scale = quantile(middles, 0.5);
        for (AdviceTrial* trial : in) {
            std::vector<double> ratios;
            for (std::size_t r = 0; r < trial->times.size(); ++r) ratios.push_back(trial->times[r] / middles[r]);
            setTime(*trial, quantile(ratios, 0.5) * scale);
            trial->facts.rounds = static_cast<int>(ratios.size());
        }
        std::stable_sort(in.begin(), in.end(),
                         [](const AdviceTrial* a, const AdviceTrial* b) { return a->facts.cost < b->facts.cost; });
        const auto rounds = static_cast<int>(middles.size());
        if (rounds < kFewestRounds) return;
        const double out = outAfter(rounds) * in.front()->facts.cost;
        std::erase_if(in, [&](AdviceTrial* trial) {
            if (trial->facts.cost <= out) return false;
            drop(*trial, Verdict::Slow);
            return true;
        });
    }

    // Drops forms by their counted cost.
    void byCounts() {
        double best = std::numeric_limits<double>::infinity();
        for (const AdviceTrial* trial : live()) best = std::min(best, trial->facts.cost);
        for (AdviceTrial* trial : live()) {
            if (trial->facts.cost > kOutByCounts * best) drop(*trial, Verdict::Slow);
        }
    }

    // Drops the form if it breaks a bound on the whole set of rays.
    void verify(AdviceTrial& trial) const {
        rays_.count(trial, AdviceRays::kBlocks, work_);
        if (!rays_.keepsBound(trial.facts)) {
            drop(trial, Verdict::Error);
        } else if (!rays_.keepsSteps(trial.facts)) {
            drop(trial, Verdict::Steps);
        }
    }

    // Returns true for a slow form that was counted on a part of the rays and may break a bound on the others.
    bool isUnverified(const AdviceTrial& trial) const {
        return trial.facts.verdict == Verdict::Slow && trial.blocks < AdviceRays::kBlocks &&
               (options_.maxSteps > 0 || trial.facts.guarantee != Guarantee::Exact);
    }

    // Verifies the slow forms that the advice names, for example as the best one without a map. The other ones are not
    // worth the time. Those whose map cannot be built in the time that is left are dropped.
    void verifyNamed() {
        const auto unverified = [&](const AdviceTrial& trial) { return isUnverified(trial); };
        if (std::none_of(trials_.begin(), trials_.end(), unverified)) return;
        const ReliefFigures relief = reliefFigures(options_.field);
        const double until = std::max(formsUntil(), elapsed() + kVerifying * options_.seconds);
        for (;;) {
            const Advice advice = ranked(options_, trials_, relief);
            const auto named = std::find_if(trials_.begin(), trials_.end(), [&](const AdviceTrial& trial) {
                return isUnverified(trial) && names(advice, trial.facts.method);
            });
            if (named == trials_.end()) return;
            if (!named->tracer) {
                named->facts.verdict = Verdict::Kept;
                maps_.make(*named, std::min(kOneMap * options_.seconds, until - elapsed()));
                if (!named->tracer) continue;
                named->facts.verdict = Verdict::Slow;
            }
            verify(*named);
        }
    }

    const AdviceOptions& options_;
    bool keepAll_;
    Work& work_;
    Clock::time_point begun_ = Clock::now();
    AdviceRays rays_;
    AdviceMaps maps_;
    std::vector<AdviceTrial> trials_;
};

// Orders kept forms before slower ones before the rest; each group by cost.
bool before(const AdvisedForm& a, const AdvisedForm& b) {
    const auto rank = [](const AdvisedForm& form) {
        return form.verdict == Verdict::Kept ? 0 : form.verdict == Verdict::Slow ? 1 : 2;
    };
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return rank(a) < 2 && a.cost < b.cost;
}

bool keepsBounds(const AdvisedForm& form) {
    return form.verdict == Verdict::Kept || form.verdict == Verdict::Slow;
}

bool leaner(const AdvisedForm& a, const AdvisedForm& b) {
    return a.bytes != b.bytes ? a.bytes < b.bytes : a.buildSeconds < b.buildSeconds;
}

// Returns the form with the fewest rays past the error bound among those that keep the step limit; if none does, the
// form that exceeds the limit for the fewest rays.
std::size_t nearestToBounds(const AdviceOptions& options, const std::vector<AdvisedForm>& forms) {
    std::size_t best = 0;
    const auto worse = [&](const AdvisedForm& form) {
        const bool measured = form.beyond >= 0;  // NaN: not measured
        const bool fits = measured && (options.maxSteps == 0 || form.overSteps <= options.outliers);
        return fits ? form.beyond : 2 + (measured ? form.overSteps : 1);
    };
    for (std::size_t f = 1; f < forms.size(); ++f) {
        if (worse(forms[f]) < worse(forms[best])) best = f;
    }
    return best;
}

// For heights that change after each picture, compares forms by building time plus one picture.
void weighBuilding(Advice& advice) {
    const AdvisedForm& best = advice.best();
    const auto whole = [](const AdvisedForm& form) { return form.buildSeconds + kPictureRays * form.secondsPerRay; };
    std::size_t cheapest = advice.chosen;
    for (std::size_t f = 0; f < advice.forms.size(); ++f) {
        const AdvisedForm& form = advice.forms[f];
        if (keepsBounds(form) && whole(form) < whole(advice.forms[cheapest])) cheapest = f;
    }
    const AdvisedForm& other = advice.forms[cheapest];
    // The other form is mentioned only if building dominates clearly: the chosen form's map must take several pictures
    // to pay for itself.
    constexpr double kDominates = 2;
    if (cheapest == advice.chosen || whole(best) < kDominates * whole(other)) return;
    advice.rebuilt = cheapest;
    advice.paysAfterRays = other.secondsPerRay > best.secondsPerRay
                               ? (best.buildSeconds - other.buildSeconds) / (other.secondsPerRay - best.secondsPerRay)
                               : std::numeric_limits<double>::infinity();
}

Advice ranked(const AdviceOptions& options, const std::vector<AdviceTrial>& trials, const ReliefFigures& relief) {
    Advice advice;
    advice.relief = relief;
    for (const AdviceTrial& trial : trials) advice.forms.push_back(trial.facts);
    std::stable_sort(advice.forms.begin(), advice.forms.end(), before);
    std::vector<AdvisedForm>& forms = advice.forms;
    // Among forms of equal cost within kAdviceTie, the one with the smallest map is chosen.
    for (std::size_t f = 1; f < forms.size() && forms[f].verdict == Verdict::Kept; ++f) {
        if (forms[f].cost <= (1 + kAdviceTie) * forms[0].cost && leaner(forms[f], forms[advice.chosen])) {
            advice.chosen = f;
        }
    }
    for (std::size_t f = 0; f < forms.size(); ++f) {
        if (forms[f].method.name == "exact") advice.exact = f;
        if (!advice.withoutMap && keepsBounds(forms[f]) && forms[f].bytes == 0) advice.withoutMap = f;
    }
    // Over a flat map every method reaches the hit at once, so that no map is worth building.
    if (advice.relief.flat && advice.withoutMap) advice.chosen = advice.cheapest = *advice.withoutMap;
    advice.keepsBounds = keepsBounds(forms[advice.chosen]);
    if (!advice.keepsBounds) advice.chosen = advice.cheapest = nearestToBounds(options, forms);
    advice.next = advice.chosen;
    if (advice.chosen == 0 && forms.size() > 1 && keepsBounds(forms[1])) advice.next = 1;
    if (advice.keepsBounds) weighBuilding(advice);
    return advice;
}

}  // namespace

double adviceSeconds(const HeightField& field) {
    constexpr double kShort = 4, kLongest = 16, kSide = 1024;
    return kShort *
           std::clamp(std::sqrt(static_cast<double>(field.width()) * field.height()) / kSide, 1.0, kLongest / kShort);
}

std::vector<AdviceTrial> runTrials(const AdviceOptions& options, bool keepAll, std::size_t& stillClose, Work& work) {
    return Elimination(options, keepAll, work).run(stillClose);
}

Advice adviceOf(const AdviceOptions& options, const std::vector<AdviceTrial>& trials) {
    return ranked(options, trials, reliefFigures(options.field));
}

Advice recommend(const AdviceOptions& options, Work& work) {
    std::size_t stillClose = 0;
    Advice advice = adviceOf(options, runTrials(options, false, stillClose, work));
    advice.stillClose = stillClose;
    if (options.filters) advice.filter = recommendFilter(options, kFilters * options.seconds, work);
    return advice;
}

}  // namespace relief
