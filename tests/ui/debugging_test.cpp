// Debugging a tracer: conditions of breakpoints, watched values, why a pixel has its colour, columns of other programs.
#include <fstream>

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include "panes/drawing_canvas.h"
#include "panes/figure_caption.h"
#include "panes/formula/formula_view.h"
#include "panes/profile/profile_view.h"
#include "panes/steps/step_table.h"
#include "panes/steps/steps_figure.h"
#include "panes/watch/watch_view.h"
#include "panes/why/why_view.h"
#include "scenario/ray_files.h"
#include "window_fixture.h"
#include "windows/breakpoint_bar.h"
#include "windows/other_bar.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

constexpr int kCondition = 5;  // in the list of kinds

class DebuggingTest : public WindowTest {
  protected:
    template <class View>
    View* show(const char* name) {
        auto* const dock = window_->findChild<QDockWidget*>(QLatin1String(name) + QStringLiteral("-pane"));
        dock->show();
        dock->raise();
        View* const view = window_->pane<View>();
        grab(view);
        return view;
    }
    BreakpointBar* bar() { return window_->time()->breakpoints(); }
    void stopWhen(const QString& condition) {
        bar()->findChild<QComboBox*>(QStringLiteral("breakpoint-kind"))->setCurrentIndex(kCondition);
        auto* const line = bar()->findChild<QLineEdit*>(QStringLiteral("breakpoint-condition"));
        line->setText(condition);
        QTest::keyClick(line, Qt::Key_Return);
    }
    QToolButton* chip(int number) {
        return bar()->findChild<QToolButton*>(QStringLiteral("breakpoint-%1").arg(number));
    }
};

TEST_F(DebuggingTest, AConditionStopsRunningAndIsCounted) {
    openWindow(deepRay());
    const auto steps = snapshot()->trace.steps;
    const int level = steps[steps.size() / 2].level;
    std::vector<int> expected;  // found by independent code
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k].level <= level && steps[k].decision != relief::Decision::Start) {
            expected.push_back(static_cast<int>(k));
        }
    }
    ASSERT_GT(expected.size(), 1U) << "nothing is tested";
    ASSERT_LT(expected.size(), steps.size());
    stopWhen(QStringLiteral("level <= %1 && decision != start").arg(level));
    ASSERT_EQ(scenario().breakpoints.size(), 1U);
    EXPECT_TRUE(chip(0)->text().endsWith(QStringLiteral("×%1").arg(expected.size()))) << chip(0)->text().toStdString();
    workspace_->chooseStep(0);
    const bool first = expected.front() == 0;
    for (std::size_t n = first ? 1 : 0; n < expected.size(); ++n) {
        QTest::keyClick(window_.get(), Qt::Key_F5);
        EXPECT_EQ(scenario().step, expected[n]);
    }
    for (std::size_t n = expected.size() - 1; n-- > 0;) {
        QTest::keyClick(window_.get(), Qt::Key_F5, Qt::ShiftModifier);
        EXPECT_EQ(scenario().step, expected[n]);
    }
    // The pixel is a column, too.
    const relief::PixelChoice pixel = *scenario().pixel;
    stopWhen(QStringLiteral("pixel == %1,%2").arg(pixel.x).arg(pixel.y));
    EXPECT_TRUE(chip(1)->text().endsWith(QStringLiteral("×%1").arg(steps.size()))) << chip(1)->text().toStdString();
    // What is no expression is refused; a column that no step has is shown.
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    stopWhen(QStringLiteral("level <"));
    EXPECT_EQ(scenario().breakpoints.size(), 2U);
    ASSERT_EQ(problems.size(), 1);
    EXPECT_TRUE(problems.first().first().toString().contains(QStringLiteral("level <")));
    stopWhen(QStringLiteral("levl == 1"));
    ASSERT_EQ(scenario().breakpoints.size(), 3U);
    EXPECT_TRUE(chip(2)->text().endsWith(QStringLiteral("⚠"))) << chip(2)->text().toStdString();
    EXPECT_TRUE(chip(2)->toolTip().contains(QStringLiteral("did you mean \"level\"")))
        << chip(2)->toolTip().toStdString();
    // They are part of the scenario.
    const relief::Scenario again = relief::parseScenario(relief::scenarioText(scenario()), "again.json");
    EXPECT_EQ(again.breakpoints, scenario().breakpoints);
}

