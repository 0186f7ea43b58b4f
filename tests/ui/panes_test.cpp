// The panes that explain the pixel show what was logged, with the right colours.
#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <QDockWidget>
#include <QTableView>
#include <QToolButton>

#include "painting/painter.h"
#include "panes/drawing_canvas.h"
#include "panes/duel/duel_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/result/result_painting.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_view.h"
#include "scenario/step_sentence.h"
#include "window_fixture.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

QString cell(const QTableView* table, int row, int column) {
    return table->model()->index(row, column).data(Qt::DisplayRole).toString();
}

QString pair(double a, double b) {
    return QString::fromStdString(relief::fixedText(a, 4) + " → " + relief::fixedText(b, 4));
}

int distance(QColor a, QColor b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

TEST_F(WindowTest, TheTableIsTheTraceOfThePixel) {
    openWindow(smallScenario());
    for (const QPoint pixel : {QPoint(60, 50), QPoint(110, 95)}) {
        QTest::mouseClick(window_->result(), Qt::LeftButton, Qt::NoModifier, onScreen(pixel.x(), pixel.y()));
        waitForFull();
        const std::vector<relief::Step>& steps = snapshot()->trace.steps;
        const QTableView* const table = window_->time()->table()->table();
        ASSERT_EQ(table->model()->rowCount(), static_cast<int>(steps.size()));
        for (int row = 0; row < table->model()->rowCount(); ++row) {
            const relief::Step& step = steps[static_cast<std::size_t>(row)];
            EXPECT_EQ(cell(table, row, StepModel::Number), QString::number(row + 1));
            EXPECT_EQ(cell(table, row, StepModel::Level), QString::number(step.level));
            EXPECT_EQ(cell(table, row, StepModel::Texel), QStringLiteral("(%1, %2)").arg(step.i).arg(step.j));
            EXPECT_EQ(cell(table, row, StepModel::Lambda), pair(step.lambdaIn, step.lambdaOut));
            EXPECT_EQ(cell(table, row, StepModel::Height), pair(step.zIn(), step.zOut()));
            EXPECT_EQ(cell(table, row, StepModel::Value).toStdString(), relief::fixedText(step.value, 4));
        }
        EXPECT_EQ(table->currentIndex().row(), scenario().step);
    }
}

TEST_F(WindowTest, StepsAreChosenInTheTableAndByKeys) {
    openWindow(deepRay());
    const int opened = scenario().step;
    const auto last = static_cast<int>(snapshot()->trace.steps.size()) - 1;
    ASSERT_GT(last, 4);
    auto* const table = window_->time()->table()->findChild<QTableView*>();
    const QModelIndex second = table->model()->index(1, 0);
    table->scrollTo(second);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(second).center());
    EXPECT_EQ(scenario().step, 1);
    const QString sentence = window_->time()->table()->sentence();
    EXPECT_FALSE(sentence.isEmpty());
    window_->result()->setFocus();
    QTest::keyClick(window_->result(), Qt::Key_Period);
    EXPECT_EQ(scenario().step, 2);
    EXPECT_EQ(table->currentIndex().row(), 2);
    EXPECT_NE(window_->time()->table()->sentence(), sentence);
    QTest::keyClick(window_->result(), Qt::Key_Comma);
    EXPECT_EQ(scenario().step, 1);
    QTest::keyClick(window_->result(), Qt::Key_End);
    EXPECT_EQ(scenario().step, last);
    QTest::keyClick(window_->result(), Qt::Key_Home);
    EXPECT_EQ(scenario().step, 0);
    QTest::keyClick(window_->result(), Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario().step >= 2; }, 3000)) << "the steps play";
    QTest::keyClick(window_->result(), Qt::Key_Space);
    const int stopped = scenario().step;
    QTest::qWait(700);
    EXPECT_EQ(scenario().step, stopped);
    workspace_->undo();
    EXPECT_EQ(scenario().step, opened) << "steps in a row are one change";
}

// Columns without room are hidden; titles and numbers of the visible ones are complete.
TEST_F(WindowTest, NoColumnOfTheStepsIsCut) {
    openWindow(smallScenario());
    const QTableView* const table = window_->time()->table()->table();
    const auto check = [&] {
        QTest::qWait(300);
        const QFontMetrics metrics(table->font());
        int all = 0;
        int shown = 0;
        for (int c = 0; c < StepModel::Columns; ++c) {
            if (table->isColumnHidden(c)) continue;
            all += c + 1 < StepModel::Columns ? table->columnWidth(c) : 0;  // the last column takes the remaining width
            ++shown;
            const QString title = table->model()->headerData(c, Qt::Horizontal).toString();
            EXPECT_GE(table->columnWidth(c), metrics.horizontalAdvance(title)) << title.toStdString();
            for (int row = 0; row < table->model()->rowCount(); ++row) {
                const QString text = cell(table, row, c);
                const int symbol = c == StepModel::Decision ? 20 : 0;
                EXPECT_GE(table->columnWidth(c), metrics.horizontalAdvance(text) + symbol) << text.toStdString();
            }
        }
        EXPECT_LE(all, table->viewport()->width());
        return shown;
    };
    EXPECT_EQ(check(), StepModel::Columns);
    window_->setProjector(true);
    EXPECT_GE(check(), 4);
    window_->setProjector(false);
    EXPECT_EQ(check(), StepModel::Columns);
}

