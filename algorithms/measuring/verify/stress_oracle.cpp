#include "measuring/compare/rational_hit.h"
#include "measuring/verify/stress_parts.h"

namespace relief::stress_detail {

namespace {

std::string answerText(bool hit, double lambda) {
    return hit ? "lambda " + numberText(lambda) : "a miss";
}

}  // namespace

void stressOracle(const CaseRun& run, const std::vector<FamilyRays>& familyRays) {
    const HeightField& field = run.of.field;
    StressPartCoverage& decided = run.result.parts["oracle"];
    StressPartCoverage& within = run.result.parts["oracle, within rounding"];
    const MethodChoice exact{"exact", {}};
    for (const FamilyRays& family : familyRays) {
        run.work.throwIfStopped();
        const std::string name(family.family);
        for (std::size_t r = 0; r < family.rays.size(); ++r) {
            const ViewRay& ray = family.rays[r];
            const auto truth = rationalHit(field, ray);
            if (!truth) {
                ++decided.refused;
                continue;
            }
            ++decided.tried[name];
            const Hit& answer = family.truth[r];
            const RationalVerdict verdict = judgeHit(field, ray, answer, *truth);
            if (verdict == RationalVerdict::Rounding) ++within.tried[name];
            if (verdict != RationalVerdict::Wrong) continue;
            const std::string detail = answerText(answer.outcome == Outcome::Hit, answer.lambda) + ", in rationals " +
                                       answerText(truth->hit, truth->lambda) + ", clearance " +
                                       numberText(truth->clearance);
            run.result.report({{"oracle", detail}, StressPart::Tracers, exact, family.family, ray, nullptr});
        }
    }
    if (within.tried.empty()) run.result.parts.erase("oracle, within rounding");
}

}  // namespace relief::stress_detail
