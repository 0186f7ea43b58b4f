// The state of panes is part of the scenario: it can be undone, saved, and opened.
#include <QComboBox>
#include <QFile>
#include <QSlider>
#include <QTemporaryDir>

#include "panes/charts/charts_view.h"
#include "panes/distance/distance_figure.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/footprint/footprint_state.h"
#include "panes/footprint/footprint_view.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_parts.h"
#include "panes/pyramid/pyramid_stack.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/ray_geometry.h"
#include "panes/rows/rows_figure.h"
#include "panes/rows/rows_view.h"
#include "panes/trace/trace3d_view.h"
#include "scenario/step_sentence.h"
#include "window_fixture.h"
#include "workspace/pane_store.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {
namespace {

class PaneChoices : public WindowTest {
  protected:
    // Changes the state of every pane through the functions that its controls call.
    void turnAll() {
        DistanceOptions distance = window_->pane<DistanceView>()->options();
        distance.kind = "euclidean";
        distance.axis = SliceAxis::Z;
        distance.slice = 2;
        distance.isoLines = false;
        window_->pane<DistanceView>()->setOptions(distance);
        RowsOptions rows = window_->pane<RowsView>()->options();
        rows.methods = {"direct", "subspan:span=8"};
        rows.pixels = 3840;
        window_->pane<RowsView>()->setOptions(rows);
        window_->pane<FootprintView>()->setOptions({8});
        window_->pane<ProfileView>()->showAllLevels(true);
        window_->pane<ProfileView>()->setTrueAspect(true);
        window_->pane<PyramidView>()->showAllKinds();
        window_->pane<PyramidView>()->showNearRay(false);
        window_->pane<ChartsView>()->setShown(ChartsShown::Histograms);
        window_->pane<ChartsView>()->setMeasure(relief::ErrorMeasure::Max);
        window_->pane<ChartsView>()->setLive(false);
        window_->pane<Trace3dView>()->setExaggeration(2);
        window_->pane<Trace3dView>()->setColors(QStringLiteral("level"));
    }
    // Compares the panes' effective options with the scenario.
    void expectPanesAsTheScenarioSays() {
        const relief::Scenario& now = workspace_->scenario();
        const auto footprint = stateOf<FootprintPane>(now);
        const auto profile = stateOf<ProfilePane>(now);
        EXPECT_EQ(window_->pane<DistanceView>()->options(), distanceOptions(stateOf<DistancePane>(now)));
        EXPECT_EQ(window_->pane<RowsView>()->options(), rowsOptions(stateOf<RowsPane>(now)));
        EXPECT_EQ(window_->pane<FootprintView>()->options().neighbours, footprint.neighbours);
        EXPECT_EQ(window_->pane<FootprintView>()->options().weights, footprint.weights);
        EXPECT_EQ(window_->pane<ProfileView>()->options().levels == LevelsShown::All, profile.allLevels);
        EXPECT_EQ(window_->pane<ProfileView>()->options().trueAspect, profile.trueAspect);
        const auto* const colors = window_->pane<Trace3dView>()->findChild<QComboBox*>(QStringLiteral("trace-colors"));
        EXPECT_EQ(colors->currentData().toString().toStdString(), stateOf<TracePane>(now).colors);
        EXPECT_EQ(window_->pane<PyramidView>()->parts().size(), stateOf<PyramidPane>(now).levels == "all" ? 3U : 1U);
    }
};

TEST_F(PaneChoices, TheyAreUndoneAndRedone) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    const auto picture = snapshot()->picture;
    turnAll();
    const relief::Scenario after = scenario();
    EXPECT_NE(stateOf<DistancePane>(after), stateOf<DistancePane>(before));
    EXPECT_NE(stateOf<RowsPane>(after), stateOf<RowsPane>(before));
    EXPECT_NE(stateOf<FootprintPane>(after), stateOf<FootprintPane>(before));
    EXPECT_NE(stateOf<ProfilePane>(after), stateOf<ProfilePane>(before));
    EXPECT_NE(stateOf<PyramidPane>(after), stateOf<PyramidPane>(before));
    EXPECT_NE(stateOf<ChartsPane>(after), stateOf<ChartsPane>(before));
    EXPECT_NE(stateOf<TracePane>(after), stateOf<TracePane>(before));
    expectPanesAsTheScenarioSays();
    while (workspace_->canUndo()) workspace_->undo();
    EXPECT_EQ(scenario(), before);
    expectPanesAsTheScenarioSays();
    EXPECT_EQ(snapshot()->picture, picture) << "nothing was rendered";
    while (workspace_->canRedo()) workspace_->redo();
    EXPECT_EQ(scenario(), after);
    expectPanesAsTheScenarioSays();
}

