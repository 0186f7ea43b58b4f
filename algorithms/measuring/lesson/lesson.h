// Lessons as documents: a folder with lesson.json and its words (FORMATS.md, "Lesson").
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "measuring/lesson/lesson_text.h"
#include "scenario/expression.h"
#include "scenario/json_reader.h"
#include "scenario/scenario.h"

namespace relief {

inline constexpr int kLessonVersion = 1;

// The step of a ray: a number from 1, or "last", "departure", "overshoot", or the name of a decision.
using StepRule = std::variant<int, std::string>;

struct LessonQuestion {
    // Choose: the conditions of the answers, one of which holds. Number: the value, and how far a right answer may be
    // from it. Hit: where the ray hits, to be shown on the screen; within: texels.
    enum class Kind : std::uint8_t { Choose, Number, Hit };
    Kind kind = Kind::Choose;
    std::vector<Expression> choices;
    std::optional<Expression> number;
    double within = 0;
};
inline constexpr double kHitWithin = 4;  // texels, if a question gives no number

enum class Trend : std::uint8_t { None, Falls, Rises, Same };

struct LessonKnob {
    struct Watched {
        Expression value;
        Trend trend = Trend::None;
    };
    std::string set;  // JSON pointer into the scenario
    std::vector<Json> values;
    std::vector<Watched> watch;
};

// Returns a value of a knob as it is shown: a string without quotation marks.
std::string knobValueText(const Json& value);
// Sets the value at the JSON pointer; missing objects are made. Returns false, with the scenario possibly changed, if
// that is no pointer, or if it leads to an element that its array does not have or below a value that is neither object
// nor array.
bool putValue(Json& scenario, const std::string& pointer, const Json& value);

struct LessonPage {
    std::string name;
    std::string pane, layer;  // empty: unchanged
    std::optional<StepRule> step;
    std::optional<LessonQuestion> question;
    std::optional<LessonKnob> knob;
    std::vector<Expression> claims;
    Json scenario;  // with the changes of this page and those before it
    std::size_t line = 1;
};

struct Lesson {
    std::string name;    // of the folder
    std::string folder;  // with lesson.json
    double minutes = 0;  // 0: not given
    std::vector<LessonPage> pages;
    std::vector<std::pair<std::string, Json>> variants;
    LessonText english, ukrainian;

    std::string file() const;
    const LessonText& text(Language language) const { return language == Language::Ukrainian ? ukrainian : english; }
    // Returns std::nullopt if there is no page of this name.
    std::optional<std::size_t> pageOf(const std::string& name) const;
    // Returns the scenario of a page; with one number of its knob if `turned`. Throws InputError with file and line.
    Scenario scenarioOf(std::size_t page, std::optional<std::size_t> turned = std::nullopt) const;
    // Returns the scenario of `place` - a page, or a variant of `from` - or std::nullopt if there is none.
    std::optional<Scenario> scenarioAt(const std::string& place, const Scenario& from) const;
};

// Resolves a scenario's paths that begin with "datasets/", the folder of the shipped pictures, unless there are such
// files in `folder`, that of the file with the scenario.
void resolveShipped(Json& scenario, const std::string& folder, const std::string& datasets);

// Reads the lesson in the folder. datasets: folder of the shipped pictures. Throws InputError for a missing file,
// unknown keys, wrong values, expressions that are none, and words that do not fit the pages.
Lesson readLesson(const std::string& folder, const std::string& datasets);
// A lesson of one page, which shows the scenario at its step. datasets: as above; pictures in it are named as shipped
// ones.
struct NewLesson {
    Scenario scenario;
    std::string pane;
    std::string datasets;
    LessonText english, ukrainian;
};
// Writes it into a new folder. Throws InputError if the folder exists, WorkError if it cannot be written.
void writeLesson(const std::string& folder, const NewLesson& lesson);

// Returns the index of the step among the ray's steps; std::nullopt if there is none such.
// departure, overshoot: as Judgement has them, if there are any.
std::optional<int> stepOf(const StepRule& rule, const std::vector<Step>& steps, std::optional<std::size_t> departure,
                          std::optional<std::size_t> overshoot);

}  // namespace relief
