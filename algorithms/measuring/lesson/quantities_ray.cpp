// Quantities of the pixel's ray, its steps, its coefficients and its footprint.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measuring/lesson/quantity_query.h"
#include "relief/step_log.h"
#include "scenario/ray_files.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 7> kDepartures{
    "none", "missed-spike", "stopped-early", "unsafe-map", "interpolation-leak", "not-refined", "taken-as-flat"};

const Step& chosenStep(const Query& query) {
    const auto& steps = query.ray().steps;
    if (steps.empty()) throw InputError(query.name.name, Message(MessageId::LessonNoStep));
    if (query.has(0)) return steps[static_cast<std::size_t>(query.whole(0, 1, asNumber(steps.size())) - 1)];
    return steps[std::min(static_cast<std::size_t>(std::max(query.scenario.step, 0)), steps.size() - 1)];
}

double countedSteps(const Query& query) {
    const std::string wanted = query.text(0);
    std::vector<std::string> known;
    for (const auto& name : kDecisionNames) known.emplace_back(name);
    for (const auto& name : kPhaseNames) known.emplace_back(name);
    for (const auto& name : kSubjectNames) known.emplace_back(name);
    if (std::find(known.begin(), known.end(), wanted) == known.end()) {
        query.fail(0, unknownName({"what", MessageId::WordName}, wanted, commaList(known)));
    }
    // "start" and "refine" are a decision and a phase; "hit" and the like one thing only.
    return asNumber(std::count_if(query.ray().steps.begin(), query.ray().steps.end(), [&](const Step& step) {
        return decisionName(step.decision) == wanted || phaseName(step.phase) == wanted ||
               subjectName(step.subject) == wanted;
    }));
}

double elevationOf(const Query& query) {
    const ViewRay& ray = query.ray().ray;
    return std::atan2(query.scene().field(query.work).slabTexels(), std::hypot(ray.a, ray.b)) * 180 / std::numbers::pi;
}

ExpressionValue pixelNumber(const Query& query) {
    const std::string name = query.name.name.substr(std::string_view("pixel.").size());
    std::string known;
    for (const NamedNumber& number : namedNumbers(query.scene().coefficients(query.work))) {
        if (number.name == name) return number.value;
        known += (known.empty() ? "" : ", ") + std::string(number.name);
    }
    throw InputError("", unknownName({"what", MessageId::WordQuantity}, name, known));
}

double visibleWeight(const Query& query) {
    double sum = 0;
    for (const FootprintTexel& texel : query.scene().footprint(query.work).log.texels) {
        if (!texel.hidden) sum += static_cast<double>(texel.weight.r + texel.weight.g + texel.weight.b) / 3;
    }
    return sum;
}

}  // namespace