TEST_F(PaneChoices, SavedAndOpenedTheyAreTheSame) {
    openWindow(smallScenario());
    turnAll();
    const relief::Scenario saved = scenario();
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("panes.json"));
    workspace_->save(file);
    while (workspace_->canUndo()) workspace_->undo();
    ASSERT_NE(scenario(), saved);
    workspace_->open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == saved; }, 5000));
    waitForFull();
    expectPanesAsTheScenarioSays();
    // An unknown name: an error with the line number is shown, and nothing changes.
    QFile text(file);
    ASSERT_TRUE(text.open(QIODevice::ReadWrite));
    QByteArray bytes = text.readAll();
    ASSERT_TRUE(bytes.contains("\"all\""));
    bytes.replace("\"all\"", "\"alle\"");
    text.resize(0);
    text.seek(0);
    text.write(bytes);
    text.close();
    QString problem;
    QObject::connect(workspace_.get(), &Workspace::problem, [&](const QString& said) { problem = said; });
    workspace_->open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !problem.isEmpty(); }, 5000));
    EXPECT_TRUE(problem.contains(QStringLiteral("alle")) && problem.contains(QStringLiteral("line")))
        << problem.toStdString();
    EXPECT_EQ(scenario(), saved);
}

// Dragging a slider is one step of undo.
TEST_F(PaneChoices, ADragIsOneStepOfUndo) {
    openWindow(smallScenario());
    window_->pane<DistanceView>()->window()->findChild<QWidget*>(QStringLiteral("distance-pane"))->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_->pane<DistanceView>()->isUpToDate(); }, 10000));
    const relief::Scenario before = scenario();
    auto* const slider = window_->pane<DistanceView>()->findChild<QSlider*>(QStringLiteral("distance-slice"));
    ASSERT_NE(slider, nullptr);
    ASSERT_GT(slider->maximum(), 3);
    const int start = slider->value() > 2 ? 0 : 2;
    for (int slice = start; slice < start + 2; ++slice) {
        slider->setValue(slice);
        QTest::qWait(20);
    }
    EXPECT_EQ(stateOf<DistancePane>(scenario()).slice, start + 1);
    workspace_->undo();
    EXPECT_EQ(stateOf<DistancePane>(scenario()), stateOf<DistancePane>(before));
}

// Probes as in the flat pane, on slabs: texels have the colours of their heights, and a click chooses the step.
TEST_F(PaneChoices, ThePyramidStandsInSpace) {
    relief::Scenario columns = smallScenario();
    columns.surface = relief::Surface::Columns;
    openWindow(columns);
    PyramidView* const view = window_->pane<PyramidView>();
    view->showNearRay(false);
    view->showMeans(true);  // the mean pyramid shows all its slabs
    view->setStacked(true);
    const QImage shown = grab(view->stack());
    EXPECT_GT(colorsIn(shown), 30);
    ASSERT_NE(snapshot()->means, nullptr);
    const relief::Pyramid& pyramid = *snapshot()->means;
    int probes = 0;
    int right = 0;
    // The uppermost slabs hide parts of those below.
    for (int level = pyramid.levels() - 2; level >= std::max(0, pyramid.levels() - 4); --level) {
        const relief::FloatImage& image = pyramid.level(level);
        const double side = std::ldexp(1.0, level);
        for (int j = 0; j < image.height(); ++j) {
            for (int i = 0; i < image.width(); ++i) {
                const Point texel{(i + 0.3) * side, (j + 0.3) * side};
                const QPointF at = view->stack()->toWidget(0, level, texel);
                Point drawing;
                if (!shown.valid(at.toPoint()) || !view->stack()->drawingAt(at, drawing)) continue;
                const Point expected = view->blocks()[static_cast<std::size_t>(level)].toDrawing(texel);
                // Hidden by a slab above it.
                if (std::abs(expected.x - drawing.x) > 1 || std::abs(expected.y - drawing.y) > 1) continue;
                const Rgba color =
                    workspace_->style().cell(ColorMap::Height, static_cast<double>(image(i, j)), view->heights().scale);
                const QColor seen = shown.pixelColor(at.toPoint());
                ++probes;
                const int off = std::max({std::abs(seen.red() - color.r), std::abs(seen.green() - color.g),
                                          std::abs(seen.blue() - color.b)});
                if (off <= 8) ++right;
            }
        }
    }
    ASSERT_GT(probes, 30);
    // The marks of the steps cover some.
    EXPECT_GT(right, probes * 7 / 10) << right << " of " << probes;
}

