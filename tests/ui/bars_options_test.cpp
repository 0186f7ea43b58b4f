// A click on a bar of a histogram chooses one of its pixels; options of compared methods are changed in the compare
// pane.
#include <QComboBox>
#include <QToolButton>

#include "measuring/bench/view_bench.h"
#include "panes/charts/charts_state.h"
#include "panes/charts/charts_view.h"
#include "panes/compare/compare_view.h"
#include "panes/drawing_canvas.h"
#include "panes/number_control.h"
#include "window_fixture.h"
#include "workspace/pane_store.h"

namespace reliefui {
namespace {

constexpr int kPatienceMs = 60000;

class BarsAndOptions : public WindowTest {
  protected:
    template <class View>
    void settle(View* view) {
        QTest::qWait(100);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view->isUpToDate() && !workspace_->busy(); }, kPatienceMs));
    }
    const HistogramBar* fullest(const HistogramPicture& picture, BarKind kind) {
        const HistogramBar* most = nullptr;
        for (const HistogramBar& bar : picture.bars) {
            if (bar.kind == kind && bar.rays > 1 && (most == nullptr || bar.rays > most->rays)) most = &bar;
        }
        return most;
    }
    void click(const HistogramBar& bar) {
        DrawingCanvas* const canvas = window_->pane<ChartsView>()->canvas();
        const QPoint at = canvas->toWidget(bar.box.center()).toPoint();
        QTest::mouseMove(canvas, at);
        QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
        settle(window_->pane<ChartsView>());
        waitForFull();
        settle(window_->pane<ChartsView>());
    }
};

TEST_F(BarsAndOptions, AClickOnABarChoosesOneOfItsPixels) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    setState(scenario, ChartsPane{"histograms", "mean", false, false});
    openWindow(scenario);
    QTest::keyClick(window_.get(), Qt::Key_0);
    ChartsView* const view = window_->pane<ChartsView>();
    settle(view);
    ASSERT_TRUE(view->picture().errors && view->picture().steps);
    relief::Work work;
    const relief::ErrorLayer error =
        relief::errorAgainstExact(*snapshot()->frame, *snapshot()->request, *snapshot()->maps, work);
    const HistogramBar* const before = fullest(*view->picture().errors, BarKind::Before);
    const HistogramBar* const behind = fullest(*view->picture().errors, BarKind::Behind);
    const HistogramBar* const bar = before != nullptr ? before : behind;
    ASSERT_NE(bar, nullptr);
    const HistogramBar clicked = *bar;  // a copy: the picture is rendered again
    // The bar's whole list of pixels is compared with the layer.
    const relief::HistogramBin bin{static_cast<relief::HistogramPart>(clicked.kind), clicked.bin};
    const std::vector<relief::PixelPlace> all =
        relief::pixelsOfBin(*snapshot()->frame, *snapshot()->request, *snapshot()->tracer, *view->histograms(), bin,
                            *snapshot()->maps, work);
    ASSERT_EQ(static_cast<std::int64_t>(all.size()), clicked.rays);
    float last = std::numeric_limits<float>::infinity();
    for (const relief::PixelPlace& place : all) {
        const float texels = error.texels[snapshot()->frame->index(place.x, place.y)];
        EXPECT_LE(texels, last);
        last = texels;
    }
    click(clicked);
    ASSERT_TRUE(this->scenario().pixel);
    EXPECT_EQ(this->scenario().pixel->x, all[0].x);
    EXPECT_EQ(this->scenario().pixel->y, all[0].y);
    EXPECT_TRUE(snapshot()->trace.onRelief) << "the panes answer for it";
    click(clicked);
    EXPECT_EQ(this->scenario().pixel->x, all[1].x);
    EXPECT_EQ(this->scenario().pixel->y, all[1].y);
    EXPECT_TRUE(view->readout().contains(QString::number(clicked.rays))) << view->readout().toStdString();
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(this->scenario().pixel->x, all[0].x);
}

TEST_F(BarsAndOptions, ABarOfStepsChoosesARayOfSoMany) {
    relief::Scenario scenario = smallScenario();
    setState(scenario, ChartsPane{"histograms", "mean", false, false});
    openWindow(scenario);
    QTest::keyClick(window_.get(), Qt::Key_0);
    ChartsView* const view = window_->pane<ChartsView>();
    settle(view);
    const HistogramBar* const bar = fullest(*view->picture().steps, BarKind::Steps);
    ASSERT_NE(bar, nullptr);
    const HistogramBar clicked = *bar;
    click(clicked);
    const auto steps = static_cast<double>(snapshot()->trace.steps.size());
    EXPECT_GE(steps, clicked.low);
    EXPECT_LT(steps, clicked.high);
}

TEST_F(BarsAndOptions, OptionsOfAllComparedMethodsAreTurned) {
    relief::Scenario scenario = smallScenario();
    scenario.comparison.others = {{"layers", {{"layers", "8"}}}, {"cone", {}}};
    openWindow(scenario);
    QTest::keyClick(window_.get(), Qt::Key_1, Qt::AltModifier);
    CompareView* const pane = window_->pane<CompareView>();
    settle(pane);
    auto* const button = pane->findChild<QToolButton*>(QStringLiteral("compare-options"));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    auto* const options = pane->findChild<QWidget*>(QStringLiteral("compare-options-B"));
    ASSERT_NE(options, nullptr);
    EXPECT_TRUE(options->isVisible());
    EXPECT_FALSE(pane->findChild<QWidget*>(QStringLiteral("compare-options-D"))->isVisible()) << "there are three";
    // There is a control for each option of the descriptions.
    for (const relief::OptionDescription& option : relief::findTracer("layers").options) {
        EXPECT_NE(options->findChild<QWidget*>(QString::fromStdString(option.name)), nullptr) << option.name;
    }
    auto* const layers = options->findChild<NumberControl*>(QStringLiteral("layers"));
    ASSERT_NE(layers, nullptr);
    const QImage before = pane->view()->pictures[1].picture;
    const QImage own = snapshot()->picture;
    Q_EMIT layers->changed(3, false);
    settle(pane);
    EXPECT_EQ(this->scenario().comparison.others[0].options.at("layers"), "3");
    EXPECT_EQ(pane->view()->pictures[1].choice.options.at("layers"), "3");
    EXPECT_NE(pane->view()->pictures[1].picture, before);
    EXPECT_EQ(snapshot()->picture, own) << "B alone";
    workspace_->undo();
    settle(pane);
    EXPECT_EQ(this->scenario().comparison.others[0].options.at("layers"), "8");
    EXPECT_EQ(pane->view()->pictures[1].picture, before);
}

}  // namespace
}  // namespace reliefui
