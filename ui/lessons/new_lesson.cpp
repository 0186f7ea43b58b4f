#include "lessons/new_lesson.h"

#include "measuring/lesson/lesson.h"

namespace reliefui {

void writeNewLesson(const QString& folder, const relief::Scenario& scenario, const QString& pane,
                    const QString& datasets) {
    relief::NewLesson lesson;
    lesson.scenario = scenario;
    lesson.pane = pane.toStdString();
    lesson.datasets = datasets.toStdString();
    const auto words = [](const char* title, const char* about, const char* page, const std::string& text) {
        relief::LessonText out;
        out.title = title;
        out.about = about;
        relief::PageText first;
        first.name = "start";
        first.title = page;
        first.text = text;
        out.pages.push_back(std::move(first));
        return out;
    };
    // In both languages, whatever the window's is: these are files, to be edited.
    const std::string steps = scenario.pixel ? " {trace.steps}" : "";
    lesson.english = words("A new lesson", "What the lesson shows, in one sentence.", "The first page",
                           "Up to sixty words. Values are filled in, such as the number of steps:" + steps);
    lesson.ukrainian = words("Новий урок", "Що показує урок, одним реченням.", "Перша сторінка",
                             "До шістдесяти слів. Величини підставляються, як-от кількість кроків:" + steps);
    relief::writeLesson(folder.toStdString(), lesson);
}

}  // namespace reliefui
