// Runs a typical session in the window, operated as by a person, and reports what blocked the window's thread: for each
// part of the session the longest computation of ours in one event, and the longest pause including painting.
//
//    relief_window_pauses [--picture FILE | --recipe NAME --size N] [--only 1|2|3]
#include <cstdio>
#include <string>

#include <QComboBox>
#include <QDockWidget>
#include <QTest>

#include "panes/charts/charts_view.h"
#include "panes/compare/compare_view.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/drawn/drawn_view.h"
#include "panes/duel/duel_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/result/result_view.h"
#include "scenario/comparison.h"
#include "windows/application.h"
#include "windows/display_check.h"
#include "windows/main_window.h"
#include "windows/program.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"
#include "workspace/pause_log.h"
#include "workspace/start_scenario.h"

namespace {

using reliefui::PauseLog;

constexpr int kPatienceMs = 120000;
constexpr int kRestMs = 600;
constexpr int kFiguresMs = 2000;
constexpr std::size_t kListed = 3;
constexpr int kLargest = 2048;

class Session {
  public:
    Session(reliefui::Workspace& workspace, reliefui::MainWindow& window) : workspace_(workspace), window_(window) {}

    void wait() const {
        QTest::qWait(100);
        if (!QTest::qWaitFor([&] { return workspace_.snapshot() && !workspace_.busy(); }, kPatienceMs)) {
            std::printf("  (no picture in time)\n");
        }
        QTest::qWait(kRestMs);
    }
    template <class Action>
    void part(const char* name, const Action& action) {
        PauseLog::instance().clear();
        action();
        wait();
        const PauseLog& log = PauseLog::instance();
        std::printf("%-34s ours %6.1f ms, pause %7.1f ms (%.1f drawing)\n", name, log.longestComputation().computed(),
                    log.longestGap().ms, log.longestGap().drawing);
        for (const PauseLog::Pause& pause : log.worst(kListed)) {
            std::printf("      %6.1f of %6.1f ms x %d  %s\n", pause.computed(), pause.ms, pause.times,
                        pause.what.toUtf8().constData());
        }
        std::fflush(stdout);
    }
    template <class Change>
    void change(const Change& change, bool live = false) const {
        relief::Scenario scenario = workspace_.scenario();
        change(scenario);
        workspace_.change(scenario, QStringLiteral("change"), live ? QStringLiteral("drag") : QString(), live);
    }
    void pane(const char* name, const char* says) {
        part(says, [&] {
            auto* const dock = window_.findChild<QDockWidget*>(QString::fromLatin1(name));
            dock->show();
            dock->raise();
        });
    }
    void step() {
        part("stepping through the ray", [&] {
            window_.time()->bar()->first();
            const auto steps = static_cast<int>(workspace_.snapshot()->trace.steps.size());
            for (int k = 0; k < std::min(steps, 40); ++k) {
                window_.time()->bar()->next();
                QTest::qWait(30);
            }
        });
    }
    void orbit() {
        part("camera moved by the mouse", [&] {
            auto* const result = window_.result();
            const QPoint middle = result->rect().center();
            QTest::mousePress(result, Qt::LeftButton, {}, middle);
            for (int k = 1; k < 40; ++k) {
                QMouseEvent move(QEvent::MouseMove, middle + QPoint(4 * k, k), Qt::NoButton, Qt::LeftButton, {});
                QCoreApplication::sendEvent(result, &move);
                QTest::qWait(30);
            }
            QTest::mouseRelease(result, Qt::LeftButton, {}, middle + QPoint(160, 40));
        });
    }
    // only: 1 methods, 2 a long ray, 3 panes; 0: all.
    void all(int only) {
        part("first picture", [] {});
        const relief::PixelChoice pixel = *workspace_.scenario().pixel;
        const relief::Camera camera = workspace_.scenario().camera;
        if (only == 0 || only == 1) methods(pixel);
        if (only == 0 || only == 2) longRay(pixel, camera);
        if (only == 0 || only == 3) panes();
    }
    void methods(relief::PixelChoice pixel) {
        step();
        orbit();
        part("other pixels", [&] {
            for (int k = 0; k < 5; ++k) {
                workspace_.choosePixel(100 + 130 * k, 120 + 90 * k);
                wait();
            }
            workspace_.choosePixel(pixel.x, pixel.y);
        });
        // Distance maps of large pictures take minutes to build.
        const bool large = workspace_.scenario().pictures.recipeWidth > kLargest;
        for (const char* method : {"cone", "layers", "distance", "distance-refined", "exact", "max-pyramid"}) {
            if (large && std::string(method).starts_with("distance")) continue;
            part((std::string("method ") + method).c_str(), [&] {
                change([&](relief::Scenario& s) { s.method = {method, {}}; });
            });
        }
        part("filter", [&] { change([](relief::Scenario& s) { s.filter.name = "elliptical"; }); });
        part("depth, dragged", [&] {
            for (int k = 0; k < 10; ++k) {
                change([&](relief::Scenario& s) { s.reliefDepth = 0.05 + 0.01 * k; }, true);
                QTest::qWait(40);
            }
            workspace_.finishInteraction();
        });
    }
    void longRay(relief::PixelChoice pixel, const relief::Camera& camera) {
        part("a long ray", [&] {
            change([](relief::Scenario& s) {
                s.method = {"exact", {}};
                s.camera.elevation = 3;
                s.camera.azimuth = 0;
                s.reliefDepth = 0.2;
            });
        });
        // Selects the pixel with the most steps out of some.
        std::size_t most = 0;
        relief::PixelChoice longest = pixel;
        for (int y = 20; y < workspace_.scenario().height; y += 45) {
            workspace_.choosePixel(400, y);
            wait();
            if (workspace_.snapshot()->trace.steps.size() <= most) continue;
            most = workspace_.snapshot()->trace.steps.size();
            longest = *workspace_.scenario().pixel;
        }
        part("its pixel", [&] { workspace_.choosePixel(longest.x, longest.y); });
        std::printf("      %zu steps\n", most);
        step();
        pane("profile-pane", "a long ray: profile");
        pane("distance-pane", "a long ray: distance");
        pane("duel-pane", "a long ray: duel");
        pane("pyramid-pane", "a long ray: pyramid");
        part("back", [&] {
            change([&](relief::Scenario& s) {
                s.method = {"max-pyramid", {}};
                s.camera = camera;
                s.pixel = pixel;
            });
        });
    }
    void panes() {
        pane("profile-pane", "pane profile");
        step();
        pane("distance-pane", "pane distance map");
        if (workspace_.scenario().pictures.recipeWidth <= kLargest)
            part("distance: refined map", [&] {
                reliefui::DistanceOptions options = window_.pane<reliefui::DistanceView>()->options();
                options.kind = "refined";
                window_.pane<reliefui::DistanceView>()->setOptions(options);
                wait();
                static_cast<void>(
                    QTest::qWaitFor([&] { return window_.pane<reliefui::DistanceView>()->isUpToDate(); }, kPatienceMs));
            });
        step();
        pane("footprint-pane", "pane footprint");
        orbit();
        pane("rows-pane", "pane rows");
        pane("charts-pane", "pane charts");
        part("charts: other view", [&] {
            change([](relief::Scenario& s) { s.camera.azimuth += 5; });
            QTest::qWait(3000);
        });
        pane("pyramid-pane", "pane pyramid");
        part("pyramid: means, all of it", [&] {
            window_.pane<reliefui::PyramidView>()->showNearRay(false);
            window_.pane<reliefui::PyramidView>()->showMeans(true);
        });
        part("pyramid: minima", [&] { window_.pane<reliefui::PyramidView>()->showMinima(); });
        step();
        pane("duel-pane", "pane duel");
        QTest::qWait(2000);
        step();
        pane("compare-pane", "pane compare");
        part("compare: more methods", [&] {
            change([](relief::Scenario& s) { s.comparison.others = {{"cone", {}}, {"layers", {}}, {"offset", {}}}; });
            QTest::qWait(3000);
        });
        orbit();
        for (const relief::CompareMode mode : {relief::CompareMode::Swipe, relief::CompareMode::Difference}) {
            part("compare: another mode", [&] { change([&](relief::Scenario& s) { s.comparison.mode = mode; }); });
        }
        part("layers of the result", [&] {
            for (int layer = 1; layer < reliefui::kLayers; ++layer) {
                workspace_.setLayer(static_cast<reliefui::Layer>(layer));
                wait();
            }
            workspace_.setLayer(reliefui::Layer::Color);
        });
        part("figures of the panes", [&] {
            for (reliefui::FigureView* const view : window_.findChildren<reliefui::FigureView*>()) {
                QMetaObject::invokeMethod(
                    view, [view] { view->copyPicture(); }, Qt::QueuedConnection);
            }
            QTest::qWait(kFiguresMs);
        });
        pane("drawn-pane", "pane by hand");
    }

