#include "scenario/step_sentence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "relief/leaf.h"

namespace relief {

namespace {

constexpr int kFewestDecimals = 2;
constexpr int kMostDecimals = 6;
constexpr int kHeightDecimals = 3;
constexpr int kTexelDecimals = 2;

// A message with the level, the texel, the stored value and the heights of the ray.
Message aboutTexel(MessageId id, const Step& step) {
    const int decimals = distinguishingDecimals(step.value, step.zOut());
    return Message(id, {{"level", step.level},
                        {"i", step.i},
                        {"j", step.j},
                        {"value", fixedText(step.value, decimals)},
                        {"in", fixedText(step.zIn(), decimals)},
                        {"out", fixedText(step.zOut(), decimals)},
                        {"after", fixedText(1 - step.lambdaAfter, decimals)}});
}

// A message with the surface's height at one point: layer, heights of ray and surface, position of the answer.
Message aboutPoint(MessageId id, const Step& step, const StepContext& context) {
    const int decimals = std::max(distinguishingDecimals(step.value, step.zOut()), kHeightDecimals);
    const auto height = [&](double z) { return fixedText(z, decimals); };
    const auto* const layer = step.as<subject::Layer>();
    const Hit hit = context.ray ? Hit::at(*context.ray, step.lambdaAfter) : Hit();
    return Message(id, {{"layer", layer != nullptr ? layer->n : 0},
                        {"layers", layer != nullptr ? layer->count : 0},
                        {"value", height(step.value)},
                        {"in", height(step.zIn())},
                        {"out", height(step.zOut())},
                        {"after", height(1 - step.lambdaAfter)},
                        {"s", fixedText(hit.s, kTexelDecimals)},
                        {"t", fixedText(hit.t, kTexelDecimals)}});
}

// Returns true for the top texel of a pyramid of more than one level.
bool ofTop(const Step& step) {
    const auto* const texel = step.as<subject::Texel>();
    return texel != nullptr && texel->level > 0;
}

Message startSentence(const Step& step) {
    if (step.lambdaIn > 0) {
        return Message(MessageId::StepStartInside, {{"in", fixedText(step.zIn(), kHeightDecimals)}});
    }
    if (ofTop(step)) {
        return Message(MessageId::StepStartHighest, {{"value", fixedText(step.value, kHeightDecimals)}});
    }
    return Message(step.namesTexelUnderRay() ? MessageId::StepStart : MessageId::StepStartCell,
                   {{"i", step.i}, {"j", step.j}});
}

// Returns the lambda from which a map's claim counts: for a voxel's distance and a cell's cone, where the ray leaves
// the cell; otherwise the ray's current position.
double claimStart(const Step& step) {
    const auto* const cone = step.as<subject::Cone>();
    const bool ofCell = cone != nullptr ? cone->ofCell : step.as<subject::Voxel>() != nullptr;
    return ofCell ? step.lambdaOut : step.lambdaIn;
}

Message claimSentence(const Step& step, const StepContext& context, std::string value, MessageId kept,
                      MessageId broken) {
    const auto height = [](double lambda) { return fixedText(1 - lambda, kHeightDecimals); };
    std::vector<MessageValue> values{
        {"at", height(claimStart(step))}, {"value", std::move(value)}, {"after", height(step.lambdaAfter)}};
    if (context.exact) values.emplace_back("met", height(context.exact->lambda));
    const MapPromise claim = mapPromise(step, context);
    const MessageId id = claim == MapPromise::Behind   ? MessageId::StepClaimBehind
                         : claim == MapPromise::Broken ? broken
                                                       : kept;
    return Message(id, std::move(values));
}

Message advanceSentence(const Step& step, const StepContext& context) {
    const auto height = [](double z) { return fixedText(z, kHeightDecimals); };
    if (const auto* const cone = step.as<subject::Cone>()) {
        if (cone->relaxed) {
            const MessageId relaxed = MessageId::StepRelaxedCone;
            return claimSentence(step, context, height(cone->slope), relaxed, relaxed);
        }
        const auto [kept, broken] = cone->square ? std::pair(MessageId::StepSquareCone, MessageId::StepSquareConeBroken)
                                                 : std::pair(MessageId::StepCone, MessageId::StepConeBroken);
        return claimSentence(step, context, height(cone->slope), kept, broken);
    }
    const auto* const sphere = step.as<subject::Sphere>();
    const auto* const voxel = step.as<subject::Voxel>();
    if (sphere != nullptr || voxel != nullptr) {
        const std::string free = fixedText(voxel != nullptr ? voxel->distance : sphere->radius, kTexelDecimals);
        const bool refined = voxel != nullptr ? voxel->refined : sphere->refined;
        const auto [kept, broken] = refined ? std::pair(MessageId::StepRefined, MessageId::StepRefinedBroken)
                                            : std::pair(MessageId::StepSphere, MessageId::StepSphereBroken);
        return claimSentence(step, context, free, kept, broken);
    }
    if (step.as<subject::Layer>() != nullptr) return aboutPoint(MessageId::StepLayerAbove, step, context);
    if (step.as<subject::Point>() != nullptr) return aboutPoint(MessageId::StepPointAbove, step, context);
    if (step.phase == Phase::Start) {
        return Message(MessageId::StepAdvanceHighest,
                       {{"value", height(step.value)}, {"after", height(1 - step.lambdaAfter)}});
    }
    return Message(MessageId::StepAdvance, {{"after", height(1 - step.lambdaAfter)}});
}

Message testSentence(const Step& step) {
    if (step.as<subject::Voxel>() != nullptr) return aboutTexel(MessageId::StepTestVoxel, step);
    if (step.as<subject::Cone>() != nullptr) return aboutTexel(MessageId::StepTestApex, step);
    if (const auto* const quad = step.as<subject::Quad>()) {
        const auto texels = [](double x) { return fixedText(x, kTexelDecimals); };
        const int decimals = distinguishingDecimals(quad->maximum, step.zOut());
        return Message(MessageId::StepTestQuad, {{"s0", texels(quad->s)},
                                                 {"s1", texels(quad->s + quad->width)},
                                                 {"t0", texels(quad->t)},
                                                 {"t1", texels(quad->t + quad->height)},
                                                 {"value", fixedText(quad->maximum, decimals)},
                                                 {"out", fixedText(step.zOut(), decimals)}});
    }
    return aboutTexel(MessageId::StepTest, step);
}

// The answer of a linear interpolation lies within the interval; that of a bisection is one of its ends.
Message refineSentence(const Step& step, const StepContext& context) {
    if (!step.atPoint()) return aboutTexel(MessageId::StepRefine, step);
    if (step.lambdaAfter == step.lambdaIn) return aboutPoint(MessageId::StepHalvedAbove, step, context);
    const bool belowEnd = step.lambdaAfter == step.lambdaOut;
    // Linear interpolation, too, gives the interval's end if the surface is met exactly there.
    const bool met = step.value == step.zOut();
    return aboutPoint(belowEnd && !met ? MessageId::StepHalvedBelow : MessageId::StepSecant, step, context);
}

Message pointHitSentence(const Step& step, const StepContext& context) {
    if (step.as<subject::Layer>() != nullptr) return aboutPoint(MessageId::StepLayerHit, step, context);
    if (answersFromEntry(step, context.before)) return aboutPoint(MessageId::StepOffsetHit, step, context);
    // A search that reached its step limit answers with its current position.
    const bool above = step.value < step.zOut();
    return aboutPoint(above ? MessageId::StepPointGivenUp : MessageId::StepPointHit, step, context);
}

Message hitSentence(const Step& step, const StepContext& context) {
    if (step.atPoint()) return pointHitSentence(step, context);
    const auto height = fixedText(1 - step.lambdaAfter, kHeightDecimals);
    // True if the hit directly follows the start of a pyramid traversal and is as high as the highest point.
    const Step* const before = context.before;
    const bool atOnce = before != nullptr && before->phase == Phase::Start && ofTop(*before);
    if (atOnce && 1 - step.lambdaAfter >= before->value - kExclusionMargin) {
        return Message(MessageId::StepHitAtOnce, {{"i", step.i}, {"j", step.j}, {"after", height}});
    }
    if (!context.ray) {
        return Message(MessageId::StepHit, {{"level", step.level}, {"i", step.i}, {"j", step.j}, {"after", height}});
    }
    const Hit hit = Hit::at(*context.ray, step.lambdaAfter);
    return Message(MessageId::StepHitAt, {{"level", step.level},
                                          {"i", step.i},
                                          {"j", step.j},
                                          {"after", height},
                                          {"s", fixedText(hit.s, kTexelDecimals)},
                                          {"t", fixedText(hit.t, kTexelDecimals)}});
}

// Returns the sentence with the ray's coordinates and their doubles on the level below. The doubled numbers have one
// decimal less, so that both agree as printed.
Message descendSentence(const Step& step) {
    const auto* const texel = step.as<subject::Texel>();
    if (texel == nullptr || !texel->ray) return aboutTexel(MessageId::StepDescend, step);
    Message message = aboutTexel(MessageId::StepDescendDoubled, step);
    message.values.emplace_back("x", fixedText(texel->ray->x, kTexelDecimals + 1));
    message.values.emplace_back("y", fixedText(texel->ray->y, kTexelDecimals + 1));
    message.values.emplace_back("doubleX", fixedText(2 * texel->ray->x, kTexelDecimals));
    message.values.emplace_back("doubleY", fixedText(2 * texel->ray->y, kTexelDecimals));
    return message;
}

// Gives the paper's reason for the ascent, unless the exact hit contradicts it.
Message ascendSentence(const Step& step, const StepContext& context) {
    Message message = aboutTexel(MessageId::StepAscend, step);
    if (!context.exact || context.exact->outcome != Outcome::Hit) return message;
    const double scale = context.ray ? std::max(1.0, std::hypot(context.ray->a, context.ray->b)) : 1;
    if (context.exact->lambda + kSameAnswer / scale >= step.lambdaOut) return message;
    message.id = MessageId::StepAscendBroken;
    message.values.emplace_back("met", fixedText(1 - context.exact->lambda, kHeightDecimals));
    return message;
}

Message missSentence(const Step& step) {
    if (step.lambdaOut <= 0) return Message(MessageId::StepMissOutside);
    return Message(MessageId::StepMiss, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
}

}  // namespace

std::string fixedText(double value, int decimals) {
    // Sufficient for any double of the domain; larger numbers are written with an exponent.
    std::array<char, 64> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    if (result.ec != std::errc()) return numberText(value, kMostDecimals);
    std::string text(buffer.data(), result.ptr);
    // Negative zero is written without its sign.
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

int distinguishingDecimals(double a, double b) {
    if (a == b || !std::isfinite(a) || !std::isfinite(b)) return kFewestDecimals;
    int decimals = kFewestDecimals;
    while (decimals < kMostDecimals && fixedText(a, decimals) == fixedText(b, decimals)) ++decimals;
    return decimals;
}

Message decisionTitle(Decision decision) {
    constexpr std::array kTitles{MessageId::DecisionStart,  MessageId::DecisionSkip,    MessageId::DecisionDescend,
                                 MessageId::DecisionAscend, MessageId::DecisionAdvance, MessageId::DecisionTest,
                                 MessageId::DecisionRefine, MessageId::DecisionHit,     MessageId::DecisionMiss,
                                 MessageId::DecisionLimit};
    static_assert(kTitles.size() == kDecisionNames.size());
    return Message(kTitles[static_cast<std::size_t>(decision)]);
}

MapPromise mapPromise(const Step& step, const StepContext& context) {
    if (!step.trustsMap()) return MapPromise::None;
    if (!context.exact || context.exact->outcome != Outcome::Hit) return MapPromise::Kept;
    const double scale = context.ray ? std::max(1.0, std::hypot(context.ray->a, context.ray->b)) : 1;
    const double met = context.exact->lambda + kSameAnswer / scale;
    if (claimStart(step) > met) return MapPromise::Behind;
    const auto* const cone = step.as<subject::Cone>();
    if (cone != nullptr && cone->relaxed) return MapPromise::None;
    return step.lambdaAfter > met ? MapPromise::Broken : MapPromise::Kept;
}

bool answersFromEntry(const Step& step, const Step* before) {
    return step.decision == Decision::Hit && step.as<subject::Point>() != nullptr && step.lambdaIn == 0 &&
           before != nullptr && before->decision == Decision::Start;
}

Message stepSentence(const Step& step, const StepContext& context) {
    switch (step.decision) {
        case Decision::Start:
            return startSentence(step);
        case Decision::Skip:
            return aboutTexel(MessageId::StepSkip, step);
        case Decision::Descend:
            return descendSentence(step);
        case Decision::Ascend:
            return ascendSentence(step, context);
        case Decision::Advance:
            return advanceSentence(step, context);
        case Decision::Test:
            return testSentence(step);
        case Decision::Refine:
            return refineSentence(step, context);
        case Decision::Hit:
            return hitSentence(step, context);
        case Decision::Miss:
            return missSentence(step);
        case Decision::Limit:
            return Message(MessageId::StepLimit, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
    }
    return Message(MessageId::StepLimit, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
}

Message stepSentence(const std::vector<Step>& steps, std::size_t index, const ViewRay& ray,
                     const std::optional<Hit>& exact) {
    const Step& step = steps[index];
    const Step* const before = index > 0 ? &steps[index - 1] : nullptr;
    Message said = stepSentence(step, {before, ray, exact});
    // A refinement may go back and forth over an edge.
    const bool same = before == nullptr || step.phase == Phase::Refine || before->phase == Phase::Refine ||
                      (before->periodX == step.periodX && before->periodY == step.periodY);
    return same ? said : Message(MessageId::StepOverEdge, {{"step", std::move(said)}});
}

double answerError(const Hit& answer, const Hit& exact, const ViewRay& ray) {
    if (exact.outcome == Outcome::Limit || exact.outcome == Outcome::Unset) return 0;
    if (answer.outcome != exact.outcome) return std::numeric_limits<double>::infinity();
    if (exact.outcome != Outcome::Hit) return 0;
    return std::abs(answer.lambda - exact.lambda) * std::max(1.0, std::hypot(ray.a, ray.b));
}

Message answerSentence(const Hit& answer, const Hit& exact, const ViewRay& ray) {
    constexpr int kDigits = 2;
    const double off = answerError(answer, exact, ray);
    const bool known = exact.outcome == Outcome::Hit || exact.outcome == Outcome::Miss;
    if (!known) return Message(MessageId::AnswerUnknown);
    if (exact.outcome == Outcome::Miss) {
        return Message(answer.outcome == Outcome::Miss ? MessageId::AnswerRightMiss : MessageId::AnswerWrongHit);
    }
    const std::vector<MessageValue> values{{"height", fixedText(1 - exact.lambda, kHeightDecimals)},
                                           {"s", fixedText(exact.s, kTexelDecimals)},
                                           {"t", fixedText(exact.t, kTexelDecimals)},
                                           {"texels", std::isfinite(off) ? numberText(off, kDigits) : std::string()}};
    if (off <= kSameAnswer) return Message(MessageId::AnswerExact, values);
    return Message(std::isfinite(off) ? MessageId::AnswerOff : MessageId::AnswerWrongMiss, values);
}

}  // namespace relief