TEST_F(DebuggingTest, WatchedValuesAreDrawnAndRunTo) {
    openWindow(deepRay());
    const auto* const view = show<WatchView>("watch");
    const auto steps = snapshot()->trace.steps;
    ASSERT_EQ(view->rows().size(), 3U);
    EXPECT_EQ(view->rows()[0].values.values.size(), steps.size());
    EXPECT_GT(colorsIn(grab(view->canvas())), 10);
    auto* const name = view->findChild<QComboBox*>(QStringLiteral("watch-value"));
    EXPECT_GE(name->findText(QStringLiteral("delta_lambda")), 0);
    name->setEditText(QStringLiteral("z_out - value"));
    QTest::keyClick(name->lineEdit(), Qt::Key_Return);
    grab(view->canvas());
    ASSERT_EQ(view->rows().size(), 4U);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        EXPECT_EQ(view->rows()[3].heights[k], steps[k].zOut() - steps[k].value);
    }
    // A click chooses value and step.
    const std::size_t wanted = steps.size() / 2;
    const Box box = view->frame().graph(1);
    const GraphPart part = view->frame().part(wanted);
    const QPointF at = view->canvas()->toWidget({(part.x0 + part.x1) / 2, box.center().y});
    QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::NoModifier, at.toPoint());
    EXPECT_EQ(scenario().step, static_cast<int>(wanted));
    EXPECT_EQ(stateOf<WatchPane>(scenario()).chosenValue(), "level");
    // Runs along the changes of the level, forwards and back.
    workspace_->chooseStep(0);
    std::size_t step = 0;
    for (int n = 0; n < 3; ++n) {
        const int level = steps[step].level;
        while (step + 1 < steps.size() && steps[step].level == level) ++step;
        QTest::keyClick(window_.get(), Qt::Key_F8);
        EXPECT_EQ(scenario().step, static_cast<int>(step));
    }
    QTest::keyClick(window_.get(), Qt::Key_F8, Qt::ShiftModifier);
    EXPECT_NE(steps[static_cast<std::size_t>(scenario().step)].level, steps[step].level);
    EXPECT_LT(scenario().step, static_cast<int>(step));
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    window_->pane<WatchView>()->watch(QStringLiteral("levl"));
    EXPECT_EQ(problems.size(), 1);
    EXPECT_EQ(stateOf<WatchPane>(scenario()).values.size(), 4U);
    QTest::mouseClick(view->findChild<QToolButton*>(QStringLiteral("watch-remove")), Qt::LeftButton);
    EXPECT_EQ(stateOf<WatchPane>(scenario()).values,
              (std::vector<std::string>{"lambda_after", "value", "z_out - value"}));
    workspace_->undo();
    EXPECT_EQ(stateOf<WatchPane>(scenario()).values.size(), 4U);
    // While the hit is to be guessed, the values would tell it.
    workspace_->setGuessing(true);
    grab(view->canvas());
    EXPECT_TRUE(view->rows().empty());
    workspace_->setGuessing(false);
}

TEST_F(DebuggingTest, TheHistoryOfThePixelMultipliesOut) {
    relief::Scenario small = smallScenario();
    small.shadows = true;
    openWindow(small);
    const auto* const view = show<WhyView>("why");
    const auto history = [&]() -> const relief::PixelHistory& {
        EXPECT_TRUE(QTest::qWaitFor([&] { return view->isUpToDate() && view->history() != nullptr; }, 10000));
        return *view->history();
    };
    const relief::PixelChoice pixel = *scenario().pixel;
    EXPECT_EQ(history().x, pixel.x);
    EXPECT_TRUE(history().multipliesOut());
    EXPECT_EQ(history().drawn, snapshot()->frame->light->color(pixel.x, pixel.y));
    EXPECT_GT(view->face()->sheet().places.size(), 8U);
    EXPECT_GT(colorsIn(grab(const_cast<WhyView*>(view))), 4);
    // It follows the pixel, and the filter.
    workspace_->choosePixel(pixel.x + 3, pixel.y);
    waitForFull();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view->history() != nullptr && view->history()->x == pixel.x + 3; }, 10000));
    relief::Scenario other = scenario();
    other.filter.name = relief::kSupersample;
    other.filter.samples = 2;
    workspace_->change(other, QStringLiteral("test"));
    waitForFull();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->history() && view->history()->rays.size() == 4; }, 10000));
    EXPECT_TRUE(view->history()->multipliesOut());
    EXPECT_EQ(view->history()->drawn, snapshot()->frame->light->color(pixel.x + 3, pixel.y));
    workspace_->setGuessing(true);
    grab(const_cast<WhyView*>(view));
    EXPECT_TRUE(view->face()->sheet().places.empty());
    workspace_->setGuessing(false);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->isUpToDate() && view->history() != nullptr; }, 10000));
    // If it is cancelled, that of the pixel before does not stay.
    const auto stop = QObject::connect(workspace_.get(), &Workspace::snapshotChanged, window_.get(),
                                       [this] { window_->pane<WhyView>()->cancel(); });
    workspace_->choosePixel(pixel.x, pixel.y);
    waitForFull();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->isUpToDate(); }, 10000));
    QObject::disconnect(stop);
    EXPECT_EQ(view->history(), nullptr);
}

