#include "scenario/comparison.h"

#include <algorithm>
#include <array>

#include "relief/tracers.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 4> kModes{"tiles", "swipe", "flicker", "difference"};
constexpr std::array<std::string_view, 2> kMeasures{"l1", "flip"};
constexpr std::array<std::string_view, 2> kReferences{"exact", "A"};

template <class Value, std::size_t N>
Value parsed(const std::array<std::string_view, N>& names, std::string_view text, MessageId what) {
    std::string known;
    for (std::size_t i = 0; i < N; ++i) {
        if (names[i] == text) return static_cast<Value>(i);
        known.append(known.empty() ? "" : ", ").append(names[i]);
    }
    throw InputError("compare",
                     Message(MessageId::UnknownName, {{"what", what}, {"name", std::string(text)}, {"known", known}}));
}

[[noreturn]] void outOfRange(const std::string& subject, MessageId what, double value, Message range) {
    throw InputError(subject,
                     Message(MessageId::OutOfRange, {{"what", what}, {"value", value}, {"range", std::move(range)}}));
}

}  // namespace

std::string_view compareModeName(CompareMode mode) {
    return kModes[static_cast<std::size_t>(mode)];
}
CompareMode parseCompareMode(std::string_view text) {
    return parsed<CompareMode>(kModes, text, MessageId::WordCompareMode);
}
std::string_view compareMeasureName(CompareMeasure measure) {
    return kMeasures[static_cast<std::size_t>(measure)];
}
CompareMeasure parseCompareMeasure(std::string_view text) {
    return parsed<CompareMeasure>(kMeasures, text, MessageId::WordDifference);
}
std::string_view compareReferenceName(CompareReference reference) {
    return kReferences[static_cast<std::size_t>(reference)];
}
CompareReference parseCompareReference(std::string_view text) {
    return parsed<CompareReference>(kReferences, text, MessageId::WordReference);
}

void checkComparison(const Comparison& comparison, const std::string& subject) {
    if (comparison.others.size() + 1 > kMostCompared) {
        outOfRange(subject, MessageId::WordComparedMethods, static_cast<double>(comparison.others.size() + 1),
                   Message(MessageId::RangeAtMost, {{"high", kMostCompared}}));
    }
    for (const MethodChoice& method : comparison.others) checkMethod(method, subject);
    if (comparison.dividers.size() + 1 > kMostCompared) {
        outOfRange(subject, MessageId::WordDividers, static_cast<double>(comparison.dividers.size()),
                   Message(MessageId::RangeAtMost, {{"high", kMostCompared - 1}}));
    }
    double before = 0;
    for (const double divider : comparison.dividers) {
        if (!(divider >= before && divider <= 1))
            outOfRange(subject, MessageId::WordDivider, divider, Message(MessageId::RangeAscending));
        before = divider;
    }
    if (!(comparison.rate >= kSlowestFlicker && comparison.rate <= kFastestFlicker)) {
        outOfRange(subject, MessageId::WordRate, comparison.rate, rangeOf(kSlowestFlicker, kFastestFlicker));
    }
}

std::vector<double> dividersOf(const Comparison& comparison) {
    const std::size_t count = comparison.others.size();
    if (comparison.dividers.size() == count) return comparison.dividers;
    std::vector<double> even;
    for (std::size_t i = 1; i <= count; ++i) even.push_back(static_cast<double>(i) / static_cast<double>(count + 1));
    return even;
}

}  // namespace relief
