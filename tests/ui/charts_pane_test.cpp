// The charts' pane, operated as by a person.
#include <QTemporaryDir>
#include <QToolButton>

#include "measuring/bench/measured_method.h"
#include "panes/charts/charts_drawing.h"
#include "panes/charts/charts_view.h"
#include "panes/drawing_canvas.h"
#include "rendering/error_layer.h"
#include "scenario/scenario.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

class ChartsPane : public WindowTest {
  protected:
    void openPane(const std::string& method = "layers") {
        relief::Scenario scenario = smallScenario();
        scenario.method = {method, {}};
        scenario.camera.elevation = 30;
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_0);
        settle();
        ASSERT_NE(view()->measured(), nullptr);
    }
    void settle() {
        QTest::qWait(100);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view()->isUpToDate() && !workspace_->busy(); }, kPatienceMs));
    }
    ChartsView* view() { return window_->pane<ChartsView>(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
    std::size_t pointOf(const std::string& name) {
        const auto& points = view()->measured()->table.points;
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (points[p].name == name) return p;
        }
        ADD_FAILURE() << name << " was not measured";
        return 0;
    }
};

TEST_F(ChartsPane, ItMeasuresTheViewAndCountsTheFrame) {
    openPane();
    EXPECT_GT(colorsIn(grab(canvas())), 50);
    const MeasuredView& measured = *view()->measured();
    EXPECT_TRUE(measured.of(*snapshot()));
    EXPECT_GT(measured.rays, 1000u);
    for (const char* const name : {"exact", "max-pyramid", "layers", "offset"}) pointOf(name);
    EXPECT_EQ(measured.table.points[pointOf("max-pyramid")].error[3], 0);
    EXPECT_GT(measured.table.points[pointOf("layers")].error[0], 0);

    // The histograms agree with the frame's error layer.
    const relief::FrameHistograms& counted = *view()->histograms();
    relief::Work work;
    const relief::ErrorLayer error =
        relief::errorAgainstExact(*snapshot()->frame, *snapshot()->request, *snapshot()->maps, work);
    std::int64_t steps = 0, before = 0, behind = 0;
    for (const std::int64_t rays : counted.steps) steps += rays;
    for (const std::int64_t rays : counted.before) before += rays;
    for (const std::int64_t rays : counted.behind) behind += rays;
    EXPECT_EQ(steps, counted.rays);
    EXPECT_EQ(before, error.counts[static_cast<std::size_t>(relief::ErrorKind::Short)]);
    EXPECT_EQ(behind, error.counts[static_cast<std::size_t>(relief::ErrorKind::Past)]);
    EXPECT_EQ(before + behind + counted.exact + counted.wrong, counted.rays);
    EXPECT_EQ(counted.largest, error.largest);
}

TEST_F(ChartsPane, AClickOnAMarkChoosesTheMethodAndItsWorstPixel) {
    openPane("max-pyramid");
    const std::size_t offset = pointOf("offset");
    const Point at = view()->picture().pareto->marks[offset].at;
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, canvas()->toWidget(at).toPoint());
    settle();
    waitForFull();
    settle();
    EXPECT_EQ(scenario().method.name, "offset");
    relief::Work work;
    const relief::ErrorLayer error =
        relief::errorAgainstExact(*snapshot()->frame, *snapshot()->request, *snapshot()->maps, work);
    ASSERT_TRUE(scenario().pixel);
    const float chosen = error.texels[snapshot()->frame->index(scenario().pixel->x, scenario().pixel->y)];
    float most = 0;
    for (const float texels : error.texels) most = std::max(most, texels);
    EXPECT_GT(most, 0);
    EXPECT_EQ(chosen, most);
    // The measurement is still that of the same rays, and one undo reverts both changes.
    EXPECT_TRUE(view()->measured()->of(*snapshot()));
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario().method.name, "max-pyramid");
    EXPECT_EQ(scenario().pixel, smallScenario().pixel);
}

TEST_F(ChartsPane, HoverReadsSpeedWithItsError) {
    openPane();
    const Point at = view()->picture().pareto->marks[pointOf("offset")].at;
    QTest::mouseMove(canvas(), canvas()->toWidget(at).toPoint());
    QTest::qWait(50);
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("offset (simd): "))) << view()->readout().toStdString();
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("error"))) << view()->readout().toStdString();
}

TEST_F(ChartsPane, MeasuringIsCancelledAndFollowsTheView) {
    openPane();
    // Building the maps of many methods takes long enough to cancel.
    view()->setWithMaps(true);
    ASSERT_FALSE(view()->isUpToDate());
    view()->cancel();
    settle();
    EXPECT_FALSE(view()->measured()->withMaps);
    EXPECT_FALSE(view()->findChild<QToolButton*>(QStringLiteral("charts-live"))->isChecked());
    view()->setWithMaps(false);

    relief::Scenario other = scenario();
    other.camera.elevation = 60;
    workspace_->change(other, QStringLiteral("other"));
    waitForFull();
    settle();
    EXPECT_FALSE(view()->measured()->of(*snapshot())) << "not live";
    view()->setLive(true);
    settle();
    EXPECT_TRUE(view()->measured()->of(*snapshot()));
    EXPECT_TRUE(view()->picture().steps);
    // Histograms of the picture before are not shown: if counting is cancelled, there are none, nor is there a figure.
    view()->setLive(false);
    const auto stop =
        QObject::connect(workspace_.get(), &Workspace::snapshotChanged, window_.get(), [this] { view()->cancel(); });
    other = scenario();
    other.method = {"layers", {{"layers", "64"}}};
    workspace_->change(other, QStringLiteral("other"));
    waitForFull();
    settle();
    QObject::disconnect(stop);
    EXPECT_FALSE(view()->picture().steps);
    EXPECT_TRUE(view()->image(100).isNull());
    view()->setShown(ChartsShown::Pareto);
    EXPECT_FALSE(view()->image(100).isNull()) << "this chart needs no counting";
    view()->setShown(ChartsShown::All);
    view()->measure();
    settle();
    EXPECT_TRUE(view()->picture().steps) << "counted after the measurement";
}

TEST_F(ChartsPane, ItIsExportedAsItIsShown) {
    openPane();
    const QTemporaryDir folder;
    for (const char* const ending : {"svg", "pdf", "png"}) {
        const QString file = folder.filePath(QStringLiteral("charts.") + QString::fromLatin1(ending));
        saveFigure(view(), file);
        EXPECT_TRUE(validFigure(file)) << ending;
    }
    EXPECT_GT(colorsIn(view()->image(800)), 20);
}

}  // namespace

}  // namespace reliefui
