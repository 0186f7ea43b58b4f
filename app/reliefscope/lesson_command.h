// reliefscope --lesson NAME --check | --html -o FILE: what is done with lessons without a window.
#pragma once

#include <string>
#include <vector>

#include "arguments.h"

namespace relief::app {

// The lessons that `--lesson` names, by their folders.
struct NamedLessons {
    std::vector<std::string> folders;
    std::string course;  // the folder that they are in; empty: a single lesson
};
// text: the name of a shipped lesson, "all", or the folder of a lesson or of lessons. datasets: folder of the shipped
// pictures, next to which the shipped lessons are. Throws InputError("--lesson", ...).
NamedLessons namedLessons(const std::string& text, const std::string& datasets);

// Writes the lesson as a page, or all lessons named as a folder of pages with contents. count, values: of main().
// Returns the exit status. Throws InputError, WorkError.
int writeLessonPages(int count, char** values, const Arguments& arguments, const std::string& datasets);

// Prints a line per lesson; returns the exit status. Throws InputError.
int checkLessons(const Arguments& arguments, const std::string& datasets);

}  // namespace relief::app
