// Operation by keyboard alone: each shortcut of the window does what its tool tip says, no two actions share one, and
// every control has a name for screen readers.
#include <functional>
#include <map>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QShortcut>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include "panes/compare/compare_view.h"
#include "panes/drawing_canvas.h"
#include "panes/duel/duel_view.h"
#include "window_fixture.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

QString shown(const QKeySequence& keys) {
    return keys.toString(QKeySequence::NativeText);
}

void press(QWidget* widget, const QKeySequence& keys) {
    const int code = keys[0];
    QTest::keyClick(widget, static_cast<Qt::Key>(code & ~static_cast<int>(Qt::KeyboardModifierMask)),
                    static_cast<Qt::KeyboardModifiers>(code & static_cast<int>(Qt::KeyboardModifierMask)));
}

class KeyboardTest : public WindowTest {
  protected:
    void openKeys() {
        relief::Scenario scenario = smallScenario();
        scenario.method = {"layers", {{"layers", "4"}}};
        scenario.comparison.others = {{"max-pyramid", {}}};
        openWindow(scenario);
        // Closes every dialog and records that it was opened.
        QObject::connect(&closer_, &QTimer::timeout, [this] {
            if (QWidget* const modal = QApplication::activeModalWidget()) {
                asked_ = modal->windowTitle();
                modal->close();
            }
        });
        closer_.start(30);
        fill();
    }

    std::vector<QAction*> withKeys() const {
        std::vector<QAction*> found;
        for (QAction* const action : window_->findChildren<QAction*>()) {
            if (!action->shortcut().isEmpty()) found.push_back(action);
        }
        return found;
    }

    // Presses the keys of `key`. Returns true if the expected effect occurs within some seconds.
    bool works(const QString& key) {
        // The previous dialog deactivated the window, and there is no window manager to activate it again.
        QApplication::setActiveWindow(window_.get());
        window_->result()->setFocus();
        asked_.clear();
        press(window_->result(), QKeySequence(key, QKeySequence::NativeText));
        return QTest::qWaitFor(effects_.at(key), 10000);
    }

    void fill() {
        const auto step = [this] { return scenario().step; };
        const auto steps = [this] { return static_cast<int>(snapshot()->trace.steps.size()); };
        const auto asks = [this] { return !asked_.isEmpty(); };
        const auto says = [this] { return !window_->statusBar()->currentMessage().isEmpty(); };
        effects_ = {
            {shown(QKeySequence::Open), asks},
            {shown(QKeySequence::Save), asks},
            {QStringLiteral("Ctrl+Shift+O"), asks},
            {QStringLiteral("Ctrl+T"), asks},
            {QStringLiteral("Ctrl+Shift+S"), asks},
            {QStringLiteral("Ctrl+E"), asks},
            {QStringLiteral("Ctrl+G"), asks},
            {QStringLiteral(","), [this, step] { return step() == before_ - 1; }},
            {QStringLiteral("."), [this, step] { return step() == before_ + 1; }},
            {QStringLiteral("Home"), [step] { return step() == 0; }},
            {QStringLiteral("End"), [step, steps] { return step() == steps() - 1; }},
            {QStringLiteral("Space"), [this, step] { return step() > before_; }},
            {QStringLiteral("F5"), [step, steps] { return step() == steps() - 1; }},
            {QStringLiteral("Shift+F5"), [step] { return step() == 0; }},
            {QStringLiteral("F10"), [this, step] { return step() > before_; }},
            {QStringLiteral("Shift+F10"), [this, step] { return step() < before_; }},
            // The first watched value: where the ray continues.
            {QStringLiteral("F8"), [this, step] { return step() > before_; }},
            {QStringLiteral("Shift+F8"), [this, step] { return step() < before_; }},
            {QStringLiteral("F9"), [this] { return scenario().breakpoints.size() == 1; }},
            {QStringLiteral("]"), [this] { return speed() == 5; }},
            {QStringLiteral("["), [this] { return speed() == 1; }},
            {QStringLiteral("Shift+E"), says},
            {QStringLiteral("Shift+S"), says},
            {QStringLiteral("Shift+O"), says},
            {QStringLiteral("Shift+D"), says},
            {QStringLiteral("Ctrl+D"),
             [this] { return QApplication::focusWidget() == window_->pane<DuelView>()->canvas(); }},
            {QStringLiteral("Ctrl+B"), [this] { return scenario().bookmarks.size() == 1; }},
            {QStringLiteral("Ctrl+Shift+B"), [this] { return scenario().pixel == bookmarked_; }},
            {QStringLiteral("G"), [this] { return workspace_->guessing(); }},
            {QStringLiteral("Ctrl+Z"), [this] { return scenario().reliefDepth == depth_; }},
            {QStringLiteral("Ctrl+Shift+Z"), [this] { return scenario().reliefDepth != depth_; }},
            {QStringLiteral("Ctrl+Shift+C"),
             [] { return QApplication::clipboard()->text().contains(QStringLiteral("relief trace")); }},
            {QStringLiteral("Ctrl+Alt+C"), [] { return !QApplication::clipboard()->image().isNull(); }},
            {QStringLiteral("F1"), [this] { return closeDialog(); }},
            {QStringLiteral("T"), [this] { return window_->teaching(); }},
            {QStringLiteral("H"), [this] { return scenario().camera != turned_; }},
            {QStringLiteral("F11"), [this] { return workspace_->style().projector; }},
            // The coarse picture may have been shown before the key was pressed.
            {QStringLiteral("Esc"),
             [this] { return !workspace_->busy() && (snapshot()->version == version_ || snapshot()->coarse); }},
        };
    }

