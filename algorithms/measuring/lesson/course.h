// Courses: folders of lessons, with their chapters (FORMATS.md, "Lesson").
#pragma once

#include <string>
#include <vector>

#include "relief/messages.h"

namespace relief {

inline constexpr int kCourseVersion = 1;
// The file that makes a folder a lesson.
inline constexpr const char* kLessonFile = "lesson.json";

// A chapter of a course, with the names of its lessons in order.
struct Chapter {
    std::string english, ukrainian;  // titles; empty: the course has no chapters
    std::vector<std::string> lessons;

    const std::string& title(Language language) const { return language == Language::Ukrainian ? ukrainian : english; }
};
struct Course {
    std::string folder;
    std::vector<Chapter> chapters;

    std::vector<std::string> lessons() const;  // of all chapters
};
// Reads course.json, if there is one, and lists the lessons. Throws InputError if the folder holds no lesson.
Course readCourse(const std::string& folder);
// Returns true if the folder is a lesson, which can still have faults.
bool isLesson(const std::string& folder);
// Returns true if the folder is a lesson or holds lessons.
bool isLessonFolder(const std::string& folder);

}  // namespace relief
