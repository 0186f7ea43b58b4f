// The distance map's pane, opened on a relief with walls.
#pragma once

#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "relief/tracers/map_choice.h"
#include "window_fixture.h"

namespace reliefui {

inline constexpr int kDistancePatienceMs = 120000;

class DistanceTest : public WindowTest {
  protected:
    void openPane(const relief::Scenario& scenario) {
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_7);
        QTest::qWait(100);
        ASSERT_TRUE(view()->isVisible());
        ASSERT_NO_FATAL_FAILURE(settle());
        ASSERT_NE(view()->shown(), nullptr) << view()->problem().toStdString();
    }
    void settle() {
        // Work for a changed option starts at once; work for a new picture starts when that is ready.
        QTest::qWait(20);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view()->isUpToDate(); }, kDistancePatienceMs)) << "no map in time";
    }
    void show(const DistanceOptions& options) {
        view()->setOptions(options);
        ASSERT_NO_FATAL_FAILURE(settle());
    }
    DistanceView* view() { return window_->pane<DistanceView>(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
    template <class Widget>
    Widget* control(const char* name) {
        return view()->findChild<Widget*>(QString::fromLatin1(name));
    }
    relief::StoredMap map(const std::string& kind) {
        relief::Work work;
        relief::MapCache cache;
        DistanceOptions options;
        options.kind = kind;
        const MapOptions parsed = mapOptions(options, *snapshot()).front();
        return relief::buildMap(kind, parsed.options, snapshot()->request->field, cache, work);
    }
};

inline relief::Scenario walled(const char* method, relief::OptionValues options = {}) {
    relief::Scenario scenario = smallScenario();
    scenario.pictures.recipe = "city";
    scenario.reliefDepth = 0.2;
    scenario.camera.elevation = 20;
    scenario.method = {method, std::move(options)};
    return scenario;
}

}  // namespace reliefui
