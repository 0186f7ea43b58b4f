#include "measuring/compare/duel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measuring/compare/rational_hit.h"
#include "relief/sampled_surface.h"
#include "relief/tracers.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Returns true for a log record of a search that moves on, which claims that there is no hit up to lambdaAfter.
bool moves(const Step& step) {
    switch (step.decision) {
        case Decision::Skip:
        case Decision::Advance:
        case Decision::Test:
        case Decision::Hit:
            return step.phase != Phase::Refine;
        default:
            return false;
    }
}

class Judge {
  public:
    Judge(const DuelRun& run, const Hit& exact, const ViewRay& ray, const HeightField& field)
        : run_(run),
          exact_(exact),
          ray_(ray),
          field_(field),
          surface_(field, ray),
          scale_(std::max(1.0, std::hypot(ray.a, ray.b))) {}

    Judgement judgement() {
        Judgement out;
        if (exact_.outcome == Outcome::Limit) return out;
        out.texels = answerError(run_.hit, exact_, ray_);
        const auto past = firstPast();
        if (past && run_.steps[*past].lambdaAfter > exact_.lambda + margin()) out.overshoot = past;
        if (out.texels <= kSameAnswer || run_.steps.empty()) return out;
        if (const auto rational = disputed() ? rationalHit(field_, ray_) : std::nullopt) {
            out.withinRounding = judgeHit(field_, ray_, run_.hit, *rational) != RationalVerdict::Wrong;
            if (out.withinRounding) return out;
        }
        if (past) {
            passed(out, *past);
        } else {
            stopped(out);
        }
        return out;
    }

  private:
    double margin() const { return kSameAnswer / scale_; }

    // Whether both answers may be right: then each ends on the surface. On columns that is not looked at, because a
    // hit of a wall is not at its height.
    bool disputed() const {
        if (field_.tiles() != nullptr || run_.hit.outcome == Outcome::Limit) return false;
        const auto onSurface = [&](const Hit& hit) {
            return hit.outcome != Outcome::Hit || field_.surface() == Surface::Columns ||
                   std::abs(surface_.gapAt(hit.lambda)) <= kSameAnswer;
        };
        return onSurface(run_.hit) && onSurface(exact_);
    }

    // Returns the first step that moves on to, or answers with, a point behind the exact hit, or that reports a miss.
    std::optional<std::size_t> firstPast() const {
        if (exact_.outcome != Outcome::Hit) return std::nullopt;
        for (std::size_t k = 0; k < run_.steps.size(); ++k) {
            const Step& step = run_.steps[k];
            if (moves(step) && step.lambdaAfter > exact_.lambda + margin()) return k;
            if (step.decision == Decision::Miss) return k;
        }
        return std::nullopt;
    }

    void at(Judgement& out, Departure kind, std::size_t step, double from, double to) const {
        out.kind = kind;
        out.step = step;
        // The interval must contain the hit; a preceding interval may not have been recorded.
        const bool ahead = kind != Departure::StoppedEarly;
        out.from = ahead ? std::min(from, exact_.lambda) : from;
        out.to = to;
    }

    // Returns the last refinement step.
    std::optional<std::size_t> lastRefinement() const {
        for (std::size_t k = run_.steps.size(); k-- > 0;) {
            if (run_.steps[k].decision == Decision::Refine) return k;
        }
        return std::nullopt;
    }

    // Classifies a search that has found an interval with the hit in it but answers wrongly.
    void foundWithin(Judgement& out, std::size_t step) const {
        const Step& found = run_.steps[step];
        const auto refined = lastRefinement();
        const double from = std::min(found.lambdaIn, exact_.lambda);
        if (refined) {
            at(out, Departure::InterpolationLeak, *refined, from, std::max(found.lambdaOut, exact_.lambda));
        } else {
            at(out, Departure::NotRefined, step, from, found.lambdaAfter);
        }
    }

    void passed(Judgement& out, std::size_t k) const {
        const Step& step = run_.steps[k];
        const double to = std::max(step.lambdaAfter, step.lambdaOut);
        // The point up to which the search moved is below the surface, so testing it would reveal the hit.
        const bool below = surface_.gapAt(std::min(to, 1.0)) >= 0;
        const bool refines = k + 1 < run_.steps.size() && run_.steps[k + 1].decision == Decision::Refine;
        if (answersFromEntry(step, k > 0 ? &run_.steps[k - 1] : nullptr)) {
            return at(out, Departure::TakenAsFlat, k, step.lambdaIn, to);
        }
        if (step.decision == Decision::Hit) {
            if (below || lastRefinement()) return foundWithin(out, k);
            return at(out, Departure::MissedSpike, k, step.lambdaIn, to);
        }
        // A relaxed cone may end below the surface, but not behind a further crossing.
        const auto* const cone = step.as<subject::Cone>();
        if (below && (refines || (cone != nullptr && cone->relaxed))) return foundWithin(out, k);
        if (step.decision == Decision::Skip || step.trustsMap()) {
            return at(out, Departure::UnsafeMap, k, step.lambdaIn, to);
        }
        if (step.decision == Decision::Test) {
            return at(out, Departure::InterpolationLeak, k, step.lambdaIn, to);
        }
        at(out, Departure::MissedSpike, k, std::min(step.lambdaIn, exact_.lambda), to);
    }

