#include "measuring/lesson/course.h"

#include <algorithm>
#include <filesystem>

#include "relief/files.h"
#include "scenario/json_reader.h"

namespace relief {

namespace fs = std::filesystem;

namespace {

// Names of the lessons in the folder, in order; empty also if it cannot be read.
std::vector<std::string> lessonsIn(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (isLesson(entry.path().string())) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

std::vector<std::string> Course::lessons() const {
    std::vector<std::string> all;
    for (const Chapter& chapter : chapters) all.insert(all.end(), chapter.lessons.begin(), chapter.lessons.end());
    return all;
}

bool isLesson(const std::string& folder) {
    std::error_code none;
    return fs::exists(fs::path(folder) / kLessonFile, none);
}

bool isLessonFolder(const std::string& folder) {
    return isLesson(folder) || !lessonsIn(folder).empty();
}

Course readCourse(const std::string& folder) {
    Course course;
    course.folder = folder;
    const std::vector<std::string> names = lessonsIn(folder);
    if (names.empty()) throw InputError(folder, Message(MessageId::LessonNone));
    std::vector<std::string> begins;
    const std::string file = (fs::path(folder) / "course.json").string();
    if (std::error_code none; fs::exists(file, none)) {
        const std::string text = readTextFile(file);
        const Json json = parseJson(text, file);
        JsonReader reader({text, file}, json, {});
        int version = 0;
        reader.readWhole("course", version);
        if (version != kCourseVersion)
            reader.fail("course", Message(MessageId::LessonVersion, {{"known", kCourseVersion}}));
        reader.readObjects("chapters", [&](JsonReader item) {
            Chapter chapter;
            std::string begin;
            item.read("begins", begin);
            if (begin.empty()) item.fail("begins", MessageId::WantAText);
            if (item.has("title")) {
                JsonReader title = item.child("title");
                title.read("en", chapter.english);
                title.read("uk", chapter.ukrainian);
                title.finish();
            }
            item.finish();
            if (chapter.ukrainian.empty()) chapter.ukrainian = chapter.english;
            if (chapter.english.empty()) chapter.english = chapter.ukrainian;
            begins.push_back(begin);
            course.chapters.push_back(std::move(chapter));
        });
        reader.finish();
    }
    Chapter rest;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(begins.begin(), begins.end(), [&](const std::string& b) { return name.starts_with(b); });
        Chapter& chapter =
            found == begins.end() ? rest : course.chapters[static_cast<std::size_t>(found - begins.begin())];
        chapter.lessons.push_back(name);
    }
    if (!rest.lessons.empty()) course.chapters.push_back(std::move(rest));
    std::erase_if(course.chapters, [](const Chapter& chapter) { return chapter.lessons.empty(); });
    return course;
}

}  // namespace relief
