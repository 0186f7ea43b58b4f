#include "paper_command.h"

#include <cstdio>
#include <filesystem>
#include <vector>

#include <QApplication>

#include "windows/paper_figures.h"
#include "windows/program.h"
#include "workspace/language.h"
#include "workspace/start_scenario.h"

namespace relief::app {

namespace fs = std::filesystem;

namespace {

std::string lineOf(const reliefui::PaperFigure& figure, Language language) {
    const std::size_t n = language == Language::Ukrainian ? 1 : 0;
    std::string line = figure.name + "  " + sentence(figure.place(), language) + ": " + figure.caption[n];
    if (!figure.note[n].empty()) line += " " + figure.note[n];
    return line;
}

}  // namespace

int paperFigures(int count, char** values, const Arguments& arguments, const std::string& datasets) {
    const Language language = reliefui::uiLanguage();
    const std::vector<std::string> files =
        reliefui::paperFigureFiles(arguments.paperFigures, reliefui::paperFiguresFolder(datasets));
    reliefui::prepareFigures();
    QApplication application(count, values);
    reliefui::setUpApplication(application);
    std::vector<reliefui::PaperFigure> figures;
    for (const std::string& file : files) figures.push_back(reliefui::readPaperFigure(file, datasets));
    const std::string& folder = arguments.output;
    if (!folder.empty()) {
        std::error_code fault;
        fs::create_directories(folder, fault);
        if (fault) throw WorkError(folder, Message(MessageId::LessonFolderFails, {{"why", fault.message()}}));
    }
    Work work;
    for (const reliefui::PaperFigure& figure : figures) {
        if (!folder.empty()) {
            reliefui::writePaperFigure(figure, folder, RELIEF_VERSION, reliefui::installPageLanguage, work);
        }
        std::printf("%s\n", lineOf(figure, language).c_str());
        std::fflush(stdout);
    }
    if (!folder.empty()) reliefui::writePaperDocuments(figures, folder);
    return 0;
}

}  // namespace relief::app
