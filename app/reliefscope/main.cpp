// The program `reliefscope`, which opens the window. Every fault of its arguments or its display is reported in one
// line before a window opens.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

#include <QApplication>
#include <QFileInfo>
#include <QSettings>

#include "../relief/signals.h"
#include "arguments.h"
#include "display_loss.h"
#include "end_signals.h"
#include "lesson_command.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/pareto.h"
#include "panes/charts/charts_figure.h"
#include "panes/charts/charts_state.h"
#include "panes/distance/distance_figure.h"
#include "panes/distance/distance_state.h"
#include "panes/rows/rows_drawing.h"
#include "panes/rows/rows_state.h"
#include "paper_command.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"
#include "scenario/variation.h"
#include "windows/application.h"
#include "windows/display_check.h"
#include "windows/lesson_html.h"
#include "windows/lesson_menu.h"
#include "windows/main_window.h"
#include "windows/moving_picture.h"
#include "windows/pane_list.h"
#include "windows/program.h"
#include "windows/restore_offer.h"
#include "workspace/language.h"
#include "workspace/last_state.h"
#include "workspace/layer_names.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"
#include "workspace/resized_snapshot.h"
#include "workspace/snapshot_maker.h"
#include "workspace/start_scenario.h"
#include "workspace/state_keeper.h"