TEST_F(WindowTest, DigitsGoToPanes) {
    openWindow(smallScenario());
    const std::vector<QWidget*> panes{window_->result(), window_->pane<Trace3dView>(), window_->pane<PyramidView>(),
                                      window_->time()->table()};
    for (std::size_t i = panes.size(); i-- > 0;) {
        QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)));
        QWidget* const focus = QApplication::focusWidget();
        ASSERT_NE(focus, nullptr);
        EXPECT_TRUE(focus == panes[i] || panes[i]->isAncestorOf(focus)) << i;
    }
}

TEST_F(WindowTest, ThePyramidShowsItsTexels) {
    relief::Scenario columns = smallScenario();
    columns.surface = relief::Surface::Columns;
    openWindow(columns);
    PyramidView* const view = window_->pane<PyramidView>();
    view->showNearRay(false);
    const QImage shown = grab(view->canvas());
    EXPECT_GT(colorsIn(shown), 10);
    const relief::Pyramid& pyramid = snapshot()->maxima->pyramid;
    ASSERT_EQ(view->blocks().size(), static_cast<std::size_t>(pyramid.levels()));
    int probes = 0;
    int right = 0;
    for (const LevelBlock& block : view->blocks()) {
        const relief::FloatImage& level = pyramid.level(block.level);
        const double side = std::ldexp(1.0, block.level);
        if (block.unitX() * side < 2) continue;  // smaller than a pixel of the screen
        const int stride = std::max(1, level.width() / 9);
        for (int j = 0; j < level.height(); j += stride) {
            for (int i = 0; i < level.width(); i += stride) {
                // Near the corner, because values are printed in the middle of large texels.
                const Point at = block.toDrawing(Point{(i + 0.25) * side, (j + 0.25) * side});
                const QPoint pixel = view->canvas()->toWidget(at).toPoint();
                if (!shown.valid(pixel)) continue;
                const QColor expected = toColor(workspace_->style().cell(
                    ColorMap::Height, static_cast<double>(level(i, j)), view->heights().scale));
                ++probes;
                if (distance(shown.pixelColor(pixel), expected) <= 6) ++right;
            }
        }
    }
    ASSERT_GT(probes, 60);
    // The marks of the steps cover some.
    EXPECT_GT(right, probes * 8 / 10) << right << " of " << probes;
}

TEST_F(WindowTest, TheTraceIsDrawnAndFollowsTheStep) {
    openWindow(smallScenario());
    auto* const canvas = window_->pane<Trace3dView>()->findChild<QVTKOpenGLNativeWidget*>();
    ASSERT_NE(canvas, nullptr);
    const QImage atEnd = grab(canvas);
    EXPECT_GT(colorsIn(atEnd), 50);
    workspace_->chooseStep(2);
    const QImage atSecond = grab(canvas);
    EXPECT_NE(atEnd, atSecond);
    EXPECT_GT(colorsIn(atSecond), 50);
}

TEST_F(WindowTest, APaneFillsTheWindowAndComesBack) {
    openWindow(smallScenario());
    QWidget* const title = window_->result()->parentWidget()->findChild<QWidget*>(QStringLiteral("pane-title"));
    ASSERT_NE(title, nullptr);
    const QSize before = window_->result()->size();
    QTest::mouseDClick(title, Qt::LeftButton, Qt::NoModifier, QPoint(20, title->height() / 2));
    QTest::qWait(100);
    EXPECT_GT(window_->result()->width(), window_->width() - 20);
    EXPECT_FALSE(window_->pane<PyramidView>()->isVisible());
    // Only the step bar and the step's sentence remain below.
    EXPECT_TRUE(window_->time()->bar()->isVisible());
    EXPECT_FALSE(window_->time()->table()->isVisible());
    EXPECT_GT(window_->result()->height(), window_->height() * 2 / 3);
    QTest::mouseDClick(title, Qt::LeftButton, Qt::NoModifier, QPoint(20, title->height() / 2));
    QTest::qWait(100);
    EXPECT_TRUE(window_->pane<PyramidView>()->isVisible());
    EXPECT_TRUE(window_->time()->table()->isVisible());
    EXPECT_EQ(window_->result()->size(), before);
    EXPECT_GT(colorsIn(grab(window_->pane<PyramidView>()->canvas())), 10);
}

TEST_F(WindowTest, TheProjectorEnlargesEverything) {
    openWindow(smallScenario());
    const int before = window_->fontMetrics().height();
    window_->setProjector(true);
    QTest::qWait(200);
    EXPECT_GT(window_->fontMetrics().height(), before * 3 / 2);
    EXPECT_TRUE(window_->isFullScreen());
    EXPECT_LE(window_->minimumSizeHint().width(), 1280) << "wider than a projector";
    // One pane next to the result, of the same height.
    EXPECT_GT(window_->pane<PyramidView>()->height(), window_->result()->height() / 2);
    EXPECT_TRUE(window_->pane<Trace3dView>()->visibleRegion().isEmpty()) << "it waits in a tab";
    EXPECT_GT(colorsIn(grab(window_->pane<PyramidView>()->canvas())), 10);
    window_->setProjector(false);
    QTest::qWait(200);
    EXPECT_EQ(window_->fontMetrics().height(), before);
    EXPECT_FALSE(window_->pane<Trace3dView>()->visibleRegion().isEmpty()) << "as it was";
}

