#include "lesson_command.h"

#include <cstdio>
#include <filesystem>

#include <QApplication>

#include "measuring/lesson/course.h"
#include "measuring/lesson/lesson_check.h"
#include "relief/files.h"
#include "windows/lesson_html.h"
#include "windows/program.h"
#include "workspace/language.h"
#include "workspace/start_scenario.h"

namespace relief::app {

namespace fs = std::filesystem;

namespace {

constexpr int kClaimFails = 1;
constexpr int kBadUsage = 2;

}  // namespace

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
        if (isLesson(text)) return {{text}, {}};
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
    bool allHold = true, allRead = true;
    const std::vector<std::string> folders = namedLessons(arguments.lesson, datasets).folders;
    for (const std::string& folder : folders) {
        try {
            const Lesson lesson = readLesson(folder, datasets);
            const LessonReport report = checkLesson(lesson, scenes, work);
            allHold = allHold && report.holds();
            std::fputs(reportText(lesson, report, language).c_str(), stdout);
        } catch (const InputError& error) {
            if (folders.size() == 1) throw;
            // The others are checked all the same.
            allRead = false;
            const Message line(MessageId::LessonUnread,
                               {{"lesson", fs::path(folder).filename().string()}, {"why", error.text(language)}});
            std::printf("%s\n", sentence(line, language).c_str());
        }
        std::fflush(stdout);
    }
    return !allRead ? kBadUsage : allHold ? 0 : kClaimFails;
}

int writeLessonPages(int count, char** values, const Arguments& arguments, const std::string& datasets) {
    const NamedLessons named = namedLessons(arguments.lesson, datasets);
    const bool folder = !named.course.empty();
    if (!folder) reliefui::checkHtmlFile(arguments.output);
    std::vector<Lesson> lessons;
    for (const std::string& one : named.folders) lessons.push_back(readLesson(one, datasets));
    reliefui::prepareFigures();
    QApplication application(count, values);
    reliefui::setUpApplication(application);
    SceneCache scenes;
    Work work;
    const auto page = [&](const Lesson& lesson, const reliefui::LessonLinks& links) {
        return reliefui::lessonPage(lesson, links, scenes, reliefui::installPageLanguage, work);
    };
    if (!folder) {
        writeTextFile(arguments.output, page(lessons.front(), {}));
        return 0;
    }
    std::error_code fault;
    fs::create_directories(arguments.output, fault);
    if (fault) throw WorkError(arguments.output, Message(MessageId::LessonFolderFails, {{"why", fault.message()}}));
    const auto file = [](const Lesson& lesson) { return lesson.name + ".html"; };
    for (std::size_t n = 0; n < lessons.size(); ++n) {
        reliefui::LessonLinks links;
        links.contents = "index.html";
        if (n > 0) links.before = file(lessons[n - 1]);
        if (n + 1 < lessons.size()) links.after = file(lessons[n + 1]);
        writeTextFile((fs::path(arguments.output) / file(lessons[n])).string(), page(lessons[n], links));
    }
    writeTextFile((fs::path(arguments.output) / "index.html").string(),
                  reliefui::contentsPage(readCourse(named.course), lessons));
    return 0;
}

}  // namespace relief::app
