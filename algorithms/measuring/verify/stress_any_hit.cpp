#include <algorithm>
#include <array>
#include <cmath>

#include "measuring/verify/stress_part_checks.h"
#include "measuring/verify/stress_parts.h"
#include "relief/cell_grid.h"

namespace relief {

namespace {

// Rounding error of lambda when it is computed back from a segment's height.
constexpr double kLambdaRounding = 1e-9;
// Number of samples along a ray behind its hit.
constexpr int kSamples = 16;
// Positions have this error, texels, up to kSurePlace texels from the origin.
constexpr double kPlaceError = 1e-6;
constexpr double kSurePlace = 1e8;

// Returns true if all positions within kPlaceError of (s, t) are on the same piece of the surface.
bool surePlace(const HeightField& field, double s, double t) {
    if (std::abs(s) > kSurePlace || std::abs(t) > kSurePlace) return false;
    const auto inside = [](double x, int size) { return x > kPlaceError && x < size - kPlaceError; };
    if (field.address() == Address::Border && !(inside(s, field.width()) && inside(t, field.height()))) return false;
    const auto whole = [](double x) { return std::floor(x - kPlaceError) == std::floor(x + kPlaceError); };
    return field.surface() == Surface::Bilinear || (whole(s) && whole(t));
}

// Returns the lambda of a sampled position at which the surface is certainly above the ray.
std::optional<double> risesAbove(const HeightField& field, const ViewRay& ray, double from) {
    for (int n = 1; n <= kSamples; ++n) {
        const double lambda = from + (1 - from) * n / kSamples;
        const Hit place = Hit::at(ray, lambda);
        if (!surePlace(field, place.s, place.t)) continue;
        if (field.at(place.s, place.t) - (1 - lambda) > kSureHeight) return lambda;
    }
    return std::nullopt;
}

// Returns true for rays that may pass below the surface through the border's side: this is no hit, but it blocks a
// query.
bool startsOutside(const HeightField& field, const ViewRay& ray) {
    return field.address() == Address::Border &&
           !(ray.s0 >= 0 && ray.s0 <= field.width() && ray.t0 >= 0 && ray.t0 <= field.height());
}

std::string rayNumbers(const ViewRay& ray) {
    return "ray " + numberText(ray.s0) + "," + numberText(ray.t0) + "," + numberText(ray.a) + "," + numberText(ray.b);
}

}  // namespace

AnyRay wholeSegment(const ViewRay& ray) {
    return {ray.s0, ray.t0, 1, ray.a, ray.b, -1};
}

std::optional<StressFault> anyHitFault(const AnyHitQuery& query, const ViewRay& ray, const CountedVisibility& answer,
                                       const Hit& reference) {
    const double bound = query.stepBound(wholeSegment(ray));
    if (!(answer.steps <= bound)) {
        return StressFault{"steps", std::to_string(answer.steps) + " steps, but at most " + numberText(bound) + "; " +
                                        rayNumbers(ray)};
    }
    const bool inDomain = GridRay(CellGrid(query.field()), ray).inDomain();
    if (!inDomain || reference.outcome == Outcome::Limit) return std::nullopt;
    if (answer.visibility == Visibility::Limit) return StressFault{"limit", rayNumbers(ray)};
    const bool hit = reference.outcome == Outcome::Hit;
    if (answer.visibility == Visibility::Blocked) {
        if (!hit && startsOutside(query.field(), ray)) return std::nullopt;
        if (!hit) return StressFault{"any-hit", "blocked, but exact misses; " + rayNumbers(ray)};
        if (answer.log.steps.empty() || answer.log.steps.back().lambdaOut >= reference.lambda - kLambdaRounding) {
            return std::nullopt;
        }
        return StressFault{"any-hit", "blocked before lambda " + numberText(answer.log.steps.back().lambdaOut) +
                                          ", exact: first at " + numberText(reference.lambda) + "; " + rayNumbers(ray)};
    }
    if (!hit) return std::nullopt;
    if (const auto lambda = risesAbove(query.field(), ray, reference.lambda)) {
        return StressFault{"any-hit", "clear, but the surface is above the ray at lambda " + numberText(*lambda) +
                                          "; " + rayNumbers(ray)};
    }
    return std::nullopt;
}

namespace stress_detail {

namespace {

// Steps of one query over one ray family in a case after which the family ends early; one segment at least is tested.
// Every segment is also logged.
constexpr std::uint64_t kStepsPerFamily = 50'000;

class QueryTurn {
  public:
    QueryTurn(const CaseRun& run, const AnyHitQuery& query)
        : run_(run), query_(query), choice_{query.description().name, {}}, coverage_(run.result.methods[choice_.name]) {
        coverage_.forms.insert("");
    }

