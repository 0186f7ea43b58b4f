// A new window restores the state of the last session.
#include <fstream>

#include <QDockWidget>
#include <QFileInfo>
#include <QSettings>

#include "window_fixture.h"
#include "workspace/last_state.h"
#include "workspace/start_scenario.h"

namespace reliefui {

namespace {

class LastStateTest : public WindowTest {
  protected:
    QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(QString::fromLatin1(name)); }
    void openNext(const relief::Scenario& scenario) {
        window_.reset();
        workspace_.reset();
        openWindow(scenario);
    }
};

TEST_F(LastStateTest, ScenarioPanesAndThemeAreThereAgain) {
    openWindow(smallScenario());
    workspace_->choosePixel(30, 100);
    waitForFull();
    workspace_->chooseStep(2);
    const relief::Scenario left = scenario();
    dock("rows-pane")->hide();
    window_->setLightTheme(true);
    window_->keepLayout();
    keepState(left);

    relief::AssetStore store;
    const auto last = lastState(store, stateReaders());
    ASSERT_TRUE(last);
    EXPECT_EQ(*last, left);
    openNext(*last);
    EXPECT_FALSE(dock("rows-pane")->isHidden());
    window_->restoreLayout();
    EXPECT_TRUE(QTest::qWaitFor([&] { return dock("rows-pane")->isHidden(); }, 5000));
    EXPECT_FALSE(dock("charts-pane")->isHidden());
    EXPECT_EQ(workspace_->style().theme, Theme::Light);
    EXPECT_EQ(scenario(), left);
    window_->setLightTheme(false);
}

// A pane that fills the window hides the others only temporarily.
TEST_F(LastStateTest, APaneThatFillsTheWindowIsNotKept) {
    openWindow(smallScenario());
    QTest::keyClick(window_.get(), Qt::Key_3);
    QWidget* const title = dock("pyramid-pane")->titleBarWidget();
    QTest::mouseDClick(title, Qt::LeftButton, Qt::NoModifier, QPoint(30, title->height() / 2));
    ASSERT_TRUE(dock("trace-pane")->isHidden());
    window_->keepLayout();
    openNext(smallScenario());
    window_->restoreLayout();
    QTest::qWait(200);
    EXPECT_FALSE(dock("trace-pane")->isHidden());
}

TEST_F(LastStateTest, WhatCannotBeReadIsNoReasonNotToStart) {
    keepState(smallScenario());
    const QString name = QStringLiteral("reliefscope");
    const QString folder =
        QFileInfo(QSettings(QSettings::NativeFormat, QSettings::UserScope, name, name).fileName()).path();
    const std::string file = (folder + QStringLiteral("/last.json")).toStdString();
    relief::AssetStore store;
    ASSERT_TRUE(lastState(store, stateReaders()));
    std::ofstream(file) << "{";
    EXPECT_FALSE(lastState(store, stateReaders()));
    relief::Scenario gone = smallScenario();
    gone.pictures = {};
    gone.pictures.height = "/nowhere/height.png";
    keepState(gone);
    EXPECT_FALSE(lastState(store, stateReaders())) << "its picture does not exist";
}

TEST_F(LastStateTest, StartingAnewIsUndone) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    window_->startAnew();
    waitForFull();
    EXPECT_EQ(scenario().pictures, startScenario(RELIEF_DATASETS).pictures);
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario(), before);
}

}  // namespace

}  // namespace reliefui
