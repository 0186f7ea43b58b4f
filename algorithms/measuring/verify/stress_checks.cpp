#include "measuring/verify/stress_checks.h"

#include <cmath>

#include "measuring/compare/rational_hit.h"
#include "measuring/overshoot.h"
#include "relief/cell_grid.h"
#include "scenario/ray_files.h"

namespace relief {

namespace {

std::string described(const Hit& hit) {
    return hit.outcome == Outcome::Hit ? "lambda " + numberText(hit.lambda) : std::string(outcomeName(hit.outcome));
}

std::optional<StressFault> valueFault(const ViewRay& ray, const Hit& hit) {
    if (hit.outcome == Outcome::Unset) return StressFault{"not-finite", "no outcome"};
    if (hit.outcome != Outcome::Hit) return std::nullopt;
    if (!(hit.lambda >= 0 && hit.lambda <= 1) || !std::isfinite(hit.s) || !std::isfinite(hit.t)) {
        return StressFault{
            "not-finite", "lambda " + numberText(hit.lambda) + ", s " + numberText(hit.s) + ", t " + numberText(hit.t)};
    }
    const Hit expected = Hit::at(ray, hit.lambda);
    if (hit.s == expected.s && hit.t == expected.t) return std::nullopt;
    return StressFault{"inconsistent",
                       "s " + numberText(hit.s) + ", t " + numberText(hit.t) + " at lambda " + numberText(hit.lambda)};
}

std::optional<StressFault> promiseFault(Guarantee guarantee, bool inDomain, const Hit& hit, const Hit& reference) {
    const std::string both = described(hit) + ", exact: " + described(reference);
    if (guarantee == Guarantee::Approximate || !inDomain) return std::nullopt;
    if (guarantee == Guarantee::Exact) {
        if (hit.outcome == Outcome::Limit) return StressFault{"limit", both};
        if (!sameHit(hit, reference)) return StressFault{"bits", both};
        return std::nullopt;
    }
    if (reference.outcome != Outcome::Hit) return std::nullopt;
    if (overshoots(hit, reference)) return StressFault{"overshoot", both};
    return std::nullopt;
}

Outcome endOf(Decision decision) {
    if (decision == Decision::Hit) return Outcome::Hit;
    if (decision == Decision::Miss) return Outcome::Miss;
    return decision == Decision::Limit ? Outcome::Limit : Outcome::Unset;
}

}  // namespace

bool sameHit(const Hit& a, const Hit& b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.outcome == b.outcome && same(a.lambda, b.lambda) && same(a.s, b.s) && same(a.t, b.t);
}

std::optional<StressFault> answerFault(const Tracer& tracer, const ViewRay& ray, const CountedHit& answer,
                                       const Hit& reference) {
    if (auto fault = valueFault(ray, answer.hit)) return fault;
    const HeightField& field = tracer.field();
    if (answer.hit.outcome == Outcome::Miss && field.address() != Address::Border) {
        return StressFault{"miss", "exact: " + described(reference)};
    }
    const bool inDomain = GridRay(CellGrid(field), ray).inDomain();
    if (auto fault = promiseFault(tracer.guarantee(), inDomain, answer.hit, reference)) {
        // Whether a ray hits a tip that it touches within rounding is undecided in double: a march may pass it.
        const auto exact = fault->check == "overshoot" ? rationalHit(field, ray) : std::nullopt;
        if (!exact || exact->clearance > 2 * placeRounding(field, ray)) return fault;
    }
    const double bound = tracer.stepBound(ray);
    if (!(answer.steps <= bound)) {
        return StressFault{"steps", std::to_string(answer.steps) + " steps, but at most " + numberText(bound)};
    }
    return std::nullopt;
}

std::optional<StressFault> logFault(const CountedHit& counted, const Hit& logged, const StepLog& log) {
    if (!sameHit(counted.hit, logged)) {
        return StressFault{"sinks", "counted " + described(counted.hit) + ", logged " + described(logged)};
    }
    if (log.steps.size() != counted.steps || log.reads.back() != counted.reads) {
        return StressFault{"sinks", std::to_string(counted.steps) + " steps and " + std::to_string(counted.reads) +
                                        " reads counted, " + std::to_string(log.steps.size()) + " and " +
                                        std::to_string(log.reads.back()) + " logged"};
    }
    for (std::size_t n = 0; n < log.steps.size(); ++n) {
        const Step& step = log.steps[n];
        if (std::isfinite(step.lambdaIn) && std::isfinite(step.lambdaOut) && std::isfinite(step.value) &&
            std::isfinite(step.lambdaAfter)) {
            continue;
        }
        return StressFault{"log", "step " + std::to_string(n + 1) + ": from " + numberText(step.lambdaIn) + " to " +
                                      numberText(step.lambdaOut) + ", value " + numberText(step.value) + ", on to " +
                                      numberText(step.lambdaAfter)};
    }
    if (log.steps.empty() || endOf(log.steps.back().decision) != logged.outcome) {
        return StressFault{"log", "does not end with " + described(logged)};
    }
    return std::nullopt;
}

}  // namespace relief
