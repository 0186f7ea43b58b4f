// Time: breakpoints, stepping over levels, the sorted table; undo and files keep them.
#include <cmath>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include "panes/steps/step_table.h"
#include "window_fixture.h"
#include "windows/breakpoint_bar.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

constexpr int kLevelBelow = 0;
constexpr int kTexel = 1;
constexpr int kRayBelow = 2;

void addBreakpoint(BreakpointBar* bar, int kind) {
    bar->findChild<QComboBox*>(QStringLiteral("breakpoint-kind"))->setCurrentIndex(kind);
    QTest::mouseClick(bar->findChild<QToolButton*>(QStringLiteral("breakpoint-add")), Qt::LeftButton);
}

TEST_F(WindowTest, BreakpointsStopRunningAndPlaying) {
    openWindow(deepRay());
    const std::vector<relief::Step>& steps = snapshot()->trace.steps;
    ASSERT_GT(steps.size(), 6U);
    workspace_->chooseStep(0);
    ASSERT_GT(steps.front().level, 1) << "the ray has no levels: nothing is tested";
    BreakpointBar* const bar = window_->time()->breakpoints();
    bar->findChild<QSpinBox*>(QStringLiteral("breakpoint-level"))->setValue(1);
    addBreakpoint(bar, kLevelBelow);
    ASSERT_EQ(scenario().breakpoints.size(), 1U);
    EXPECT_EQ(scenario().breakpoints[0], (relief::Breakpoint{relief::StopKind::LevelBelow, 1}));
    // The expected step, found by independent code.
    std::size_t first = 0;
    while (steps[first].level >= 1) ++first;
    QTest::keyClick(window_.get(), Qt::Key_F5);
    EXPECT_EQ(scenario().step, static_cast<int>(first));
    const auto* const label = window_->time()->bar()->findChild<QLabel*>();
    EXPECT_TRUE(label->text().contains(QStringLiteral("level < 1"))) << label->text().toStdString();
    // Playing stops there, too.
    workspace_->chooseStep(0);
    auto* const speed = window_->time()->bar()->findChild<QDoubleSpinBox*>(QStringLiteral("play-speed"));
    speed->setValue(30);
    window_->time()->bar()->togglePlay();
    const int expected = static_cast<int>(first);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario().step == expected; }, 5000));
    QTest::qWait(300);
    EXPECT_EQ(scenario().step, expected) << "it went on";
    // With the breakpoint disabled the ray runs to its end.
    QTest::mouseClick(bar->findChild<QToolButton*>(QStringLiteral("breakpoint-0")), Qt::LeftButton);
    EXPECT_FALSE(scenario().breakpoints[0].on);
    QTest::qWait(1);
    workspace_->chooseStep(0);
    QTest::keyClick(window_.get(), Qt::Key_F5);
    EXPECT_EQ(scenario().step, static_cast<int>(steps.size()) - 1);
    // Removes the breakpoint.
    QTest::mouseClick(bar->findChild<QToolButton*>(QStringLiteral("breakpoint-remove-0")), Qt::LeftButton);
    EXPECT_TRUE(scenario().breakpoints.empty());
}

TEST_F(WindowTest, BreakpointsAreUndoneSavedAndOpenedAgain) {
    openWindow(deepRay());
    const QImage picture = snapshot()->picture;
    const std::uint64_t version = snapshot()->version;
    BreakpointBar* const bar = window_->time()->breakpoints();
    bar->findChild<QDoubleSpinBox*>(QStringLiteral("breakpoint-height"))->setValue(0.35);
    addBreakpoint(bar, kRayBelow);
    workspace_->chooseStep(2);
    QTest::keyClick(window_.get(), Qt::Key_F9);
    ASSERT_EQ(scenario().breakpoints.size(), 2U);
    const relief::Step& step = snapshot()->trace.steps[2];
    EXPECT_EQ(scenario().breakpoints[1], (relief::Breakpoint{relief::StopKind::Texel, step.level, step.i, step.j}));
    EXPECT_EQ(snapshot()->version, version) << "nothing is rendered for a breakpoint";
    const relief::Scenario set = scenario();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("stops.json"));
    workspace_->save(path);
    QTest::keyClick(window_.get(), Qt::Key_F9);
    EXPECT_EQ(scenario().breakpoints.size(), 1U) << "pressed again it goes";
    workspace_->undo();
    EXPECT_EQ(scenario(), set);
    workspace_->undo();
    EXPECT_EQ(scenario().breakpoints.size(), 1U);
    while (workspace_->canUndo()) workspace_->undo();
    EXPECT_TRUE(scenario().breakpoints.empty());
    EXPECT_EQ(snapshot()->picture, picture);
    workspace_->open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == set; }, 5000)) << "the saved state is restored";
    waitForFull();
    EXPECT_EQ(snapshot()->picture, picture);
    EXPECT_NE(bar->findChild<QToolButton*>(QStringLiteral("breakpoint-1")), nullptr);
    EXPECT_EQ(bar->findChild<QToolButton*>(QStringLiteral("breakpoint-2")), nullptr);
    // F9 removes it when it is off, too.
    std::vector<relief::Breakpoint> off = scenario().breakpoints;
    off[1].on = false;
    off[1].ignore = 3;
    workspace_->setBreakpoints(off, QStringLiteral("test"));
    QTest::keyClick(window_.get(), Qt::Key_F9);
    EXPECT_EQ(scenario().breakpoints.size(), 1U);
    // Without steps there is no texel to stop at.
    workspace_->setGuessing(true);
    QTest::keyClick(window_.get(), Qt::Key_F9);
    EXPECT_EQ(scenario().breakpoints.size(), 1U);
}