    void stopped(Judgement& out) const {
        const std::size_t last = run_.steps.size() - 1;
        const Step& step = run_.steps[last];
        const auto refined = lastRefinement();
        const bool hit = run_.hit.outcome == Outcome::Hit;
        // The search has an interval that contains the hit, but interpolates another place in it.
        if (hit && exact_.outcome == Outcome::Hit && refined && step.lambdaOut >= exact_.lambda) {
            return foundWithin(out, last);
        }
        at(out, Departure::StoppedEarly, last, step.lambdaIn, hit ? run_.hit.lambda : step.lambdaAfter);
    }

    const DuelRun& run_;
    Hit exact_;
    ViewRay ray_;
    const HeightField& field_;
    SampledSurface surface_;
    double scale_;
};

// Returns how far along the ray a run is after each step; the value never decreases.
std::vector<double> reaches(const DuelRun& run) {
    std::vector<double> out;
    double reached = 0;
    for (const Step& step : run.steps) {
        if (moves(step) || step.decision == Decision::Miss) reached = std::max(reached, step.lambdaAfter);
        out.push_back(reached);
    }
    return out;
}

}  // namespace

Judgement judge(const DuelRun& run, const Hit& exact, const ViewRay& ray, const HeightField& field) {
    return Judge(run, exact, ray, field).judgement();
}

Message departureTitle(const Judgement& judgement) {
    if (judgement.withinRounding) return Message(MessageId::DuelRounding);
    constexpr std::array kTitles{MessageId::DuelAgrees,     MessageId::DuelMissedSpike, MessageId::DuelStoppedEarly,
                                 MessageId::DuelUnsafeMap,  MessageId::DuelLeak,        MessageId::DuelNotRefined,
                                 MessageId::DuelTakenAsFlat};
    return Message(kTitles[static_cast<std::size_t>(judgement.kind)]);
}

Message judgementSentence(const DuelRun& run, const Judgement& judgement, const Hit& exact) {
    constexpr int kDecimals = 5;
    constexpr int kValueDigits = 4;
    if (judgement.withinRounding) return Message(MessageId::DuelSaysRounding, {{"method", run.name}});
    if (judgement.kind == Departure::None) {
        return Message(MessageId::DuelSaysAgrees, {{"method", run.name}, {"texels", numberText(kSameAnswer, 2)}});
    }
    const Step& step = run.steps[judgement.step];
    const bool met = exact.outcome == Outcome::Hit;
    const auto say = [&](MessageId id) {
        return Message(id, {{"method", run.name},
                            {"step", judgement.step + 1},
                            {"from", fixedText(judgement.from, kDecimals)},
                            {"to", fixedText(judgement.to, kDecimals)},
                            {"exact", met ? fixedText(exact.lambda, kDecimals) : std::string()},
                            {"at", fixedText(run.hit.lambda, kDecimals)},
                            {"value", numberText(step.value, kValueDigits)}});
    };
    const auto* const cone = step.as<subject::Cone>();
    const bool relaxed = cone != nullptr && cone->relaxed;
    switch (judgement.kind) {
        case Departure::TakenAsFlat:
            return say(MessageId::DuelSaysTakenAsFlat);
        case Departure::MissedSpike:
            return say(MessageId::DuelSaysSpike);
        case Departure::UnsafeMap:
            return say(relaxed ? MessageId::DuelSaysUnsafeRelaxed : MessageId::DuelSaysUnsafe);
        case Departure::InterpolationLeak:
            return say(MessageId::DuelSaysLeak);
        case Departure::NotRefined:
            return say(MessageId::DuelSaysNotRefined);
        default:
            return say(met ? MessageId::DuelSaysEarly : MessageId::DuelSaysEarlyMiss);
    }
}

LockStep lockStep(const std::vector<DuelRun>& runs) {
    std::vector<std::vector<double>> reached;
    for (const DuelRun& run : runs) reached.push_back(reaches(run));
    LockStep out;
    std::vector<std::size_t> now(runs.size(), 0);
    const auto ended = [&](std::size_t r) { return now[r] + 1 >= reached[r].size(); };
    while (true) {
        out.moments.push_back(now);
        double behind = std::numeric_limits<double>::infinity();
        for (std::size_t r = 0; r < runs.size(); ++r) {
            if (!ended(r)) behind = std::min(behind, reached[r][now[r]]);
        }
        if (std::isinf(behind)) return out;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            if (!ended(r) && reached[r][now[r]] <= behind) ++now[r];
        }
    }
}

std::size_t LockStep::momentOf(std::size_t run, std::size_t step) const {
    for (std::size_t m = 0; m < moments.size(); ++m) {
        if (moments[m][run] >= step) return m;
    }
    return moments.size() - 1;
}

std::optional<std::size_t> firstToDepart(const LockStep& moments, const std::vector<Judgement>& judgements) {
    std::optional<std::size_t> first;
    std::size_t earliest = 0;
    for (std::size_t r = 0; r < judgements.size(); ++r) {
        if (judgements[r].kind == Departure::None) continue;
        const std::size_t moment = moments.momentOf(r, judgements[r].step);
        if (first && moment >= earliest) continue;
        first = r;
        earliest = moment;
    }
    return first;
}

}  // namespace relief
