#include "lesson_command.h"

#include <cstdio>
#include <filesystem>

#include "measuring/lesson/lesson_check.h"
#include "workspace/language.h"
#include "workspace/start_scenario.h"

namespace relief::app {

namespace fs = std::filesystem;

NamedLessons namedLessons(const std::string& text, const std::string& datasets) {
    const std::string shipped = reliefui::lessonsFolder(datasets);
    const auto inCourse = [](const std::string& folder) {
        NamedLessons named;
        named.course = folder;
        for (const std::string& name : readCourse(folder).lessons())
            named.folders.push_back((fs::path(folder) / name).string());
        return named;
    };
    std::error_code none;
    if (text != "all" && fs::is_directory(text, none)) {
        if (fs::exists(fs::path(text) / "lesson.json", none)) return {{text}, {}};
        return inCourse(text);
    }
    if (shipped.empty()) throw InputError("--lesson", Message(MessageId::LessonsNotFound));
    NamedLessons all = inCourse(shipped);
    if (text == "all") return all;
    std::vector<std::string> names;
    for (const std::string& folder : all.folders) {
        names.push_back(fs::path(folder).filename().string());
        if (names.back() == text) return {{folder}, {}};
    }
    throw InputError("--lesson", unknownName({"what", MessageId::WordLesson}, text, commaList(names)));
}

int checkLessons(const Arguments& arguments, const std::string& datasets) {
    const Language language = reliefui::uiLanguage();
    SceneCache scenes;
    Work work;
    bool allHold = true;
    for (const std::string& folder : namedLessons(arguments.lesson, datasets).folders) {
        const Lesson lesson = readLesson(folder, datasets);
        const LessonReport report = checkLesson(lesson, scenes, work);
        allHold = allHold && report.holds();
        std::fputs(reportText(lesson, report, language).c_str(), stdout);
        std::fflush(stdout);
    }
    return allHold ? 0 : 1;
}

}  // namespace relief::app
