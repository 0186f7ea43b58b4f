// Lessons as pages for any browser (html_page.h).
#pragma once

#include <string>

#include "measuring/lesson/course.h"
#include "measuring/lesson/lesson_check.h"
#include "windows/html_page.h"

namespace reliefui {

// Where a page's lesson stands in its course: the files before and after it; empty: none.
struct LessonLinks {
    std::string before, after, contents;
};

// Returns the lesson as one HTML file in both languages. Call on the thread of a QApplication. Throws what measuring
// and drawing throw.
std::string lessonPage(const relief::Lesson& lesson, const LessonLinks& links, relief::SceneCache& scenes,
                       const LanguageSetter& installLanguage, relief::Work& work);

// Returns the contents of a course; lessons: all of it, in order. A lesson's file is its name with .html.
std::string contentsPage(const relief::Course& course, const std::vector<relief::Lesson>& lessons);

// Returns a pane of the scenario as a page with a slider over the steps.
std::string viewPage(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot,
                     const LanguageSetter& installLanguage, relief::Work& work);

}  // namespace reliefui