TEST_F(PaneChoices, AClickOnASlabChoosesTheStep) {
    openWindow(smallScenario());
    PyramidView* const view = window_->pane<PyramidView>();
    view->setStacked(true);
    grab(view->stack());
    const auto& steps = snapshot()->trace.steps;
    ASSERT_GT(steps.size(), 3U);
    int clicked = 0;
    for (std::size_t k = 0; k < steps.size() && clicked < 3; ++k) {
        const relief::Step& step = steps[k];
        if (step.level < 1 || step.as<relief::subject::Texel>() == nullptr) continue;
        const Box box = stepBox(snapshot()->request->field, step, snapshot()->trace.baseLevel);
        const LevelBlock& block = view->blocks()[static_cast<std::size_t>(step.level)];
        const Box seen = box.cut(block.domain);
        if (seen.empty()) continue;
        const QPointF at = view->stack()->toWidget(0, step.level, seen.center());
        const Point expected = block.toDrawing(seen.center());
        Point drawing;
        if (!view->stack()->drawingAt(at, drawing)) continue;
        // Hidden by a slab above it.
        if (std::abs(expected.x - drawing.x) > 1 || std::abs(expected.y - drawing.y) > 1) continue;
        workspace_->chooseStep(static_cast<int>(k == 0 ? 1 : 0));
        QTest::mouseClick(view->stack()->focusProxy(), Qt::LeftButton, {}, at.toPoint());
        const relief::Step& now = steps[static_cast<std::size_t>(scenario().step)];
        EXPECT_TRUE(now.level == step.level && now.i == step.i && now.j == step.j) << k;
        ++clicked;
    }
    EXPECT_GT(clicked, 0);
}

TEST_F(PaneChoices, AllThreePyramidsStandBesideEachOther) {
    openWindow(smallScenario());
    PyramidView* const view = window_->pane<PyramidView>();
    view->showAllKinds();
    grab(view->canvas());
    ASSERT_EQ(view->parts().size(), 3U);
    const std::array<const relief::Pyramid*, 3> pyramids{&snapshot()->maxima->pyramid, snapshot()->means.get(),
                                                         snapshot()->minima.get()};
    for (std::size_t n = 0; n < 3; ++n) {
        const PyramidPart& part = view->parts()[n];
        EXPECT_EQ(part.source.pyramid->kind(), pyramids[n]->kind());
        // The coarsest texel has a single colour; its readout is the right value.
        const LevelBlock& block = part.picture.blocks.back();
        const Point middle = block.box.center();
        const auto value = static_cast<double>(pyramids[n]->level(block.level)(0, 0));
        EXPECT_TRUE(view->reading(middle).contains(QString::fromStdString(relief::fixedText(value, 3))))
            << view->reading(middle).toStdString();
        const Rgba color = workspace_->style().cell(ColorMap::Height, value, view->heights().scale);
        // Zoomed in; marks of steps and the number cover parts of it.
        view->canvas()->zoomTo(block.box);
        const QImage shown = grab(view->canvas());
        int same = 0;
        for (int at = 0; at < 81; ++at) {
            const Point probe{block.box.x0 + (at % 9 + 0.5) / 9 * block.box.width(),
                              block.box.y0 + (at / 9 + 0.5) / 9 * block.box.height()};
            const QColor seen = shown.pixelColor(view->canvas()->toWidget(probe).toPoint());
            if (std::abs(seen.red() - color.r) <= 8 && std::abs(seen.blue() - color.b) <= 8) ++same;
        }
        EXPECT_GT(same, 20) << n;
    }
}

// The box of a voxel that covers two cells per side covers these cells, not the cells with the voxel's own indices.
TEST(PyramidMarks, VoxelsLieOverTheirCells) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"distance-conservative", {{"footprint", "2"}, {"layers", "64"}}};
    scenario.camera.elevation = 12;
    SnapshotMaker maker;
    relief::Work work;
    SnapshotOrder order;
    int voxels = 0;
    for (int x = 20; x < scenario.width; x += 20) {
        scenario.pixel = relief::PixelChoice{x, scenario.height / 2};
        order.scenario = scenario;
        const auto made = maker.make(order, work);
        const PyramidSource source = pyramidSource(*made, {relief::PyramidKind::Max, false});
        const RayPath path(made->request->field, made->trace.ray);
        for (const relief::Step& step : made->trace.steps) {
            if (!liesInVoxel(step)) continue;
            ++voxels;
            const Box box = stepBox(made->request->field, step);
            EXPECT_NEAR(box.width(), 2, 1e-9);
            const Point at = path.at(std::clamp(step.lambdaIn, 0.0, 1.0));
            constexpr double kRounding = 1e-6;
            EXPECT_TRUE(box.grown(kRounding).contains(at))
                << at.x << " " << at.y << " not in " << box.x0 << " " << box.y0;
        }
    }
    EXPECT_GT(voxels, 5);
}

}  // namespace
}  // namespace reliefui
