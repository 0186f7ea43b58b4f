// An external pane as a user of the window meets it: a folder of its own and an entry in the list are all it needs.
#include <QAction>
#include <QDockWidget>
#include <QSpinBox>
#include <QTemporaryDir>

#include "guest/numbers_pane.h"
#include "panes/drawing_canvas.h"
#include "window_fixture.h"
#include "windows/pane_list.h"

namespace reliefui {
namespace {

TEST_F(WindowTest, TheGuestPaneIsEverywhere) {
    EXPECT_EQ(paneList().back().name, QStringLiteral("numbers"));
    openWindow(smallScenario());
    auto* const dock = window_->findChild<QDockWidget*>(QStringLiteral("numbers-pane"));
    ASSERT_NE(dock, nullptr);
    auto* const view = qobject_cast<FigureView*>(dock->widget());
    ASSERT_NE(view, nullptr);
    // It opens by its shortcut, the next free one.
    QAction* go = nullptr;
    for (QAction* const action : window_->findChildren<QAction*>()) {
        if (action->text() == QStringLiteral("Numbers") && !action->shortcut().isEmpty()) go = action;
    }
    ASSERT_NE(go, nullptr);
    const std::size_t panes = paneList().size();
    EXPECT_EQ(go->shortcut(), QKeySequence(QStringLiteral("%1%2").arg(panes > 10 ? "Alt+" : "").arg(panes % 10)));
    go->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dock->visibleRegion().isEmpty(); }, 5000));
    auto* const canvas = view->findChild<DrawingCanvas*>();
    EXPECT_TRUE(canvas->hasFocus());
    EXPECT_TRUE(QTest::qWaitFor([&] { return colorsIn(grab(canvas)) > 10; }, 30000)) << "nothing is drawn";
    // Exported from the window, and by name as the program does.
    const QTemporaryDir folder;
    saveFigure(view, folder.filePath(QStringLiteral("numbers.pdf")));
    EXPECT_TRUE(validFigure(folder.filePath(QStringLiteral("numbers.pdf"))));
    relief::Work work;
    const QImage image = figureImage(*figureKind("numbers").make(snapshot(), scenario()), {}, 400, work);
    EXPECT_GT(colorsIn(image), 10);
    // Its state can be undone, and is saved and validated like that of any other pane.
    const QImage before = grab(canvas);
    view->findChild<QSpinBox*>()->setValue(1);
    EXPECT_EQ(stateOf<NumbersState>(scenario()).decimals, 1);
    EXPECT_NE(grab(canvas), before);
    const std::string text = relief::scenarioText(scenario());
    EXPECT_EQ(parseWindowScenario(text, "s.json", stateReaders()).ui, scenario().ui);
    EXPECT_THROW(
        parseWindowScenario(R"({"reliefscope": 1, "ui": {"numbers": {"decimals": 12}}})", "s.json", stateReaders()),
        relief::InputError);
    workspace_->undo();
    EXPECT_EQ(grab(canvas), before);
    EXPECT_TRUE(scenario().ui.empty());
    // After it was closed, the default layout shows it again.
    dock->hide();
    window_->resetLayout();
    EXPECT_FALSE(dock->isHidden());
    EXPECT_FALSE(window_->tabifiedDockWidgets(dock).isEmpty());
}

}  // namespace
}  // namespace reliefui