std::vector<Quantity> rayQuantities() {
    return {
        RELIEF_QUANTITY("ray.s0", 0, 0, q.ray().ray.s0),
        RELIEF_QUANTITY("ray.t0", 0, 0, q.ray().ray.t0),
        RELIEF_QUANTITY("ray.a", 0, 0, q.ray().ray.a),
        RELIEF_QUANTITY("ray.b", 0, 0, q.ray().ray.b),
        RELIEF_QUANTITY("ray.run", 0, 0, std::hypot(q.ray().ray.a, q.ray().ray.b)),
        RELIEF_QUANTITY("ray.elevation", 0, 0, elevationOf(q)),
        RELIEF_QUANTITY("exact.outcome", 0, 0, std::string(outcomeName(q.ray().exact.outcome))),
        RELIEF_QUANTITY("exact.lambda", 0, 0, q.ray().exact.lambda),
        RELIEF_QUANTITY("exact.height", 0, 0, 1 - q.ray().exact.lambda),
        RELIEF_QUANTITY("exact.s", 0, 0, q.ray().exact.s),
        RELIEF_QUANTITY("exact.t", 0, 0, q.ray().exact.t),
        RELIEF_QUANTITY("trace.outcome", 0, 0, std::string(outcomeName(q.ray().hit.outcome))),
        RELIEF_QUANTITY("trace.lambda", 0, 0, q.ray().hit.lambda),
        RELIEF_QUANTITY("trace.height", 0, 0, 1 - q.ray().hit.lambda),
        RELIEF_QUANTITY("trace.s", 0, 0, q.ray().hit.s),
        RELIEF_QUANTITY("trace.t", 0, 0, q.ray().hit.t),
        RELIEF_QUANTITY("trace.error", 0, 0, q.ray().judgement.texels),
        RELIEF_QUANTITY("trace.steps", 0, 0, asNumber(q.ray().steps.size())),
        RELIEF_QUANTITY("trace.reads", 0, 0, asNumber(q.ray().reads)),
        RELIEF_QUANTITY("trace.count", 1, 1, countedSteps(q)),
        RELIEF_QUANTITY("trace.departure", 0, 0,
                        std::string(kDepartures[static_cast<std::size_t>(q.ray().judgement.kind)])),
        RELIEF_QUANTITY("trace.departure_step", 0, 0,
                        q.ray().judgement.kind == Departure::None ? 0.0 : asNumber(q.ray().judgement.step + 1)),
        RELIEF_QUANTITY("trace.overshoot_step", 0, 0,
                        q.ray().judgement.overshoot ? asNumber(*q.ray().judgement.overshoot + 1) : 0.0),
        RELIEF_QUANTITY("step.decision", 0, 1, std::string(decisionName(chosenStep(q).decision))),
        RELIEF_QUANTITY("step.kind", 0, 1, std::string(subjectName(chosenStep(q).subject))),
        RELIEF_QUANTITY("step.level", 0, 1, asNumber(chosenStep(q).level)),
        RELIEF_QUANTITY("step.i", 0, 1, asNumber(chosenStep(q).i)),
        RELIEF_QUANTITY("step.j", 0, 1, asNumber(chosenStep(q).j)),
        RELIEF_QUANTITY("step.k", 0, 1, asNumber(chosenStep(q).k)),
        RELIEF_QUANTITY("step.value", 0, 1, chosenStep(q).value),
        RELIEF_QUANTITY("step.lambda_in", 0, 1, chosenStep(q).lambdaIn),
        RELIEF_QUANTITY("step.lambda_out", 0, 1, chosenStep(q).lambdaOut),
        RELIEF_QUANTITY("step.lambda_after", 0, 1, chosenStep(q).lambdaAfter),
        RELIEF_QUANTITY("step.z_in", 0, 1, chosenStep(q).zIn()),
        RELIEF_QUANTITY("step.z_out", 0, 1, chosenStep(q).zOut()),
        RELIEF_QUANTITY("pixel.", 0, 0, pixelNumber(q)),
        RELIEF_QUANTITY("footprint.texels", 0, 0, asNumber(q.scene().footprint(q.work).counts.texels)),
        RELIEF_QUANTITY("footprint.tested", 0, 0, asNumber(q.scene().footprint(q.work).counts.tested)),
        RELIEF_QUANTITY("footprint.hidden", 0, 0, asNumber(q.scene().footprint(q.work).counts.hidden)),
        RELIEF_QUANTITY("footprint.skipped", 0, 0, asNumber(q.scene().footprint(q.work).counts.skipped)),
        RELIEF_QUANTITY("footprint.level", 0, 0, asNumber(q.scene().footprint(q.work).log.footprint.level)),
        RELIEF_QUANTITY("footprint.major", 0, 0, q.scene().footprint(q.work).major),
        RELIEF_QUANTITY("footprint.minor", 0, 0, q.scene().footprint(q.work).minor),
        RELIEF_QUANTITY("footprint.weight", 0, 0, visibleWeight(q)),
    };
}

}  // namespace relief