TEST_F(WindowTest, LevelsAreSteppedOverByKeys) {
    openWindow(deepRay());
    const std::vector<relief::Step>& steps = snapshot()->trace.steps;
    workspace_->chooseStep(1);
    const int level = steps[1].level;
    QTest::keyClick(window_.get(), Qt::Key_F10);
    const int over = scenario().step;
    ASSERT_GT(over, 1);
    for (int k = 2; k < over; ++k) EXPECT_LT(steps[static_cast<std::size_t>(k)].level, level) << k;
    const int last = static_cast<int>(steps.size()) - 1;
    EXPECT_TRUE(over == last || steps[static_cast<std::size_t>(over)].level >= level);
    QTest::keyClick(window_.get(), Qt::Key_F10, Qt::ShiftModifier);
    const int back = scenario().step;
    EXPECT_LT(back, over);
    EXPECT_GE(steps[static_cast<std::size_t>(back)].level, steps[static_cast<std::size_t>(over)].level);
}

TEST_F(WindowTest, ASortedTableStaysInStep) {
    openWindow(deepRay());
    QTableView* const table = window_->time()->table()->table();
    const std::vector<relief::Step>& steps = snapshot()->trace.steps;
    workspace_->chooseStep(3);
    table->sortByColumn(StepModel::Value, Qt::DescendingOrder);
    EXPECT_EQ(scenario().step, 3) << "sorting chooses nothing";
    EXPECT_EQ(table->currentIndex().sibling(table->currentIndex().row(), 0).data().toInt(), 4);
    double before = HUGE_VAL;
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        const int number = table->model()->index(row, StepModel::Number).data().toInt();
        const double value = steps[static_cast<std::size_t>(number - 1)].value;
        EXPECT_LE(value, before) << row;
        before = value;
    }
    // A click on a row chooses the step in that row.
    const QModelIndex top = table->model()->index(0, 0);
    table->scrollTo(top);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(top).center());
    EXPECT_EQ(scenario().step, top.data().toInt() - 1);
    // With Ctrl another row is added to the rows to be copied; a drag selects all that it passes.
    const QModelIndex next = table->model()->index(1, 0);
    const auto selected = [&] { return table->selectionModel()->selectedRows().size(); };
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::ControlModifier, table->visualRect(next).center());
    EXPECT_EQ(scenario().step, next.data().toInt() - 1);
    EXPECT_EQ(selected(), 2);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(top).center());
    EXPECT_EQ(selected(), 1);
    QTest::mousePress(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(next).center());
    const QPoint to = table->visualRect(top).center();
    QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(table->viewport(), &move);
    QTest::mouseRelease(table->viewport(), Qt::LeftButton, Qt::NoModifier, to);
    EXPECT_EQ(selected(), 2);
    // The kinds of breakpoints at a texel follow the chosen step.
    window_->time()->breakpoints()->findChild<QComboBox*>(QStringLiteral("breakpoint-kind"))->setCurrentIndex(kTexel);
    const relief::Step& step = steps[static_cast<std::size_t>(scenario().step)];
    EXPECT_EQ(window_->time()->breakpoints()->edited(),
              (relief::Breakpoint{relief::StopKind::Texel, step.level, step.i, step.j}));
}

}  // namespace

}  // namespace reliefui
