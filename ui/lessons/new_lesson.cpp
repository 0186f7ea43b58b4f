#include "lessons/new_lesson.h"

#include "measuring/lesson/lesson.h"

namespace reliefui {

void writeNewLesson(const QString& folder, const relief::Scenario& scenario, const QString& pane,
                    const QString& datasets) {
    relief::NewLesson lesson;
    lesson.scenario = scenario;
    lesson.pane = pane.toStdString();
    lesson.datasets = datasets.toStdString();
    const auto words = [&](const char* title, const char* about, const char* page, const char* text) {
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
    const char* const steps = scenario.pixel ? " {trace.steps}" : "";
    lesson.english =
        words("A new lesson", "What the lesson shows, in one sentence.", "The first page",
              (std::string("Up to sixty words. Values are filled in, such as the number of steps:") + steps).c_str());
    lesson.ukrainian =
        words("Новий урок", "Що показує урок, одним реченням.", "Перша сторінка",
              (std::string("До шістдесяти слів. Величини підставляються, як-от кількість кроків:") + steps).c_str());
    relief::writeLesson(folder.toStdString(), lesson);
}

}  // namespace reliefui