    double speed() const {
        return window_->time()->bar()->findChild<QDoubleSpinBox*>(QStringLiteral("play-speed"))->value();
    }
    bool closeDialog() const {
        const auto* const dialog = window_->findChild<QDialog*>();
        return dialog != nullptr && dialog->isVisible();
    }

    // Establishes the state in which the key has an effect.
    void prepare(const QString& key) {
        if (workspace_->guessing()) workspace_->setGuessing(false);
        waitForFull();
        workspace_->chooseStep(2);
        window_->statusBar()->clearMessage();
        QApplication::clipboard()->clear();
        before_ = scenario().step;
        if (key == QStringLiteral("[") || key == QStringLiteral("]")) {
            window_->time()->bar()->findChild<QDoubleSpinBox*>(QStringLiteral("play-speed"))->setValue(2);
        }
        if (key == QStringLiteral("Ctrl+Z") || key == QStringLiteral("Ctrl+Shift+Z")) {
            depth_ = scenario().reliefDepth;
            relief::Scenario deeper = scenario();
            deeper.reliefDepth = depth_ + 0.01;
            workspace_->change(deeper, QStringLiteral("depth"));
            if (key == QStringLiteral("Ctrl+Shift+Z")) workspace_->undo();
        }
        if (key == QStringLiteral("Ctrl+Shift+B")) {
            relief::Scenario now = scenario();
            bookmarked_ = relief::PixelChoice{60, 50};
            workspace_->setBookmarks({{"a", *bookmarked_, now.camera, 0}}, QStringLiteral("bookmark"));
        } else if (key == QStringLiteral("Ctrl+B")) {
            workspace_->setBookmarks({}, QStringLiteral("none"));
        }
        if (key == QStringLiteral("H")) {
            relief::Scenario turned = scenario();
            turned.camera.azimuth += 10;
            workspace_->change(turned, QStringLiteral("turn"));
            turned_ = turned.camera;
        }
        if (key == QStringLiteral("F9")) workspace_->setBreakpoints({}, QStringLiteral("none"));
        if (key == QStringLiteral("F5") || key == QStringLiteral("Shift+F5")) {
            workspace_->setBreakpoints({}, QStringLiteral("none"));
        }
        waitForFull();
        if (key == QStringLiteral("Esc")) {
            version_ = snapshot()->version;
            small_ = scenario();
            relief::Scenario other = small_;
            other.width = 1600;
            other.height = 1200;
            workspace_->change(other, QStringLiteral("large"));
        }
    }

    // Reverts the effect of the key.
    void restore(const QString& key) {
        if (key == QStringLiteral("F11")) window_->setProjector(false);
        if (key == QStringLiteral("T")) window_->setTeaching(false);
        if (key == QStringLiteral("Space")) window_->time()->bar()->togglePlay();
        if (key == QStringLiteral("F1")) delete window_->findChild<QDialog*>();
        if (key == QStringLiteral("Esc")) {
            workspace_->change(small_, QStringLiteral("small"));
            waitForFull();
        }
    }

    std::map<QString, std::function<bool()>> effects_;
    QTimer closer_;
    QString asked_;
    int before_ = 0;
    double depth_ = 0;
    relief::Camera turned_;
    std::uint64_t version_ = 0;
    relief::Scenario small_;
    std::optional<relief::PixelChoice> bookmarked_;
};

