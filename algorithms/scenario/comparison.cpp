#include "scenario/comparison.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scenario/variation.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 4> kSubjects{"methods", "filters", "mappings", "heights"};
constexpr std::array<MessageId, 4> kCompared{MessageId::WordComparedMethods, MessageId::WordComparedFilters,
                                             MessageId::WordComparedMappings, MessageId::WordComparedHeights};
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
    throw InputError("compare", unknownName({"what", what}, std::string(text), known));
}

[[noreturn]] void outOfRange(const std::string& subject, MessageId what, double value, Message range) {
    throw InputError(subject,
                     Message(MessageId::OutOfRange, {{"what", what}, {"value", value}, {"range", std::move(range)}}));
}

}  // namespace

const std::vector<MethodChoice>& othersOf(const Comparison& comparison) {
    switch (comparison.subject) {
        case CompareSubject::Filters:
            return comparison.filters;
        case CompareSubject::Mappings:
            return comparison.mappings;
        case CompareSubject::Heights:
            return comparison.heights;
        case CompareSubject::Methods:
            break;
    }
    return comparison.others;
}
std::vector<MethodChoice>& othersOf(Comparison& comparison) {
    return const_cast<std::vector<MethodChoice>&>(othersOf(std::as_const(comparison)));
}

std::string_view compareSubjectName(CompareSubject subject) {
    return kSubjects[static_cast<std::size_t>(subject)];
}
CompareSubject parseCompareSubject(std::string_view text) {
    return parsed<CompareSubject>(kSubjects, text, MessageId::WordCompareSubject);
}
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
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
        Comparison part = comparison;
        part.subject = static_cast<CompareSubject>(s);
        const std::vector<MethodChoice>& others = othersOf(part);
        if (others.size() + 1 > kMostCompared) {
            outOfRange(subject, kCompared[s], static_cast<double>(others.size() + 1),
                       Message(MessageId::RangeAtMost, {{"high", kMostCompared}}));
        }
        for (const MethodChoice& one : others) checkVariation(part.subject, one, subject);
    }
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
    const std::size_t count = othersOf(comparison).size();
    if (comparison.dividers.size() == count) return comparison.dividers;
    std::vector<double> even;
    for (std::size_t i = 1; i <= count; ++i) even.push_back(static_cast<double>(i) / static_cast<double>(count + 1));
    return even;
}

}  // namespace relief
