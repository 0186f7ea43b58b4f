// Checks a lesson as it is shown: every value of its texts can be measured, every claim and every answer holds.
#pragma once

#include <string>
#include <vector>

#include "measuring/lesson/quantities.h"

namespace relief {

struct LessonFault {
    std::string page;
    Message why;
};

struct LessonReport {
    int claims = 0;  // checked, answers of questions and trends of knobs included
    int values = 0;  // of texts
    std::vector<LessonFault> faults;

    bool holds() const { return faults.empty(); }
};

// Returns the scenario of a page with the step that its rule finds. Throws InputError if there is no such step, and
// what measuring throws.
Scenario shownScenario(const Lesson& lesson, std::size_t page, SceneCache& scenes, Work& work);
// Fills in the values of a text: its function for lessonHtml(). Throws what measuring throws.
std::string filledValue(const ValueSlot& slot, const QuantitySource& source);
// Returns the number of the answer, from 0, whose condition holds. Throws InputError unless it is exactly one.
std::size_t rightChoice(const LessonQuestion& question, const QuantitySource& source);
// Returns the watched values at each turn of the page's knob: [turn][watched].
std::vector<std::vector<double>> turnedValues(const Lesson& lesson, std::size_t page, SceneCache& scenes, Work& work);

// Throws Cancelled; all else is a fault of the report.
LessonReport checkLesson(const Lesson& lesson, SceneCache& scenes, Work& work);
// Returns the line of a report, "302 holds: 4 pages, 9 claims, 14 values", and a line per fault below it.
std::string reportText(const Lesson& lesson, const LessonReport& report, Language language);

}  // namespace relief
