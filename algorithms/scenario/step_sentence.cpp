#include "scenario/step_sentence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "relief/tracers.h"

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

// Of a look at one point of the surface: layer, heights of ray and surface, place of the answer.
Message aboutPoint(MessageId id, const Step& step, const StepContext& context) {
    const int decimals = std::max(tellingDecimals(step.value, step.zOut()), kHeightDecimals);
    const auto height = [&](double z) { return fixedText(z, decimals); };
    std::vector<MessageValue> values{{"layer", layerOf(step, context.layers)},
                                     {"layers", context.layers},
                                     {"value", height(step.value)},
                                     {"in", height(step.zIn())},
                                     {"out", height(step.zOut())},
                                     {"after", height(1 - step.lambdaAfter)}};
    const Hit hit = context.ray ? Hit::at(*context.ray, step.lambdaAfter) : Hit();
    values.emplace_back("s", fixedText(hit.s, kTexelDecimals));
    values.emplace_back("t", fixedText(hit.t, kTexelDecimals));
    return Message(id, std::move(values));
}

Message startSentence(const Step& step, const StepContext& context) {
    if (step.lambdaIn > 0) {
        return Message(MessageId::StepStartInside, {{"in", fixedText(step.zIn(), kHeightDecimals)}});
    }
    if (context.hierarchy && step.primitive == Primitive::Texel) {
        return Message(MessageId::StepStartHighest, {{"value", fixedText(step.value, kHeightDecimals)}});
    }
    return Message(MessageId::StepStart, {{"i", step.i}, {"j", step.j}});
}

Message advanceSentence(const Step& step, const StepContext& context) {
    if (step.primitive == Primitive::Point) {
        const bool layer = layerOf(step, context.layers) >= 0;
        return aboutPoint(layer ? MessageId::StepLayerAbove : MessageId::StepPointAbove, step, context);
    }
    const auto height = fixedText(1 - step.lambdaAfter, kHeightDecimals);
    if (step.phase == Phase::Start) {
        return Message(MessageId::StepAdvanceHighest,
                       {{"value", fixedText(step.value, kHeightDecimals)}, {"after", height}});
    }
    return Message(MessageId::StepAdvance, {{"after", height}});
}

// A straight line's answer lies within the stretch; a halving's is one of the ends that are left.
Message refineSentence(const Step& step, const StepContext& context) {
    if (step.primitive == Primitive::Texel) return aboutTexel(MessageId::StepRefine, step);
    if (step.lambdaAfter == step.lambdaIn) return aboutPoint(MessageId::StepHalvedAbove, step, context);
    const bool belowEnd = step.lambdaAfter == step.lambdaOut;
    // A line ends there too where the surface is met exactly on the layer.
    const bool met = step.value == step.zOut();
    return aboutPoint(belowEnd && !met ? MessageId::StepHalvedBelow : MessageId::StepSecant, step, context);
}

Message pointHitSentence(const Step& step, const StepContext& context) {
    if (context.before == Decision::Start && step.lambdaIn == 0) {
        return aboutPoint(MessageId::StepOffsetHit, step, context);
    }
    const bool layer = layerOf(step, context.layers) >= 0;
    return aboutPoint(layer ? MessageId::StepLayerHit : MessageId::StepPointHit, step, context);
}

Message hitSentence(const Step& step, const StepContext& context) {
    if (step.primitive == Primitive::Point) return pointHitSentence(step, context);
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

std::int64_t layerOf(const Step& step, int layers) {
    // A layer's lambda is n / N, rounded once.
    constexpr double kNear = 1e-9;
    if (layers < 1 || step.primitive != Primitive::Point) return -1;
    const double n = step.lambdaOut * layers;
    return std::abs(n - std::round(n)) <= kNear * layers ? static_cast<std::int64_t>(std::round(n)) : -1;
}

Message decisionTitle(Decision decision) {
    constexpr std::array kTitles{MessageId::DecisionStart,  MessageId::DecisionSkip,    MessageId::DecisionDescend,
                                 MessageId::DecisionAscend, MessageId::DecisionAdvance, MessageId::DecisionTest,
                                 MessageId::DecisionRefine, MessageId::DecisionHit,     MessageId::DecisionMiss,
                                 MessageId::DecisionLimit};
    static_assert(kTitles.size() == kDecisionNames.size());
    return Message(kTitles[static_cast<std::size_t>(decision)]);
}

namespace {

// The method, or the one inside it, that walks the maps.
const MethodDescription& innermost(const MethodChoice& method) {
    const MethodDescription* found = &findTracer(method.name);
    for (const ChoiceOption& option : choiceOptions(method)) {
        if (option.description.kind != OptionKind::Method) continue;
        const auto given = method.options.find(option.description.name);
        found = &findTracer(given == method.options.end() ? option.defaultValue : given->second);
    }
    return *found;
}

}  // namespace

StepContext stepContext(const MethodChoice& method, const ViewRay& ray, const std::vector<Step>& steps,
                        std::size_t index) {
    const MethodDescription& description = findTracer(method.name);
    StepContext context;
    context.hierarchy =
        std::find(description.maps.begin(), description.maps.end(), "max-pyramid") != description.maps.end();
    if (index > 0) context.before = steps[index - 1].decision;
    context.ray = ray;
    for (const std::string& map : innermost(method).maps) {
        context.slopes = context.slopes || map.find("cone") != std::string::npos;
        context.distances = context.distances || map.starts_with("euclidean") || map.starts_with("refined");
    }
    // Of the method itself, or of the one inside it.
    for (const ChoiceOption& option : choiceOptions(method)) {
        const std::string& name = option.description.name;
        if (name != "layers" && !name.ends_with(".layers")) continue;
        const auto given = method.options.find(name);
        const std::string& text = given == method.options.end() ? option.defaultValue : given->second;
        context.layers = static_cast<int>(parseNumber(text, name));
    }
    return context;
}

namespace {

// What a method that walks distances or cones says by its values; nothing where they are heights.
std::optional<Message> mapSentence(const Step& step, const StepContext& context) {
    if (!(context.distances || context.slopes) || step.level > 0 || step.phase != Phase::Search) return std::nullopt;
    constexpr int kSlopeDecimals = 3;
    if (step.decision == Decision::Advance) {
        // A walk goes on from where it leaves the voxel or cell, a march from where it is.
        const double at = step.primitive == Primitive::Point ? step.zIn() : step.zOut();
        return Message(context.slopes ? MessageId::StepCone : MessageId::StepSphere,
                       {{"at", fixedText(at, kHeightDecimals)},
                        {"value", fixedText(step.value, context.slopes ? kSlopeDecimals : kTexelDecimals)},
                        {"after", fixedText(1 - step.lambdaAfter, kHeightDecimals)}});
    }
    if (step.decision != Decision::Test) return std::nullopt;
    return aboutTexel(context.slopes ? MessageId::StepTestApex : MessageId::StepTestVoxel, step);
}

}  // namespace

Message stepSentence(const Step& step, const StepContext& context) {
    if (const auto special = mapSentence(step, context)) return *special;
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
            return advanceSentence(step, context);
        case Decision::Test:
            return aboutTexel(MessageId::StepTest, step);
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

}  // namespace relief