TEST_F(KeyboardTest, EveryShortcutDoesWhatItSays) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    openKeys();
    EXPECT_TRUE(window_->findChildren<QShortcut*>().isEmpty()) << "shortcuts must be actions, which appear in a menu";
    int tried = 0;
    for (QAction* const action : withKeys()) {
        const QString key = shown(action->shortcut());
        SCOPED_TRACE(key.toStdString() + ": " + action->text().toStdString());
        // The tool tip contains the shortcut.
        EXPECT_TRUE(action->toolTip().contains(QLatin1Char('(') + key + QLatin1Char(')')))
            << action->toolTip().toStdString();
        // Shortcuts of a single control are tested with it (copying rows in stepping_test.cpp).
        if (action->shortcutContext() == Qt::WidgetShortcut || action->shortcut() == QKeySequence(QKeySequence::Quit))
            continue;
        const auto pane = key.startsWith(QStringLiteral("Alt+")) || (key.size() == 1 && key[0].isDigit());
        ASSERT_NO_FATAL_FAILURE(prepare(key));
        QSignalSpy triggered(action, &QAction::triggered);
        if (pane) {
            QApplication::setActiveWindow(window_.get());
            window_->result()->setFocus();
            press(window_->result(), action->shortcut());
            QWidget* const focus = QApplication::focusWidget();
            ASSERT_NE(focus, nullptr);
            EXPECT_EQ(key == QStringLiteral("1"), focus == window_->result()) << focus->objectName().toStdString();
        } else {
            ASSERT_TRUE(effects_.count(key) > 0) << "a new shortcut: what it does is not tested";
            EXPECT_TRUE(works(key)) << "nothing happened";
        }
        EXPECT_EQ(triggered.count(), 1);
        restore(key);
        ++tried;
    }
    EXPECT_GE(tried, 40);
    // Last, because it closes the window.
    QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier);
    EXPECT_FALSE(window_->isVisible());
}

TEST_F(KeyboardTest, NoTwoShareAShortcut) {
    openKeys();
    std::map<QString, QString> taken;
    for (const QAction* const action : withKeys()) {
        for (const QKeySequence& keys : action->shortcuts()) {
            const auto [place, free] = taken.emplace(shown(keys), action->text());
            EXPECT_TRUE(free) << shown(keys).toStdString() << ": " << action->text().toStdString() << " and "
                              << place->second.toStdString();
        }
    }
    EXPECT_GT(taken.size(), 40U);
}

// Widgets of Qt: the parts of a box, and tabs (which have the names of the panes).
bool ownedByQt(const QWidget* widget) {
    return widget->objectName().startsWith(QStringLiteral("qt_")) || widget->inherits("QTabBar");
}

// The pane with the focus is exported, or the result if there is nothing to export in it.
TEST_F(KeyboardTest, ThePaneWithTheFocusIsExported) {
    openKeys();
    const auto exported = [this](const char* pane) {
        auto* const dock = window_->findChild<QDockWidget*>(QLatin1String(pane));
        dock->raise();
        QTest::qWait(20);
        QApplication::setActiveWindow(window_.get());
        for (QWidget* const widget : dock->findChildren<QWidget*>()) {
            if (widget->isVisible() && (widget->focusPolicy() & Qt::TabFocus) != 0)
                widget->setFocus(Qt::TabFocusReason);
            if (dock->isAncestorOf(QApplication::focusWidget())) break;
        }
        EXPECT_TRUE(dock->isAncestorOf(QApplication::focusWidget())) << pane;
        asked_.clear();
        press(QApplication::focusWidget(), QKeySequence(QStringLiteral("Ctrl+E")));
        EXPECT_TRUE(QTest::qWaitFor([this] { return !asked_.isEmpty(); }, 10000)) << pane;
        return asked_.toStdString();
    };
    EXPECT_EQ(exported("profile-pane"), "Export the profile");
    EXPECT_EQ(exported("scene-pane"), "Export figure");
}