TEST_F(WindowTest, PanesAreClosedAndOpenedAgain) {
    openWindow(smallScenario());
    auto* const dock = window_->findChild<QDockWidget*>(QStringLiteral("pyramid-pane"));
    auto* const close = dock->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("pane-close"));
    ASSERT_NE(close, nullptr);
    QTest::mouseClick(close, Qt::LeftButton);
    EXPECT_TRUE(dock->isHidden());
    QTest::keyClick(window_.get(), Qt::Key_3);
    EXPECT_FALSE(dock->isHidden());
    // A pane that fills the window hides the others; closing it shows them again.
    dock->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("pane-fill"))->click();
    EXPECT_FALSE(window_->result()->isVisible());
    close->click();
    EXPECT_TRUE(window_->result()->isVisible());
    EXPECT_TRUE(dock->isHidden());
}

// Panes are moved to windows of their own, with OpenGL contexts of their own, and back.
TEST_F(WindowTest, PanesLeaveTheWindowAndComeBack) {
    openWindow(deepRay());
    auto* const pyramid = window_->findChild<QDockWidget*>(QStringLiteral("pyramid-pane"));
    auto* const trace = window_->findChild<QDockWidget*>(QStringLiteral("trace-pane"));
    for (int round = 0; round < 2; ++round) {
        for (QDockWidget* const dock : {pyramid, trace}) dock->setFloating(true);
        QTest::qWait(100);
        EXPECT_NE(pyramid->window(), window_.get());
        const QImage before = grab(window_->pane<Trace3dView>());
        EXPECT_GT(colorsIn(grab(window_->pane<PyramidView>()->canvas())), 10);
        EXPECT_GT(colorsIn(before), 30);
        workspace_->chooseStep(scenario().step > 2 ? 1 : 4);
        EXPECT_NE(grab(window_->pane<Trace3dView>()), before) << "it follows the step";
        // Shortcuts of the main window work there, too.
        const int step = scenario().step;
        pyramid->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(pyramid));
        QTest::keyClick(window_->pane<PyramidView>()->canvas(), Qt::Key_Period);
        EXPECT_EQ(scenario().step, step + 1);
        for (QDockWidget* const dock : {pyramid, trace}) dock->setFloating(false);
        QTest::qWait(100);
        EXPECT_EQ(pyramid->window(), window_.get());
        EXPECT_GT(colorsIn(grab(window_->pane<PyramidView>()->canvas())), 10);
        EXPECT_GT(colorsIn(grab(window_->pane<Trace3dView>())), 30);
    }
    // A floating pane that fills the window is docked, and floats again afterwards.
    trace->setFloating(true);
    trace->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("pane-fill"))->click();
    QTest::qWait(100);
    EXPECT_FALSE(trace->isFloating());
    EXPECT_GT(window_->pane<Trace3dView>()->width(), window_->width() - 20);
    trace->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("pane-fill"))->click();
    QTest::qWait(100);
    EXPECT_TRUE(trace->isFloating());
    window_->resetLayout();
    EXPECT_FALSE(trace->isFloating());
}

TEST_F(WindowTest, TheDuelLeavesItsDrawingTheRoom) {
    relief::Scenario scenario = smallScenario();
    scenario.comparison.others = {{"layers", {}}, {"offset", {}}};
    openWindow(scenario);
    DuelView* const duel = window_->pane<DuelView>();
    auto* const dock = window_->findChild<QDockWidget*>(QStringLiteral("duel-pane"));
    dock->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return duel->isUpToDate() && duel->duel() != nullptr; }, 20000));
    QTest::qWait(200);
    auto* const table = duel->findChild<QTableView*>();
    // In the dock only the drawing is shown; in the whole window the table is next to it.
    EXPECT_FALSE(table->isVisible());
    EXPECT_GT(duel->canvas()->width(), duel->width() * 9 / 10);
    dock->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("pane-fill"))->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return table->isVisible(); }, 5000));
    EXPECT_GT(duel->canvas()->width(), duel->width() / 2);
    EXPECT_GE(table->columnWidth(0), table->fontMetrics().horizontalAdvance(QStringLiteral("15 advance 0.1950")));
}

TEST_F(WindowTest, TheLightThemeIsLight) {
    openWindow(smallScenario());
    window_->setLightTheme(true);
    const QImage shown = grab(window_.get());
    EXPECT_GT(shown.pixelColor(3, shown.height() - 3).lightness(), 200);
    EXPECT_GT(grab(window_->pane<PyramidView>()->canvas()).pixelColor(2, 2).lightness(), 200);
    window_->setLightTheme(false);
}

}  // namespace

}  // namespace reliefui
