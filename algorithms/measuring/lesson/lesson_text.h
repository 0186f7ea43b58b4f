// The words of a lesson: text.en.md and text.uk.md, in the format that FORMATS.md describes under "Lesson".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenario/expression.h"

namespace relief {

inline constexpr int kMostPageWords = 60;

struct PageText {
    std::string name;
    std::string title;
    std::string text;
    std::string question;
    std::vector<std::string> choices;
    std::string hint, answer, knob, note;
};

struct LessonText {
    std::string title;
    std::string about;  // one sentence: what the lesson shows
    std::string remember, note, source;
    std::vector<PageText> pages;
};

// Throws InputError with file and line.
LessonText parseLessonText(const std::string& text, const std::string& fileName);
// The inverse, for lessons that the window makes.
std::string lessonTextFile(const LessonText& text);

// A value to be filled in: "{frame.error.mean:.2}".
struct ValueSlot {
    std::string expression;
    std::string format;
};
// Returns the values in the words, in order. Throws InputError if a brace is not closed.
std::vector<ValueSlot> valueSlots(const std::string& words);
// Returns the words as HTML: paragraphs, <i>, <code>, <sub>, <sup>. value: the text of a value, not yet escaped.
std::string lessonHtml(const std::string& words, const std::function<std::string(const ValueSlot&)>& value);
// Returns the words of a line, without paragraphs, as HTML.
std::string lessonLine(const std::string& words, const std::function<std::string(const ValueSlot&)>& value);
// The number of words; a value, a formula and a piece of code are one word each.
int wordCount(const std::string& words);
// Escapes a text for HTML and its attributes.
std::string escapedHtml(const std::string& text);

}  // namespace relief