TEST_F(KeyboardTest, EveryControlHasAName) {
    openKeys();
    // Every widget of the window, also behind a tab.
    int named = 0;
    for (QWidget* const widget : window_->findChildren<QWidget*>()) {
        // Drop-down lists are windows of their own.
        if (widget->window() != window_.get() || widget->focusPolicy() == Qt::NoFocus) continue;
        if (widget->focusProxy() != nullptr || ownedByQt(widget)) continue;
        // The line edit of a spin box reports the name of the box.
        if (widget->inherits("QLineEdit") && widget->parentWidget()->inherits("QAbstractSpinBox")) continue;
        QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(widget);
        // Qt sometimes still has the accessible interface of a deleted widget at the same address, and returns that one
        // or none: then the displayed text is taken as the name.
        const bool known = spoken != nullptr && spoken->isValid() && spoken->object() == widget;
        const QString name = known ? spoken->text(QAccessible::Name) : widget->property("text").toString();
        // A symbol or the displayed value does not count as a name.
        const QString own = widget->accessibleName().isEmpty() ? name : widget->accessibleName();
        const bool words = std::any_of(own.begin(), own.end(), [](QChar c) { return c.isLetter(); });
        EXPECT_TRUE(words) << widget->metaObject()->className() << " '" << widget->objectName().toStdString() << "' in "
                           << widget->parentWidget()->metaObject()->className() << ": '" << name.toStdString() << "'";
        ++named;
    }
    EXPECT_GT(named, 100);
}

TEST_F(KeyboardTest, DividersAreMovedByKeys) {
    relief::Scenario scenario = smallScenario();
    scenario.comparison.others = {{"layers", {}}, {"offset", {}}};
    scenario.comparison.mode = relief::CompareMode::Swipe;
    openWindow(scenario);
    window_->findChild<QDockWidget*>(QStringLiteral("compare-pane"))->raise();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_->pane<CompareView>()->view() != nullptr && window_->pane<CompareView>()->isUpToDate(); },
        20000));
    ComparePictures* const pictures = window_->pane<CompareView>()->pictures();
    pictures->setFocus();
    const auto dividers = [&] { return relief::dividersOf(this->scenario().comparison); };
    const std::vector<double> first = dividers();
    ASSERT_EQ(first.size(), 2U);
    const QImage even = grab(pictures);
    QTest::keyClick(pictures, Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_NEAR(dividers()[0], first[0] - 0.1, 1e-9);
    EXPECT_EQ(dividers()[1], first[1]);
    EXPECT_NE(grab(pictures), even);
    // The other divider, in small steps.
    QTest::keyClick(pictures, Qt::Key_Down, Qt::AltModifier);
    QTest::keyClick(pictures, Qt::Key_Right, Qt::AltModifier);
    EXPECT_NEAR(dividers()[1], first[1] + 0.01, 1e-9);
    // Dividers never cross.
    for (int i = 0; i < 12; ++i) QTest::keyClick(pictures, Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_EQ(dividers()[1], dividers()[0]);
    // The moves of each are one step of undo.
    workspace_->undo();
    EXPECT_NEAR(dividers()[0], first[0] - 0.1, 1e-9);
    EXPECT_EQ(dividers()[1], first[1]);
    workspace_->undo();
    EXPECT_EQ(dividers(), first);
}

// For a small relief the picture is rendered with packed cones, which give the hits of max-pyramid.
TEST_F(WindowTest, AnotherTracerOfThePictureIsNamedAndItsStepsAreAClickAway) {
    relief::Scenario shown = smallScenario();
    shown.method = {"exact", {}};
    openWindow(shown);
    auto* const walk = window_->findChild<QToolButton*>(QStringLiteral("status-walk"));
    ASSERT_NE(walk, nullptr);
    EXPECT_EQ(snapshot()->frame->tracedBy, "exact");
    EXPECT_FALSE(walk->isVisible());
    shown.method = {"max-pyramid", {}};
    workspace_->change(shown, QStringLiteral("test"));
    waitForFull();
    const relief::Scenario before = scenario();
    EXPECT_EQ(snapshot()->frame->tracedBy, "cone");
    ASSERT_TRUE(walk->isVisible());
    EXPECT_TRUE(walk->text().endsWith(QStringLiteral("cone"))) << walk->text().toStdString();
    const QImage picture = snapshot()->picture;
    const auto pyramidSteps = snapshot()->trace.steps;
    QTest::mouseClick(walk, Qt::LeftButton);
    waitForFull();
    EXPECT_EQ(scenario().method.name, "cone");
    EXPECT_FALSE(walk->isVisible());
    EXPECT_EQ(snapshot()->picture, picture) << "the same hits";
    EXPECT_NE(snapshot()->trace.steps, pyramidSteps);
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario(), before);
    EXPECT_TRUE(walk->isVisible());
}

}  // namespace

}  // namespace reliefui
