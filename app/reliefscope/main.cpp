// The program `reliefscope`: the window. Everything that can be wrong with its arguments or its display is said in one
// line before a window opens.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QApplication>
#include <QFileInfo>

#include "arguments.h"
#include "measuring/bench/pareto.h"
#include "relief/errors.h"
#include "views/charts_data.h"
#include "views/compare_data.h"
#include "views/duel_data.h"
#include "views/figure.h"
#include "views/pane_options.h"
#include "windows/application.h"
#include "windows/display_check.h"
#include "windows/main_window.h"
#include "windows/program.h"
#include "windows/restore_offer.h"
#include "workspace/language.h"
#include "workspace/last_state.h"
#include "workspace/pane_states.h"
#include "workspace/pause_log.h"
#include "workspace/snapshot_maker.h"
#include "workspace/start_scenario.h"
#include "workspace/state_keeper.h"

namespace relief::app {

namespace {

constexpr int kWorkFailed = 1;
constexpr int kBadUsage = 2;

struct Start {
    Scenario scenario;
    AssetStore pictures;  // loaded already where they were named by the user
};

bool endsInJson(const std::string& path) {
    return std::filesystem::path(path).extension() == ".json";
}

Start chosenStart(const std::string& file, const std::string& datasets) {
    Start start;
    start.scenario = reliefui::startScenario(datasets);
    if (file.empty()) return start;
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    try {
        if (endsInJson(path)) {
            start.scenario = reliefui::loadWindowScenario(path);
        } else {
            start.scenario.pictures = {};
            start.scenario.pictures.height = path;
        }
        Work work;
        start.pictures.load(start.scenario.pictures, work);
    } catch (const InputError& error) {
        // As it was typed.
        if (error.subject() == path) throw InputError(file, error.message());
        throw;
    }
    return start;
}

// Where the last window left off, if nothing else is asked for.
Start startOfWindow(const Arguments& arguments, const std::string& datasets, reliefui::SessionFiles* session) {
    if (arguments.file.empty() && session != nullptr && !arguments.anew) {
        Start start;
        session->setStarting(true);
        if (const auto last = reliefui::lastState(start.pictures)) {
            start.scenario = *last;
            return start;
        }
    }
    return chosenStart(arguments.file, datasets);
}

// The folder of the shipped pictures.
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

// The chart of a table of `relief bench tracers`.
std::shared_ptr<const reliefui::ChartsSource> paretoChart(const Arguments& arguments) {
    auto source = std::make_shared<reliefui::ParetoSource>();
    if (!arguments.error.empty()) source->measure = parseErrorMeasure(arguments.error, "--error");
    source->table = paretoTable(chosenRows(readBenchJson(arguments.file), arguments.relief, arguments.elevation));
    source->title = reliefui::paretoTitle(source->table);
    auto charts = std::make_shared<reliefui::ChartsSource>();
    charts->shown = reliefui::ChartsShown::Pareto;
    charts->pareto = std::move(source);
    return charts;
}

// The charts pane, measured now.
std::shared_ptr<const reliefui::ChartsSource> measuredCharts(const reliefui::Snapshot& snapshot,
                                                             const Arguments& arguments) {
    ErrorMeasure measure = ErrorMeasure::Mean;
    if (!arguments.error.empty()) measure = parseErrorMeasure(arguments.error, "--error");
    Work work;
    auto charts = std::make_shared<reliefui::ChartsSource>();
    charts->histograms = reliefui::histogramsOf(snapshot, work);
    charts->chosenSteps = reliefui::chosenSteps(snapshot);
    // As the pane begins: building all maps of a large picture takes minutes.
    constexpr bool kWithMaps = false;
    charts->pareto = reliefui::paretoSource(snapshot, reliefui::measureView(snapshot, kWithMaps, work), measure);
    return charts;
}

// The compare pane, rendered and measured now; null where there is nothing to compare with.
std::shared_ptr<const reliefui::ComparedView> measuredComparison(const reliefui::Snapshot& snapshot) {
    if (snapshot.scenario.comparison.others.empty()) return nullptr;
    Work work;
    reliefui::Comparer comparer;
    return reliefui::withRates(*comparer.view(snapshot, work), snapshot, work);
}

reliefui::Layer chosenLayer(const std::string& name) {
    if (name.empty()) return reliefui::Layer::Color;
    // As relief render names them, in the order of reliefui::Layer.
    static const std::vector<std::string> kNames{"color",  "steps", "error",     "outcome", "depth",
                                                 "normal", "uv",    "footprint", "hidden"};
    const auto at = std::find(kNames.begin(), kNames.end(), name);
    if (at != kNames.end()) return static_cast<reliefui::Layer>(at - kNames.begin());
    throw InputError(
        "--layer", Message(MessageId::UnknownName, {{"what", "layer"}, {"name", name}, {"known", commaList(kNames)}}));
}

// What is asked for here stands before what the scenario says.
void takeArguments(reliefui::FigureRequest& request, const Arguments& arguments) {
    if (!arguments.map.empty()) request.distance.kind = arguments.map;
    if (!arguments.minus.empty()) request.distance.minus = arguments.minus;
    if (!arguments.axis.empty()) request.distance.axis = static_cast<reliefui::SliceAxis>(arguments.axis.front() - 'x');
    if (arguments.slice >= 0) request.distance.slice = arguments.slice;
    if (!arguments.variants.empty()) request.rows.methods = betweenCommas(arguments.variants);
    if (arguments.rowWidth > 0) request.rows.pixels = arguments.rowWidth;
}

// The duel pane, fought now, at the scenario's step.
void takeDuel(reliefui::FigureRequest& request, const std::shared_ptr<const reliefui::Snapshot>& snapshot) {
    if (!snapshot->trace.onRelief) return;
    Work work;
    request.duel = reliefui::makeDuel(snapshot, snapshot->scenario.comparison.others, work);
    const std::size_t own = snapshot->trace.fromFile ? request.duel->runs.size() - 1 : 0;
    const auto step = static_cast<std::size_t>(std::max(snapshot->scenario.step, 0));
    request.duelMoment = request.duel->steps.momentOf(own, step);
    if (request.duelMoment == request.duel->firstMoment()) request.duelUpTo = request.duel->closeUp();
    // What is chosen for the profile is not meant for it.
    request.profile = {};
    request.profile.levels = reliefui::LevelsShown::None;
    request.profile.nearRay = true;
}

int exportFigure(int count, char** values, const Arguments& arguments) {
    reliefui::FigureRequest request;
    request.view = arguments.figure;
    request.widthMm = arguments.widthMm;
    request.dpi = arguments.dpi;
    request.style.theme = arguments.dark ? reliefui::Theme::Dark : reliefui::Theme::Light;
    request.style.language = reliefui::uiLanguage();
    takeArguments(request, arguments);
    reliefui::checkFigure(request, arguments.output);
    if (request.view == "pareto") {
        request.charts = paretoChart(arguments);
        reliefui::prepareFigures();
        QApplication application(count, values);
        reliefui::dressApplication(application);
        reliefui::writeFigure({}, request, arguments.output);
        return 0;
    }
    Start start = chosenStart(arguments.file, shippedPictures());
    reliefui::takePanes(request, reliefui::panesOf(start.scenario));
    takeArguments(request, arguments);
    reliefui::prepareFigures();
    QApplication application(count, values);
    reliefui::dressApplication(application);
    reliefui::SnapshotMaker maker(std::move(start.pictures));
    reliefui::SnapshotOrder order;
    order.scenario = start.scenario;
    order.layer = chosenLayer(arguments.layer);
    Work work;
    const std::shared_ptr<const reliefui::Snapshot> snapshot = maker.make(order, work);
    if (request.view == "charts") request.charts = measuredCharts(*snapshot, arguments);
    if (request.view == "compare") request.compare = measuredComparison(*snapshot);
    if (request.view == "duel") takeDuel(request, snapshot);
    reliefui::writeFigure(*snapshot, request, arguments.output);
    return 0;
}

int run(int count, char** values, const Arguments& arguments) {
    if (!arguments.figure.empty()) return exportFigure(count, values, arguments);
    const std::string problem = reliefui::displayProblem();
    if (!problem.empty()) {
        std::fprintf(stderr, "relief: no window can be opened: %s\n", problem.c_str());
        return kBadUsage;
    }
    if (arguments.checkDisplay) return 0;
    const std::string datasets = shippedPictures();
    // A screenshot is no session.
    const bool shot = !arguments.screenshot.empty();
    std::optional<reliefui::SessionFiles> session;
    std::vector<reliefui::SessionFiles> left;
    if (!shot) session = reliefui::SessionFiles::begin();
    if (!shot && !arguments.anew) left = reliefui::SessionFiles::leftBehind();
    Start start = startOfWindow(arguments, datasets, session ? &*session : nullptr);

    reliefui::prepareWindows();
    reliefui::Application application(count, values);
    reliefui::dressApplication(application);
    QApplication::setApplicationVersion(QStringLiteral(RELIEF_VERSION));
    reliefui::Workspace workspace;
    // Reads and draws while the window is being made.
    workspace.start(start.scenario, std::move(start.pictures));
    reliefui::MainWindow window(&workspace, QString::fromStdString(datasets));
    if (!shot && arguments.width == 0 && !arguments.anew) window.restoreLayout();
    const double fine = window.devicePixelRatioF();
    if (arguments.width > 0) window.resize(qRound(arguments.width / fine), qRound(arguments.height / fine));
    if (shot) {
        reliefui::screenshotThenQuit(window, workspace, QString::fromStdString(arguments.screenshot));
    }
    window.show();
    // A lesson's pane comes to the front, when its pictures are there; a file is among the recent ones.
    const QString file = shot ? QString() : QString::fromStdString(arguments.file);
    auto first = std::make_shared<QMetaObject::Connection>();
    *first = QObject::connect(
        &workspace, &reliefui::Workspace::snapshotChanged, &window, [first, file, &window, &workspace] {
            QObject::disconnect(*first);
            file.isEmpty() ? window.showLesson() : workspace.opened(QFileInfo(file).absoluteFilePath());
        });
    std::optional<reliefui::StateKeeper> keeper;
    if (session) {
        keeper.emplace(&workspace, std::move(*session), start.scenario, [&window] { return window.layoutNow(); });
        QObject::connect(&*keeper, &reliefui::StateKeeper::problem, &workspace, &reliefui::Workspace::problem);
        new reliefui::RestoreOffer(&window, &workspace, &*keeper, std::move(left));
    }
    const int status = QApplication::exec();
    if (keeper) {
        const std::string fault = keeper->end();
        if (!fault.empty()) std::fprintf(stderr, "relief: %s\n", fault.c_str());
        window.keepLayout();
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
            std::fputs(helpText().c_str(), stdout);
            return 0;
        }
        if (arguments.version) {
            std::puts("reliefscope " RELIEF_VERSION);
            return 0;
        }
        return run(count, values, arguments);
    } catch (const relief::WorkError& error) {
        std::fprintf(stderr, "relief: %s\n", error.text(reliefui::uiLanguage()).c_str());
        return kWorkFailed;
    } catch (const relief::InputError& error) {
        std::fprintf(stderr, "relief: %s\n", error.text(reliefui::uiLanguage()).c_str());
        return kBadUsage;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "relief: %s\n", error.what());
        return 1;
    }
}
