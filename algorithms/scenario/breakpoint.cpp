#include "scenario/breakpoint.h"

#include <algorithm>

#include "relief/errors.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Tests a breakpoint at the steps of a ray.
class Test {
  public:
    Test(const Breakpoint& breakpoint, const StoppedRay& ray)
        : breakpoint_(breakpoint), ray_(ray), columns_(ray.columns ? *ray.columns : StepColumns(*ray.steps)) {
        if (breakpoint.kind != StopKind::Condition) return;
        run([&] { condition_.emplace(breakpoint.condition); });
    }

    const std::optional<Message>& fault() const { return fault_; }

    // Returns true if the breakpoint is met at this step.
    bool met(std::size_t step) {
        if (breakpoint_.kind == StopKind::Condition) return condition(step);
        return holds(step) && (step == 0 || !holds(step - 1));
    }
    // Returns true if it stops there.
    bool stops(std::size_t step) {
        if (!met(step)) return false;
        if (!first_) findFirst();
        return step >= *first_;
    }

  private:
    // Returns true if the condition holds at a step, whether or not it held at the step before.
    bool holds(std::size_t step) const {
        const Step& at = (*ray_.steps)[step];
        switch (breakpoint_.kind) {
            case StopKind::LevelBelow:
                return at.level < breakpoint_.level;
            case StopKind::Texel:
                return at.level == breakpoint_.level && at.i == breakpoint_.i && at.j == breakpoint_.j;
            case StopKind::RayBelow:
                return 1 - at.lambdaAfter < breakpoint_.height;
            case StopKind::Overshoot:
                return ray_.overshoot && step >= *ray_.overshoot;
            case StopKind::Disagreement:
                return ray_.disagreement && step >= *ray_.disagreement;
            case StopKind::Condition:
                break;
        }
        return false;
    }
    void findFirst() {
        first_ = 0;
        for (int left = breakpoint_.ignore; left > 0 && *first_ < ray_.steps->size(); ++*first_) {
            if (met(*first_)) --left;
        }
    }
    bool condition(std::size_t step) {
        bool holds = false;
        if (condition_) run([&] { holds = condition_->holds(columns_.at(step)); });
        return holds;
    }
    template <class Body>
    void run(const Body& body) {
        try {
            body();
        } catch (const InputError& error) {
            fault_ = error.message();
            condition_.reset();
        }
    }

    const Breakpoint& breakpoint_;
    const StoppedRay& ray_;
    StepColumns columns_;
    std::optional<Expression> condition_;
    std::optional<Message> fault_;
    std::optional<std::size_t> first_;  // the first step that stops, once it is known
};

void checkCondition(const std::string& condition, const std::string& subject) {
    if (condition.size() > kLongestCondition) {
        throw InputError(subject, Message(MessageId::TooMany, {{"what", MessageId::WordConditionBytes},
                                                               {"count", condition.size()},
                                                               {"limit", kLongestCondition}}));
    }
    try {
        const Expression parsed(condition);
    } catch (const InputError& error) {
        throw InputError(subject,
                         Message(MessageId::StopConditionFault, {{"condition", condition}, {"why", error.message()}}));
    }
}

}  // namespace

StopKind parseStop(std::string_view text) {
    std::string known;
    for (std::size_t k = 0; k < kStopNames.size(); ++k) {
        if (kStopNames[k] == text) return static_cast<StopKind>(k);
        known += (known.empty() ? "" : ", ") + std::string(kStopNames[k]);
    }
    throw InputError("", unknownName({"what", MessageId::WordBreakpoint}, std::string(text), known));
}

BreakpointHits breakpointHits(const Breakpoint& breakpoint, const StoppedRay& ray) {
    Test test(breakpoint, ray);
    BreakpointHits hits;
    for (std::size_t k = 0; k < ray.steps->size(); ++k) {
        if (test.met(k)) hits.steps.push_back(k);
    }
    hits.ignored = std::min(hits.steps.size(), static_cast<std::size_t>(breakpoint.ignore));
    hits.fault = test.fault();
    return hits;
}

bool stopsAt(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step) {
    return Test(breakpoint, ray).stops(step);
}

std::optional<std::size_t> nextStop(const std::vector<Breakpoint>& breakpoints, const StoppedRay& ray, std::size_t from,
                                    bool forward) {
    std::vector<Test> tests;
    tests.reserve(breakpoints.size());
    for (const Breakpoint& breakpoint : breakpoints) {
        if (breakpoint.on) tests.emplace_back(breakpoint, ray);
    }
    const std::size_t count = ray.steps->size();
    for (std::size_t k = from; forward ? ++k < count : k-- > 0;) {
        if (k >= count) continue;
        if (std::any_of(tests.begin(), tests.end(), [&](Test& test) { return test.stops(k); })) return k;
    }
    return std::nullopt;
}

std::size_t stepOver(const std::vector<Step>& steps, std::size_t from, bool forward) {
    const std::size_t last = steps.empty() ? 0 : steps.size() - 1;
    std::size_t k = from;
    while (forward ? k < last : k > 0) {
        k = forward ? k + 1 : k - 1;
        if (steps[k].level >= steps[from].level) break;
    }
    return k;
}

Message breakpointTitle(const Breakpoint& breakpoint) {
    switch (breakpoint.kind) {
        case StopKind::LevelBelow:
            return Message(MessageId::StopLevelBelow, {{"level", breakpoint.level}});
        case StopKind::Texel:
            return Message(MessageId::StopTexel,
                           {{"i", breakpoint.i}, {"j", breakpoint.j}, {"level", breakpoint.level}});
        case StopKind::RayBelow:
            return Message(MessageId::StopRayBelow, {{"height", numberText(breakpoint.height)}});
        case StopKind::Overshoot:
            return Message(MessageId::StopOvershoot);
        case StopKind::Condition:
            return Message(MessageId::StopCondition, {{"condition", breakpoint.condition}});
        case StopKind::Disagreement:
            break;
    }
    return Message(MessageId::StopDisagreement);
}

void checkBreakpoint(const Breakpoint& breakpoint, const std::string& subject) {
    if (breakpoint.ignore < 0 || breakpoint.ignore > kMostIgnored) {
        throw InputError(
            subject, Message(MessageId::OutOfRange,
                             {{"what", "ignore"}, {"value", breakpoint.ignore}, {"range", rangeOf(0, kMostIgnored)}}));
    }
    if (breakpoint.kind == StopKind::Condition) checkCondition(breakpoint.condition, subject);
    if (breakpoint.level < 0 || breakpoint.level > kMostLevels) {
        throw InputError(subject, Message(MessageId::OutOfRange, {{"what", MessageId::WordLevel},
                                                                  {"value", breakpoint.level},
                                                                  {"range", rangeOf(0, kMostLevels)}}));
    }
    if (!(breakpoint.height >= 0 && breakpoint.height <= 1)) {
        throw InputError(subject, Message(MessageId::OutOfRange, {{"what", MessageId::WordRayBelow},
                                                                  {"value", breakpoint.height},
                                                                  {"range", rangeOf(0, 1)}}));
    }
}

}  // namespace relief
