// Lessons: scenes that show one thing, chosen with one click. Each is a scenario file that comes with the program; what
// it is said to show, the tests hold it to.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "measuring/compare/duel.h"
#include "scenario/scenario.h"

namespace reliefui {

struct Lesson {
    QString name;   // of its file, without the ending
    QString title;  // in the language of the window
    QString about;  // what is to be seen, in a sentence or two
    QString pane;   // the name of the pane that shows it
    // How the scenario's method goes wrong at the chosen pixel; nothing: it does not.
    std::optional<relief::Departure> departure;
};

std::vector<Lesson> lessons();
// Throws InputError where the program has no such file.
relief::Scenario lessonScenario(const QString& name);

}  // namespace reliefui
