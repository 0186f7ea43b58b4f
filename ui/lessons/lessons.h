// Lessons: scenes that each demonstrate one effect and open with one click. Each is a scenario file in the program's
// resources; the tests check that it shows what its description claims.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "measuring/compare/duel.h"
#include "scenario/scenario.h"

namespace reliefui {

struct Lesson {
    QString name;   // file name without extension
    QString title;  // in the window's language
    QString about;  // one or two sentences on what can be seen
    QString pane;   // name of the pane that shows it
    // How the method errs at the chosen pixel; std::nullopt if it does not.
    std::optional<relief::Departure> departure;
};

std::vector<Lesson> lessons();
// Throws InputError if the program has no lesson of this name.
relief::Scenario lessonScenario(const QString& name);

}  // namespace reliefui