TEST_F(DebuggingTest, ColumnsOfAnotherProgramAreShown) {
    openWindow(smallScenario());
    QTemporaryDir folder;
    const QString rays = folder.filePath(QStringLiteral("rays.csv"));
    const QString steps = folder.filePath(QStringLiteral("steps.csv"));
    const relief::ViewRay ray = snapshot()->trace.ray;
    std::ofstream(rays.toStdString()) << relief::kRaysHeader << "\n"
                                      << relief::numberText(ray.s0, 17) << "," << relief::numberText(ray.t0, 17) << ","
                                      << relief::numberText(ray.a, 17) << "," << relief::numberText(ray.b, 17) << "\n";
    std::ofstream(steps.toStdString()) << relief::kStepColumns << ",sdf,what\n"
                                       << "0,1,search,0,0,0,0,0,0.25,1,0.75,0.5,advance,0.25,0.125,far\n"
                                       << "0,2,search,0,0,0,0,0.25,0.5,0.75,0.5,0.5,advance,0.5,,\n"
                                       << "0,3,search,0,0,0,0,0.5,0.5,0.5,0.5,0.5,hit,0.5,0.001,near\n";
    const auto* const profile = show<ProfileView>("profile");
    EXPECT_EQ(profile->frame().tracks, 0);
    window_->time()->other()->open(rays, steps);
    waitForFull();
    ASSERT_EQ(snapshot()->trace.further.size(), 2U);
    grab(profile->canvas());
    EXPECT_GT(profile->frame().tracks, 0);
    // The readout has all columns of the step under the pointer, as they stand in the file.
    const ProfileFrame& frame = profile->frame();
    const QPointF at = profile->canvas()->toWidget(frame.onRay(0.1));
    QTest::mouseMove(profile->canvas(), at.toPoint());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !profile->readout().isEmpty(); }, 2000));
    EXPECT_TRUE(profile->readout().contains(QStringLiteral("sdf 0.125"))) << profile->readout().toStdString();
    EXPECT_TRUE(profile->readout().contains(QStringLiteral("what far"))) << profile->readout().toStdString();
    const QAbstractItemModel* const table = window_->time()->table()->table()->model();
    ASSERT_EQ(table->columnCount(), StepModel::Columns + 2);
    EXPECT_EQ(table->headerData(StepModel::Columns, Qt::Horizontal).toString(), QStringLiteral("sdf"));
    EXPECT_EQ(table->index(2, StepModel::Columns + 1).data().toString(), QStringLiteral("near"));
    // Exported as well, under a caption that numbers the ray as the window does.
    const TableSource exported = stepTable(snapshot(), 0, relief::Language::English);
    EXPECT_EQ(exported.titles.back(), "what");
    ASSERT_EQ(exported.rows[2].cells.size(), exported.titles.size());
    EXPECT_EQ(exported.rows[2].cells.back(), "near");
    EXPECT_NE(figureCaption(snapshot())(relief::Language::English).find("ray 0 of steps.csv"), std::string::npos);
    // They stand in conditions, and can be watched.
    stopWhen(QStringLiteral("sdf < 0.01 && what == 'near'"));
    workspace_->chooseStep(0);
    QTest::keyClick(window_.get(), Qt::Key_F5);
    EXPECT_EQ(scenario().step, 2);
    EXPECT_TRUE(chip(0)->text().endsWith(QStringLiteral("×1"))) << chip(0)->text().toStdString();
    auto* const watch = show<WatchView>("watch");
    watch->watch(QStringLiteral("sdf"));
    grab(watch->canvas());
    ASSERT_EQ(watch->rows().size(), 4U);
    EXPECT_EQ(watch->rows()[3].text(0), "0.125");
    EXPECT_FALSE(watch->rows()[3].fault);
    window_->time()->other()->close();
    waitForFull();
    grab(watch->canvas());
    EXPECT_TRUE(watch->rows()[3].fault) << "the column is gone with its file";
    show<ProfileView>("profile");
    grab(profile->canvas());
    EXPECT_EQ(profile->frame().tracks, 0);
}

}  // namespace

}  // namespace reliefui
