#include "scenario/step_sentence.h"

#include <array>
#include <charconv>
#include <cmath>

namespace relief {

namespace {

constexpr int kFewestDecimals = 2;
constexpr int kMostDecimals = 6;
constexpr int kHeightDecimals = 3;
constexpr int kTexelDecimals = 2;

// Level, texel, the value read and the heights of the ray: what sentences about a texel draw from.
Message aboutTexel(MessageId id, const Step& step) {
    const int decimals = tellingDecimals(step.value, step.zOut());
    return Message(id, {{"level", step.level},
                        {"i", step.i},
                        {"j", step.j},
                        {"value", fixedText(step.value, decimals)},
                        {"in", fixedText(step.zIn(), decimals)},
                        {"out", fixedText(step.zOut(), decimals)},
                        {"after", fixedText(1 - step.lambdaAfter, decimals)}});
}

Message startSentence(const Step& step, const StepContext& context) {
    if (context.hierarchy) {
        return Message(MessageId::StepStartHighest, {{"value", fixedText(step.value, kHeightDecimals)}});
    }
    return Message(MessageId::StepStart, {{"i", step.i}, {"j", step.j}});
}

Message advanceSentence(const Step& step) {
    const auto height = fixedText(1 - step.lambdaAfter, kHeightDecimals);
    if (step.phase == Phase::Start) {
        return Message(MessageId::StepAdvanceHighest,
                       {{"value", fixedText(step.value, kHeightDecimals)}, {"after", height}});
    }
    return Message(MessageId::StepAdvance, {{"after", height}});
}

Message hitSentence(const Step& step, const StepContext& context) {
    const auto height = fixedText(1 - step.lambdaAfter, kHeightDecimals);
    const bool atOnce = context.hierarchy && context.before &&
                        (*context.before == Decision::Start || *context.before == Decision::Advance);
    if (atOnce) {
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

Message missSentence(const Step& step) {
    if (step.lambdaOut <= 0) return Message(MessageId::StepMissOutside);
    return Message(MessageId::StepMiss, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
}

}  // namespace

std::string fixedText(double value, int decimals) {
    // Long enough for any double of the domain; what is larger is written as it is.
    std::array<char, 64> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    if (result.ec != std::errc()) return numberText(value, kMostDecimals);
    std::string text(buffer.data(), result.ptr);
    // -0.00 would make people wonder.
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

int tellingDecimals(double a, double b) {
    if (a == b || !std::isfinite(a) || !std::isfinite(b)) return kFewestDecimals;
    int decimals = kFewestDecimals;
    while (decimals < kMostDecimals && fixedText(a, decimals) == fixedText(b, decimals)) ++decimals;
    return decimals;
}

Message stepSentence(const Step& step, const StepContext& context) {
    switch (step.decision) {
        case Decision::Start:
            return startSentence(step, context);
        case Decision::Skip:
            return aboutTexel(MessageId::StepSkip, step);
        case Decision::Descend:
            return aboutTexel(MessageId::StepDescend, step);
        case Decision::Ascend:
            return aboutTexel(MessageId::StepAscend, step);
        case Decision::Advance:
            return advanceSentence(step);
        case Decision::Test:
            return aboutTexel(MessageId::StepTest, step);
        case Decision::Refine:
            return aboutTexel(MessageId::StepRefine, step);
        case Decision::Hit:
            return hitSentence(step, context);
        case Decision::Miss:
            return missSentence(step);
        case Decision::Limit:
            return Message(MessageId::StepLimit, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
    }
    return Message(MessageId::StepLimit, {{"out", fixedText(step.zOut(), kHeightDecimals)}});
}

}  // namespace relief