  private:
    reliefui::Workspace& workspace_;
    reliefui::MainWindow& window_;
};

}  // namespace

int main(int count, char** values) {
    relief::Scenario scenario = reliefui::startScenario(RELIEF_DATASETS);
    int only = 0;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = values[i];
        if (name == "--picture") {
            scenario.pictures = {};
            scenario.pictures.height = values[i + 1];
        } else if (name == "--only") {
            only = std::stoi(values[i + 1]);
        } else if (name == "--recipe" || name == "--size") {
            if (scenario.pictures.recipe.empty()) {
                scenario.pictures = {};
                scenario.pictures.recipe = "fractal";
            }
            if (name == "--recipe") scenario.pictures.recipe = values[i + 1];
            if (name == "--size")
                scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = std::stoi(values[i + 1]);
        } else {
            std::fprintf(stderr, "relief_window_pauses [--picture FILE | --recipe NAME --size N] [--only 1|2|3]\n");
            return 2;
        }
    }
    std::string problem = reliefui::displayProblem();
    if (problem.empty()) problem = reliefui::glProblem();
    if (!problem.empty()) {
        std::fprintf(stderr, "no window: %s\n", problem.c_str());
        return 2;
    }
    reliefui::prepareWindows();
    reliefui::Application application(count, values);
    reliefui::setUpApplication(application);
    reliefui::Workspace workspace;
    workspace.start(scenario);
    reliefui::MainWindow window(&workspace, QString());
    window.show();
    QObject::connect(&workspace, &reliefui::Workspace::problem,
                     [](const QString& text) { std::printf("  problem: %s\n", text.toUtf8().constData()); });
    Session(workspace, window).all(only);
    return 0;
}
