#include "panes/step_colors.h"

#include <algorithm>
#include <set>

#include "painting/legend_rows.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::Phase;

// A role; for levels also the tint.
struct Tinted {
    Role role;
    LevelTint tint{};
};

Role roleOf(Phase phase) {
    switch (phase) {
        case Phase::Start:
            return Role::Start;
        case Phase::Search:
            return Role::Searched;
        case Phase::Refine:
            return Role::Refined;
    }
    return Role::Start;
}

Tinted tintedOf(const relief::Step& step, const StepPaint& paint) {
    switch (paint.by) {
        case StepColors::Decision:
            return {reliefui::roleOf(step.decision)};
        case StepColors::Level:
            return {Role::Plateau, {std::clamp(step.level, 0, paint.levels - 1), paint.levels}};
        case StepColors::Phase:
            return {roleOf(step.phase)};
    }
    return {Role::Start};
}

void addPhases(LegendRows& rows, const std::vector<relief::Step>& steps) {
    for (const auto& [phase, name] : {std::pair{Phase::Start, MessageId::DrawPhaseStart},
                                      {Phase::Search, MessageId::DrawPhaseSearch},
                                      {Phase::Refine, MessageId::DrawPhaseRefine}}) {
        const bool seen = std::any_of(steps.begin(), steps.end(),
                                      [phase = phase](const relief::Step& step) { return step.phase == phase; });
        if (seen) rows.swatch(roleOf(phase), Message(name));
    }
}

void addLevels(LegendRows& rows, const std::vector<relief::Step>& steps, const StepPaint& paint) {
    std::set<int> levels;
    for (const relief::Step& step : steps) levels.insert(tintedOf(step, paint).tint.level);
    for (const int level : levels) {
        const bool first = level == *levels.begin();
        rows.swatch(Role::Plateau,
                    first ? Message(MessageId::DrawLevelName, {{"level", level}}) : plainText(std::to_string(level)),
                    {level, paint.levels});
    }
}

}  // namespace

const std::vector<std::string>& tracePaneColors() {
    static const std::vector<std::string> names{"decision", "level", "phase"};
    return names;
}

StepColors stepColors(const std::string& name) {
    const std::vector<std::string>& names = tracePaneColors();
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    return static_cast<StepColors>(at % 3);
}

Rgba StepPaint::color(const relief::Step& step, const Style& style) const {
    const Tinted tinted = tintedOf(step, *this);
    return tinted.role == Role::Plateau ? style.levelLine(tinted.tint) : style.color(tinted.role);
}

Drawing traceLegend(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& hit,
                    const relief::Hit& exact, const StepPaint& paint, double width, relief::Language language) {
    LegendRows rows(width, language);
    rows.line(Role::Ray, Message(MessageId::DrawRay));
    if (paint.by == StepColors::Phase) addPhases(rows, steps);
    if (paint.by == StepColors::Level) addLevels(rows, steps, paint);
    rows.bodies(steps, ray, exact);
    auto seen = decisionsSeen(paint.by == StepColors::Decision ? &steps : nullptr, hit.outcome == relief::Outcome::Hit);
    rows.decisions(seen);
    return rows.take();
}

}  // namespace reliefui
