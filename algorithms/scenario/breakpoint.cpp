#include "scenario/breakpoint.h"

#include "relief/errors.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Returns true if the condition holds at a step, whether or not it held at the step before.
bool holds(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step) {
    const Step& at = (*ray.steps)[step];
    switch (breakpoint.kind) {
        case StopKind::LevelBelow:
            return at.level < breakpoint.level;
        case StopKind::Texel:
            return at.level == breakpoint.level && at.i == breakpoint.i && at.j == breakpoint.j;
        case StopKind::RayBelow:
            return 1 - at.lambdaAfter < breakpoint.height;
        case StopKind::Overshoot:
            return ray.overshoot && step >= *ray.overshoot;
        case StopKind::Disagreement:
            return ray.disagreement && step >= *ray.disagreement;
    }
    return false;
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

bool stopsAt(const Breakpoint& breakpoint, const StoppedRay& ray, std::size_t step) {
    return holds(breakpoint, ray, step) && (step == 0 || !holds(breakpoint, ray, step - 1));
}

std::optional<std::size_t> nextStop(const std::vector<Breakpoint>& breakpoints, const StoppedRay& ray, std::size_t from,
                                    bool forward) {
    const std::size_t count = ray.steps->size();
    for (std::size_t k = from; forward ? ++k < count : k-- > 0;) {
        for (const Breakpoint& breakpoint : breakpoints) {
            if (breakpoint.on && k < count && stopsAt(breakpoint, ray, k)) return k;
        }
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
        case StopKind::Disagreement:
            break;
    }
    return Message(MessageId::StopDisagreement);
}

void checkBreakpoint(const Breakpoint& breakpoint, const std::string& subject) {
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