namespace relief::app {

namespace {

constexpr int kWorkFailed = 1;
constexpr int kBadUsage = 2;
// status with which the event loop ends to change the language; not an exit status
constexpr int kOtherLanguage = 1000;

struct Start {
    Scenario scenario;
    AssetStore pictures;  // already loaded if the user named them
};

bool endsInJson(const std::string& path) {
    return std::filesystem::path(path).extension() == ".json";
}

Start chosenStart(const Arguments& arguments, const std::string& datasets) {
    const std::string& file = arguments.file;
    Start start;
    start.scenario = reliefui::startScenario(datasets);
    if (file.empty()) return start;
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    try {
        if (endsInJson(path)) {
            start.scenario = reliefui::loadWindowScenario(path, reliefui::stateReaders());
        } else {
            start.scenario.pictures = {};
            start.scenario.pictures.height = path;
        }
        if (arguments.memory > 0) start.scenario.pictures.memory = arguments.memory;
        Work work;
        start.pictures.load(start.scenario.pictures, work, true);
    } catch (const InputError& error) {
        // The message names the file as the user typed it.
        if (error.subject() == path) throw InputError(file, error.message());
        throw;
    }
    return start;
}

// Returns the state of the last session, unless the arguments ask for something else.
Start startOfWindow(const Arguments& arguments, const std::string& datasets, reliefui::SessionFiles* session) {
    if (arguments.file.empty() && session != nullptr && !arguments.anew) {
        Start start;
        session->setStarting(true);
        if (const auto last = reliefui::lastState(start.pictures, reliefui::stateReaders())) {
            start.scenario = *last;
            return start;
        }
    }
    return chosenStart(arguments, datasets);
}

// Returns the folder of the shipped pictures.
std::string shippedPictures() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return reliefui::datasetsFolder(program.parent_path().string());
}

std::vector<std::string> betweenCommas(const std::string& text) {
    std::vector<std::string> parts{{}};
    for (const char c : text) {
        if (c == ',') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

// Returns the chart of a table that `relief bench tracers` wrote.
std::shared_ptr<const reliefui::Figure> paretoChart(const Arguments& arguments) {
    auto source = std::make_shared<reliefui::ParetoSource>();
    if (!arguments.error.empty()) source->measure = parseErrorMeasure(arguments.error, "--error");
    source->table = paretoTable(chosenRows(readBenchTable(arguments.file), arguments.relief, arguments.elevation));
    source->title = reliefui::paretoTitle(source->table);
    auto charts = std::make_shared<reliefui::ChartsSource>();
    charts->shown = reliefui::ChartsShown::Pareto;
    charts->pareto = std::move(source);
    return reliefui::chartsFigure(std::move(charts));
}

reliefui::Layer chosenLayer(const std::string& name) {
    if (name.empty()) return reliefui::Layer::Color;
    if (const auto layer = reliefui::layerNamed(name)) return *layer;
    const std::vector<std::string> known(reliefui::kLayerNames.begin(), reliefui::kLayerNames.end());
    throw InputError("--layer", unknownName({"what", MessageId::WordLayer}, name, commaList(known)));
}

// Command-line arguments take precedence over the scenario.
void takeArguments(Scenario& scenario, const Arguments& arguments) {
    auto distance = reliefui::stateOf<reliefui::DistancePane>(scenario);
    auto rows = reliefui::stateOf<reliefui::RowsPane>(scenario);
    auto charts = reliefui::stateOf<reliefui::ChartsPane>(scenario);
    if (!arguments.map.empty()) distance.map = arguments.map;
    if (!arguments.minus.empty()) distance.minus = arguments.minus;
    if (!arguments.axis.empty()) distance.axis = arguments.axis;
    if (arguments.slice >= 0) distance.slice = arguments.slice;
    if (!arguments.variants.empty()) rows.variants = betweenCommas(arguments.variants);
    if (arguments.rowWidth) rows.pixels = *arguments.rowWidth;
    if (!arguments.error.empty()) charts.error = arguments.error;
    reliefui::setState(scenario, distance);
    reliefui::setState(scenario, rows);
    reliefui::setState(scenario, charts);
}

// Parses "X,Y", a pixel within the picture. Throws InputError.
PixelChoice chosenPixel(const std::string& text, const Scenario& scenario) {
    const std::vector<std::string> parts = betweenCommas(text);
    if (parts.size() != 2) throw InputError("--pixel", Message(MessageId::NotAPixel, {{"text", text}}));
    const auto side = [](const std::string& part, int sides) {
        const double number = parseNumber(part, "--pixel");
        reliefui::requireRange("--pixel", number, 0, sides - 1);
        if (number != std::floor(number)) {
            throw InputError("--pixel",
                             Message(MessageId::NumberOutOfRange, {{"value", number}, {"range", "0, 1, 2, ..."}}));
        }
        return static_cast<int>(number);
    };
    return {side(parts[0], scenario.width), side(parts[1], scenario.height)};
}

// Parses "A,B,...": the scenario's own variant, followed by those that it is compared with.
void takeCompared(Scenario& scenario, CompareSubject subject, const std::string& list, const char* option) {
    if (list.empty()) return;
    std::vector<MethodChoice> choices;
    for (const std::string& text : betweenCommas(list)) {
        choices.push_back(splitMethodChoice(text, option));
        checkVariation(subject, choices.back(), option);
    }
    if (choices.size() > kMostCompared) {
        throw InputError(option,
                         Message(MessageId::NumberOutOfRange, {{"value", static_cast<int>(choices.size())},
                                                               {"range", rangeOf(std::size_t{1}, kMostCompared)}}));
    }
    scenario = varied(scenario, subject, choices.front());
    if (choices.size() == 1) return;
    scenario.comparison.subject = subject;
    othersOf(scenario.comparison).assign(choices.begin() + 1, choices.end());
    scenario.comparison.dividers.clear();
}

// Applies the arguments that determine the view; they take precedence over the scenario. Throws InputError.
void takeView(Scenario& scenario, const Arguments& arguments) {
    if (arguments.pixelWidth > 0) {
        scenario = reliefui::inSize(std::move(scenario), arguments.pixelWidth, arguments.pixelHeight);
    }
    if (!arguments.pixel.empty()) {
        scenario.pixel = chosenPixel(arguments.pixel, scenario);
        scenario.other = {};
    }
    takeCompared(scenario, CompareSubject::Methods, arguments.tracers, "--tracers");
    takeCompared(scenario, CompareSubject::Filters, arguments.filters, "--filters");
    takeCompared(scenario, CompareSubject::Mappings, arguments.mappings, "--mappings");
}

// Throws InputError for invalid options, before long work begins.
void checkArguments(const Arguments& arguments) {
    for (const std::string& kind : {arguments.map, arguments.minus}) {
        if (!kind.empty()) methodOfMap(kind);  // throws
    }
    if (!arguments.variants.empty()) reliefui::rowMethods({betweenCommas(arguments.variants)}, "--variants");  // throws
    if (!arguments.error.empty()) parseErrorMeasure(arguments.error, "--error");                               // throws
    chosenLayer(arguments.layer);                                                                              // throws
    reliefui::requireRange("--row-width", arguments.rowWidth.value_or(1), 1, static_cast<double>(kWidestRow));
}

// Returns the lines of the help that describe the views, "VIEW: ...".
std::string figureLines() {
    constexpr std::size_t kWidth = 110;
    const std::string indent(24, ' ');
    std::string lines = indent + "VIEW:";
    std::size_t begin = 0;  // start of the last line
    for (const reliefui::FigureKind& kind : reliefui::figureList()) {
        const std::string word = " " + kind.name + (kind.vectors ? "," : " (PNG alone),");
        if (lines.size() - begin + word.size() > kWidth) {
            lines += '\n';
            begin = lines.size();
            lines += indent.substr(1);
        }
        lines += word;
    }
    lines.pop_back();
    return lines;
}

void writeMoving(const reliefui::MovingPicture& moving, reliefui::SnapshotMaker& maker,
                 const reliefui::FigurePage& page, const Arguments& arguments, Work& work) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const auto progress = [terminal](std::size_t done, std::size_t all) {
        if (terminal) std::fprintf(stderr, "\r%zu/%zu%s", done, all, done == all ? "\n" : "");
    };
    if (arguments.html) {
        writeTextFile(arguments.output,
                      reliefui::movingPage(moving, maker, reliefui::installPageLanguage, progress, work));
    } else {
        reliefui::writeFrames(moving, maker, page, arguments.output, progress, work);
    }
}

int exportFigure(int count, char** values, const Arguments& arguments, std::stop_token stop) {
    const reliefui::FigureKind kind = reliefui::figureKind(arguments.figure);
    reliefui::FigurePage page;
    page.title = arguments.figure;
    page.widthMm = arguments.widthMm;
    page.dpi = arguments.dpi;
    page.widthPixels = arguments.pixelWidth;
    page.caption = arguments.caption;
    page.style.theme = arguments.dark ? reliefui::Theme::Dark : reliefui::Theme::Light;
    page.style.language = reliefui::uiLanguage();
    if (arguments.html) {
        reliefui::checkHtmlFile(arguments.output);
    } else {
        reliefui::checkPage(page, arguments.output, kind.vectors);
    }
    if (arguments.html && !kind.make) {
        throw InputError("--html", Message(MessageId::ArgumentsExclude, {{"other", "--export " + arguments.figure}}));
    }
    checkArguments(arguments);
    if (!kind.make) {
        const auto chart = paretoChart(arguments);
        reliefui::prepareFigures();
        QApplication application(count, values);
        reliefui::setUpApplication(application);
        Work work(0, stop);
        reliefui::writeFigure(*chart, page, arguments.output, work);
        return 0;
    }
    Start start = chosenStart(arguments, shippedPictures());
    takeView(start.scenario, arguments);
    takeArguments(start.scenario, arguments);
    reliefui::prepareFigures();
    QApplication application(count, values);
    reliefui::setUpApplication(application);
    reliefui::SnapshotMaker maker(std::move(start.pictures));
    reliefui::SnapshotOrder order;
    order.scenario = start.scenario;
    order.layer = chosenLayer(arguments.layer);
    order.lastStep = !arguments.pixel.empty();
    Work work(0, stop);
    if (!arguments.sequence.empty()) {
        writeMoving({kind, parseSequence(arguments.sequence, arguments.frames, "--sequence"), order}, maker, page,
                    arguments, work);
        return 0;
    }
    const auto snapshot = maker.make(order, work);
    if (arguments.slice >= 0) reliefui::checkSlice(*snapshot, arguments.slice, "--slice", work);
    if (arguments.html) {
        writeTextFile(arguments.output, reliefui::viewPage(kind, snapshot, reliefui::installPageLanguage, work));
        return 0;
    }
    const auto figure = kind.make(snapshot, snapshot->scenario);
    reliefui::writeFigure(*figure, page, arguments.output, work);
    return 0;
}

// Ends the event loop; run() then creates the window again for the same workspace in the other language.
void changeLanguage(const QString& language) {
    QSettings().setValue(QStringLiteral("language"), language);
    QApplication::exit(kOtherLanguage);
}

// lesson: its folder; empty: none.
void openFirst(reliefui::MainWindow& window, reliefui::Workspace& workspace, const Arguments& arguments,
               const std::string& lesson) {
    // A screenshot neither restores nor stores a session.
    const bool shot = !arguments.screenshot.empty();
    if (arguments.width > 0) {
        const double fine = window.devicePixelRatioF();
        window.resize(qRound(arguments.width / fine), qRound(arguments.height / fine));
        window.resetLayout();
    } else if (!shot) {
        arguments.anew ? window.fitScreen() : window.restoreLayout();
    }
    if (shot) {
        reliefui::screenshotThenQuit(window, workspace, QString::fromStdString(arguments.screenshot));
    }
    window.show();
    if (!shot && lesson.empty()) window.welcome(arguments.anew);
    if (!lesson.empty()) window.findChild<reliefui::LessonMenu*>()->open(QString::fromStdString(lesson));
    // When the first pictures are ready, brings a lesson's pane to the front, or adds the opened file to the recent
    // files.
    const QString file = shot ? QString() : QString::fromStdString(arguments.file);
    auto first = std::make_shared<QMetaObject::Connection>();
    *first = QObject::connect(
        &workspace, &reliefui::Workspace::snapshotChanged, &window, [first, file, &window, &workspace] {
            QObject::disconnect(*first);
            file.isEmpty() ? window.showLesson() : workspace.opened(QFileInfo(file).absoluteFilePath());
        });
}

int run(int count, char** values, const Arguments& arguments) {
    if (arguments.check) return checkLessons(arguments, shippedPictures());
    if (arguments.html && arguments.figure.empty()) {
        return writeLessonPages(count, values, arguments, shippedPictures());
    }
    if (!arguments.paperFigures.empty()) return paperFigures(count, values, arguments, shippedPictures());
    if (!arguments.figure.empty()) {
        const SignalWatch watch;
        try {
            return exportFigure(count, values, arguments, watch.stop());
        } catch (const Cancelled&) {
            const Message message(MessageId::StoppedBySignal, {{"signal", signalName(watch.exitStatus())}});
            std::fprintf(stderr, "reliefscope: %s\n", sentence(message, reliefui::uiLanguage()).c_str());
            return watch.exitStatus();
        }
    }
    std::optional<DisplayLoss> displayLoss;
    if (arguments.checkDisplay) {
        DisplayLoss::endQuietly();
    } else {
        displayLoss.emplace();
    }
    const std::string problem = reliefui::displayProblem();
    if (!problem.empty()) {
        const Message fault(MessageId::WindowNone, {{"why", problem}});
        std::fprintf(stderr, "reliefscope: %s\n", sentence(fault, reliefui::uiLanguage()).c_str());
        return DisplayLoss::kNoDisplay;
    }
    if (arguments.checkDisplay) return 0;
    const std::string datasets = shippedPictures();
    // A wrong name is refused before a session begins, which the next start would take for one that crashed.
    std::string folder;
    if (!arguments.lesson.empty()) folder = namedLessons(arguments.lesson, datasets).folders.front();
    // A screenshot neither restores nor stores a session.
    const bool shot = !arguments.screenshot.empty();
    std::optional<reliefui::SessionFiles> session;
    std::vector<reliefui::SessionFiles> left;
    if (!shot) session = reliefui::SessionFiles::begin();
    if (!shot && !arguments.anew) left = reliefui::SessionFiles::leftBehind();
    Start start = startOfWindow(arguments, datasets, session ? &*session : nullptr);

    reliefui::prepareWindows();
    reliefui::Application application(count, values);
    reliefui::setUpApplication(application);
    if (!shot) reliefui::installTranslations(reliefui::chosenLanguage());
    QApplication::setApplicationVersion(QStringLiteral(RELIEF_VERSION));
    const EndSignals endSignals;
    reliefui::Workspace workspace(std::make_shared<const reliefui::StateReaders>(reliefui::stateReaders()));
    // Loading and rendering begin while the window is being created.
    workspace.start(start.scenario, std::move(start.pictures));
    reliefui::MainWindow* shown = nullptr;
    QVariantMap layout;
    std::optional<reliefui::StateKeeper> keeper;
    if (session) {
        keeper.emplace(&workspace, std::move(*session), start.scenario,
                       [&] { return shown != nullptr ? shown->layoutNow() : layout; });
        QObject::connect(&*keeper, &reliefui::StateKeeper::problem, &workspace, &reliefui::Workspace::problem);
    }
    displayLoss->saveBy([&] { return keeper && keeper->keepNow(); });
    int status = 0;
    // The open lesson, with which the window in the other language goes on.
    reliefui::LessonMenu::Kept lesson;
    for (bool first = true; first || status == kOtherLanguage; first = false) {
        reliefui::MainWindow window(&workspace, QString::fromStdString(datasets));
        shown = &window;
        QObject::connect(&window, &reliefui::MainWindow::languageChosen, &workspace, &changeLanguage);
        reliefui::RestoreOffer* offer = nullptr;
        if (keeper) offer = new reliefui::RestoreOffer(&window, &workspace, &*keeper, std::move(left));
        if (first) {
            openFirst(window, workspace, arguments, folder);
        } else {
            window.takeLayout(layout);
            window.show();
            window.showLesson();
            window.findChild<reliefui::LessonMenu*>()->resume(std::move(lesson));
        }
        if (const std::string missing = reliefui::glProblem(); !missing.empty())
            Q_EMIT workspace.problem(QString::fromStdString(missing));
        status = QApplication::exec();
        lesson = window.findChild<reliefui::LessonMenu*>()->kept();
        layout = window.layoutNow();
        if (offer != nullptr) left = offer->unanswered();
        if (status != kOtherLanguage && keeper) {
            const std::string fault = keeper->end();
            if (!fault.empty()) std::fprintf(stderr, "reliefscope: %s\n", fault.c_str());
            window.keepLayout();
        }
        shown = nullptr;
        if (status == kOtherLanguage) {
            reliefui::installTranslations(reliefui::chosenLanguage());
            reliefui::Style style = workspace.style();
            style.language = reliefui::uiLanguage();
            workspace.setStyle(style);
        }
    }
    constexpr std::size_t kPauses = 20;
    if (arguments.log) std::fprintf(stderr, "%s\n", reliefui::PauseLog::instance().text(kPauses).toUtf8().constData());
    return status;
}

}  // namespace

}  // namespace relief::app

int main(int count, char** values) {
    using namespace relief::app;
    try {
        const Arguments arguments = parseArguments(count, values);
        if (arguments.help) {
            std::fputs(helpText(figureLines()).c_str(), stdout);
            return 0;
        }
        if (arguments.version) {
            std::puts("reliefscope " RELIEF_VERSION);
            return 0;
        }
        return run(count, values, arguments);
    } catch (const relief::WorkError& error) {
        std::fprintf(stderr, "reliefscope: %s\n", error.text(reliefui::uiLanguage()).c_str());
        return kWorkFailed;
    } catch (const relief::InputError& error) {
        std::fprintf(stderr, "reliefscope: %s\n", error.text(reliefui::uiLanguage()).c_str());
        return kBadUsage;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "reliefscope: %s\n", error.what());
        return 1;
    }
}