    void over(const FamilyRays& familyRays) {
        std::uint64_t steps = 0;
        for (std::size_t r = 0; r < familyRays.rays.size() && steps < kStepsPerFamily; ++r) {
            steps += one(familyRays.family, familyRays.rays[r], familyRays.truth[r]);
            ++coverage_.rays[std::string(familyRays.family)];
        }
    }

  private:
    // Tests one ray; returns the number of steps.
    std::uint64_t one(std::string_view family, const ViewRay& ray, const Hit& truth) {
        CountedVisibility answer;
        const VisibilityBlock plain = queried<NullSink>(family, ray);
        BlockCounts counts;
        const VisibilityBlock counted = queried(family, ray, counts);
        answer.visibility = counted.visibility[0];
        answer.steps = counted.steps[0];
        // A longer log would take too much memory.
        if (answer.steps <= kStepsPerFamily) {
            queried(family, ray, answer.log);
            ++coverage_.logs;
        }
        const auto report = [&](const StressFault& fault) {
            run_.result.report({fault, StressPart::AnyHit, choice_, family, ray, nullptr});
        };
        if (plain.visibility[0] != answer.visibility)
            report({"sinks", "the answer changes when reads are counted; " + rayNumbers(ray)});
        if (const auto fault = anyHitFault(query_, ray, answer, truth)) report(*fault);
        const double share = answer.steps / query_.stepBound(wholeSegment(ray));
        if (share > coverage_.worstBound) {
            coverage_.worstBound = share;
            coverage_.worstWhere = std::string(family) + " over " + run_.of.map;
        }
        return answer.steps;
    }

    template <class Sink>
    VisibilityBlock queried(std::string_view family, const ViewRay& ray) {
        Sink sink;
        return queried(family, ray, sink);
    }
    template <class Sink>
    VisibilityBlock queried(std::string_view family, const ViewRay& ray, Sink& sink) {
        AnyRayBlock rays;
        rays.push(wholeSegment(ray));
        VisibilityBlock results;
        run_.watched.begin({&run_.of, StressPart::AnyHit, &choice_, family, ray});
        query_.query(rays, results, sink, run_.work);
        run_.watched.end();
        return results;
    }

    const CaseRun& run_;
    const AnyHitQuery& query_;
    MethodChoice choice_;
    StressMethodCoverage& coverage_;
};

}  // namespace

void stressAnyHit(const CaseRun& run, const std::vector<FamilyRays>& familyRays) {
    const HeightField& field = run.of.field;
    for (const MethodDescription& method : anyHitList()) {
        // Other maps take too long to build over large pictures; pyramids and packed cones do not.
        const std::string& map = method.maps.front();
        if (map != "max-pyramid" && map != "packed-cones" && field.heights().size() > kStressBuildTexels) continue;
        const auto query = run.subjects.query({method.name, {}}, field, *run.maps, run.work);
        QueryTurn turn(run, *query);
        for (const FamilyRays& family : familyRays) {
            run.work.throwIfStopped();
            turn.over(family);
        }
    }
}

}  // namespace stress_detail

}  // namespace relief
