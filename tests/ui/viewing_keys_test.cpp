// The keys for viewing (Home, End, Space, digits, ...) have the same meaning wherever the focus is: they never change a
// method, an option or the scene. Only deliberate typing reaches a box.
#include <algorithm>
#include <cstdlib>
#include <random>

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTabBar>
#include <QWheelEvent>

#include "panes/drawing_canvas.h"
#include "panes/drawn/drawn_view.h"
#include "panes/number_control.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "window_fixture.h"
#include "windows/top_bar.h"

namespace reliefui {

namespace {

constexpr std::uint64_t kSeed = 20261123;  // set RELIEF_SEED for another one
constexpr int kServerMs = 60;
constexpr int kKeysARound = 8;

struct Key {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers;
};

// The keys in the table of ui/README.md, except those that open a dialog or undo, and the projector's (slow to draw; it
// is an action below).
const std::vector<Key>& viewingKeys() {
    static const std::vector<Key> keys = [] {
        std::vector<Key> all;
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End, Qt::Key_Space, Qt::Key_Comma, Qt::Key_Period,
                                  Qt::Key_BracketLeft, Qt::Key_BracketRight, Qt::Key_F5, Qt::Key_F9, Qt::Key_F10,
                                  Qt::Key_G, Qt::Key_R, Qt::Key_T, Qt::Key_Left, Qt::Key_Up}) {
            all.push_back({key, Qt::NoModifier});
        }
        for (int digit = 0; digit < 10; ++digit) all.push_back({Qt::Key(Qt::Key_0 + digit), Qt::NoModifier});
        for (int digit = 1; digit < 5; ++digit) all.push_back({Qt::Key(Qt::Key_0 + digit), Qt::AltModifier});
        for (const Qt::Key key : {Qt::Key_E, Qt::Key_S, Qt::Key_O, Qt::Key_D, Qt::Key_F5, Qt::Key_F10}) {
            all.push_back({key, Qt::ShiftModifier});
        }
        // Keys that controls might handle themselves are tested more often.
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End, Qt::Key_Space, Qt::Key_R, Qt::Key_Up}) {
            all.insert(all.end(), 3, {key, Qt::NoModifier});
        }
        return all;
    }();
    return keys;
}

// Removes what viewing keys may change: pixel, step, breakpoints and bookmarks.
relief::Scenario unchangedPart(relief::Scenario scenario) {
    scenario.pixel.reset();
    scenario.step = 0;
    scenario.breakpoints.clear();
    scenario.bookmarks.clear();
    return scenario;
}

class ViewingKeys : public WindowTest {
  protected:
    void open() {
        relief::Scenario scenario = smallScenario();
        scenario.method = {"max-pyramid", {}};
        scenario.comparison.others = {{"layers", {}}};
        openWindow(scenario);
    }
    template <class Control>
    Control* control(const char* name) {
        return window_->findChild<Control*>(QString::fromLatin1(name));
    }
    QDockWidget* dock(const char* name) { return control<QDockWidget>(name); }
    // Sends the key to the widget with the focus, as a keyboard would.
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        ASSERT_NE(QApplication::focusWidget(), nullptr);
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    static void idle() {
        for (int i = 0; i < 3; ++i) QApplication::processEvents();
    }
    // To be called after a list was open: without a window manager the X server takes the focus away, with some delay.
    void activate() {
        QTest::qWait(kServerMs);
        QApplication::setActiveWindow(window_.get());
        idle();
    }
    // Operates the list as with a mouse: it opens, and the pointer moves to the item.
    void choose(QComboBox* list, int item) {
        QTest::mouseClick(list, Qt::LeftButton);
        QWidget* const viewport = list->view()->viewport();
        ASSERT_TRUE(QTest::qWaitFor([&] { return viewport->isVisible(); }, 2000));
        list->view()->scrollTo(list->model()->index(item, 0));
        const QPoint at = list->view()->visualRect(list->model()->index(item, 0)).center();
        for (const QPoint& by : {QPoint(-20, 0), QPoint(0, 0)}) {
            QMouseEvent move(QEvent::MouseMove, at + by, viewport->mapToGlobal(at + by), Qt::NoButton, Qt::NoButton,
                             Qt::NoModifier);
            QApplication::sendEvent(viewport, &move);
        }
        QTest::mouseClick(viewport, Qt::LeftButton, Qt::NoModifier, at);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !viewport->isVisible(); }, 2000));
        activate();
    }
    void fill(const char* pane) {
        QWidget* const title = dock(pane)->titleBarWidget();
        QTest::mouseDClick(title, Qt::LeftButton, Qt::NoModifier, QPoint(30, title->height() / 2));
        idle();
    }
    // Clicks the upper arrow of a number box.
    static void clickUp(QDoubleSpinBox* box) {
        QStyleOptionSpinBox option;
        option.initFrom(box);
        option.subControls = QStyle::SC_All;
        const QRect up = box->style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxUp, box);
        QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, up.center());
    }
    void expectSteps() {
        press(Qt::Key_Home);
        EXPECT_EQ(scenario().step, 0);
        press(Qt::Key_End);
        EXPECT_EQ(scenario().step, static_cast<int>(snapshot()->trace.steps.size()) - 1);
    }
    void tabTo(QWidget* target) {
        for (int i = 0; i < 300 && QApplication::focusWidget() != target; ++i) {
            press(Qt::Key_Tab);
            idle();
        }
        ASSERT_EQ(QApplication::focusWidget(), target);
    }
};

TEST_F(ViewingKeys, afterAMethodIsChosenWithTheMouse) {
    open();
    auto* const method = control<QComboBox>("method");
    choose(method, method->findData(QStringLiteral("layers")));
    ASSERT_EQ(scenario().method.name, "layers");
    waitForFull();
    EXPECT_EQ(QApplication::focusWidget(), window_->result());
    // Also at once, while the list still has the focus.
    method->setFocus(Qt::MouseFocusReason);
    const relief::Scenario before = unchangedPart(scenario());
    expectSteps();
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Space, Qt::Key_C, Qt::Key_Down}) press(key);
    EXPECT_EQ(unchangedPart(scenario()), before);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << "Space plays";
    // A check box does not handle Space.
    QTest::mouseClick(control<QCheckBox>("shadows"), Qt::LeftButton);
    const bool shadows = scenario().shadows;
    press(Qt::Key_Space);
    EXPECT_EQ(scenario().shadows, shadows);
}

TEST_F(ViewingKeys, afterAPaneFillsTheWindow) {
    open();
    for (const char* const pane : {"pyramid-pane", "trace-pane"}) {
        dock(pane)->raise();
        idle();
        for (int i = 0; i < 2; ++i) {
            fill(pane);
            QWidget* const focus = QApplication::focusWidget();
            ASSERT_NE(focus, nullptr);
            EXPECT_TRUE(dock(pane)->isAncestorOf(focus)) << pane << ": " << focus->metaObject()->className();
            const relief::Scenario before = unchangedPart(scenario());
            expectSteps();
            EXPECT_EQ(unchangedPart(scenario()), before);
        }
    }
}

// A digit once reached an option behind another pane's tab.
TEST_F(ViewingKeys, noHiddenControlHasTheFocus) {
    open();
    const relief::Scenario before = unchangedPart(scenario());
    press(Qt::Key_2, Qt::AltModifier);
    press(Qt::Key_F11);
    idle();
    press(Qt::Key_1, Qt::AltModifier);
    press(Qt::Key_3, Qt::AltModifier);
    press(Qt::Key_F11);
    idle();
    window_->resetLayout();
    press(Qt::Key_6);
    idle();
    EXPECT_EQ(QApplication::focusWidget(), window_->pane<ProfileView>()->canvas());
    EXPECT_EQ(unchangedPart(scenario()), before);
    // The pane that contains the edited box is hidden behind another.
    press(Qt::Key_5);
    idle();
    auto* const base = dock("scene-pane")->findChild<NumberControl*>(QStringLiteral("base"));
    ASSERT_NE(base, nullptr);
    QTest::mouseClick(base->box()->findChild<QLineEdit*>(), Qt::LeftButton);
    EXPECT_EQ(QApplication::focusWidget(), base->box());
    dock("drawn-pane")->raise();
    QTest::qWait(50);
    EXPECT_NE(QApplication::focusWidget(), base->box());
    press(Qt::Key_7);
    EXPECT_EQ(unchangedPart(scenario()), before);
}

TEST_F(ViewingKeys, digitsAreTypedWhereSomebodyTypes) {
    open();
    auto* const height = dock("scene-pane")->findChild<NumberControl*>(QStringLiteral("height"));
    ASSERT_NE(height, nullptr);
    QDoubleSpinBox* const box = height->box();
    QTest::mouseClick(box->findChild<QLineEdit*>(), Qt::LeftButton);
    idle();
    ASSERT_EQ(QApplication::focusWidget(), box);
    box->selectAll();
    for (const Qt::Key key : {Qt::Key_6, Qt::Key_0, Qt::Key_Home, Qt::Key_1}) press(key);
    press(Qt::Key_Return);
    EXPECT_EQ(scenario().height, 160) << "Home moves in the text";
    idle();
    EXPECT_EQ(QApplication::focusWidget(), window_->result()) << "Enter ends typing";
    waitForFull();
    expectSteps();
    // A click on its arrows is not typing.
    clickUp(box);
    press(Qt::Key_3);
    idle();
    EXPECT_EQ(QApplication::focusWidget(), window_->pane<PyramidView>()->canvas());
    EXPECT_EQ(scenario().height, 161);
}

TEST_F(ViewingKeys, everythingIsReachedByTab) {
    open();
    auto* const method = control<QComboBox>("method");
    ASSERT_NO_FATAL_FAILURE(tabTo(method));
    press(Qt::Key_Up);
    EXPECT_EQ(scenario().method.name, "exact");
    expectSteps();
    EXPECT_EQ(scenario().method.name, "exact");
    press(Qt::Key_Down, Qt::AltModifier);
    QWidget* const list = method->view();
    ASSERT_TRUE(QTest::qWaitFor([&] { return list->isVisible(); }, 2000));
    // While the list is open it handles its own keys.
    QTest::keyClick(list, Qt::Key_Home);
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !list->isVisible(); }, 2000));
    EXPECT_EQ(scenario().method.name, method->itemData(1).toString().toStdString());
    activate();
    EXPECT_EQ(QApplication::focusWidget(), method) << "the keyboard's user continues from here";
    press(Qt::Key_3);
    EXPECT_EQ(QApplication::focusWidget(), window_->pane<PyramidView>()->canvas());
    ASSERT_NO_FATAL_FAILURE(tabTo(control<QCheckBox>("shadows")));
    const bool shadows = scenario().shadows;
    press(Qt::Key_Space);
    EXPECT_NE(scenario().shadows, shadows);
    // Controls behind other panes' tabs are not reached.
    for (int i = 0; i < 40; ++i) {
        press(Qt::Key_Tab);
        idle();
        const QDockWidget* const pane = [] {
            for (QWidget* at = QApplication::focusWidget(); at != nullptr; at = at->parentWidget()) {
                if (auto* const found = qobject_cast<QDockWidget*>(at)) return found;
            }
            return static_cast<QDockWidget*>(nullptr);
        }();
        EXPECT_TRUE(pane == nullptr || !pane->visibleRegion().isEmpty());
    }
}

TEST_F(ViewingKeys, theWheelTurnsOnlyWhatWasChosen) {
    open();
    const auto turn = [](QWidget* over) {
        const QPoint at = over->rect().center();
        QWheelEvent event(at, over->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(over, &event);
    };
    const relief::Scenario before = scenario();
    auto* const depth = control<NumberControl>("top-relief-depth");
    turn(control<QComboBox>("method"));
    turn(depth->slider());
    turn(depth->box());
    turn(depth->box()->findChild<QLineEdit*>());
    turn(control<QWidget>("step-slider"));
    turn(control<QComboBox>("layer"));
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(workspace_->layer(), Layer::Color);
    for (const QWidget* const box : window_->findChildren<QWidget*>()) {
        // Drop-down lists are windows of their own.
        if (box->window() != window_.get() || !box->isVisible()) continue;
        EXPECT_NE(box->focusPolicy(), Qt::WheelFocus) << box->objectName().toStdString() << ": it moves the focus";
    }
    QTest::mouseClick(depth->box()->findChild<QLineEdit*>(), Qt::LeftButton);
    turn(depth->box());
    EXPECT_NE(scenario().reliefDepth, before.reliefDepth);
}

TEST_F(ViewingKeys, digitsByHandAreTheTexelsHeight) {
    open();
    press(Qt::Key_2, Qt::AltModifier);
    DrawnView* const view = window_->pane<DrawnView>();
    view->startFlat(0.25);
    waitForFull();
    fill("drawn-pane");
    ASSERT_TRUE(dock("pyramid-pane")->isHidden());
    QTest::mouseClick(view->grid(), Qt::LeftButton, Qt::NoModifier, view->grid()->placeOf(4, 5).toPoint());
    for (const Qt::Key key : {Qt::Key_0, Qt::Key_Period, Qt::Key_7, Qt::Key_5}) press(key);
    press(Qt::Key_Return);
    EXPECT_EQ(scenario().pictures.drawn.at(4, 5), 0.75);
    EXPECT_TRUE(dock("pyramid-pane")->isHidden()) << "the pane still fills the window";
    idle();
    ASSERT_EQ(QApplication::focusWidget(), view->grid());
    press(Qt::Key_Right);
    press(Qt::Key_1);
    press(Qt::Key_Return);
    EXPECT_EQ(scenario().pictures.drawn.at(5, 5), 1);
    idle();
    waitForFull();
    expectSteps();
    // If no texel is chosen, digits choose panes.
    view->grid()->choose(std::nullopt);
    press(Qt::Key_3);
    EXPECT_EQ(QApplication::focusWidget(), window_->pane<PyramidView>()->canvas());
}

// Random actions with the mouse, each followed by random viewing keys.
TEST_F(ViewingKeys, changeNothingAfterAnything) {
    open();
    const char* const given = std::getenv("RELIEF_SEED");
    const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 10) : kSeed;
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    const auto inSight = [](const QWidget* widget) { return !widget->visibleRegion().isEmpty(); };
    const auto method = [&] { choose(control<QComboBox>("method"), static_cast<int>(below(4))); };
    const auto number = [&] { clickUp(control<NumberControl>("top-relief-depth")->box()); };
    std::vector<std::pair<const char*, std::function<void()>>> actions{
        {"method", method},
        {"method", method},
        {"number", number},
        {"number", number},
        {"surface",
         [&] {
             auto* const list = control<QComboBox>("surface");
             if (inSight(list)) choose(list, static_cast<int>(below(2)));
         }},
        {"fill",
         [&] {
             std::vector<QDockWidget*> seen;
             for (QDockWidget* const pane : window_->findChildren<QDockWidget*>()) {
                 if (inSight(pane)) seen.push_back(pane);
             }
             fill(qPrintable(seen[below(seen.size())]->objectName()));
         }},
        {"projector", [&] { window_->setProjector(!workspace_->style().projector); }},
        {"reset", [&] { window_->resetLayout(); }},
        {"panes",
         [&] {
             const auto panes = window_->findChildren<QDockWidget*>();
             panes[static_cast<int>(below(static_cast<std::size_t>(panes.size())))]->toggleViewAction()->trigger();
         }},
        {"tab",
         [&] {
             for (QTabBar* const tabs : window_->findChildren<QTabBar*>()) {
                 if (!inSight(tabs) || tabs->count() < 2) continue;
                 const int at = static_cast<int>(below(static_cast<std::size_t>(tabs->count())));
                 QTest::mouseClick(tabs, Qt::LeftButton, Qt::NoModifier, tabs->tabRect(at).center());
             }
         }},
        {"tick",
         [&] {
             auto* const box = control<QCheckBox>("shadows");
             if (inSight(box)) QTest::mouseClick(box, Qt::LeftButton);
         }},
        {"slider", [&] { QTest::mouseClick(control<QWidget>("step-slider"), Qt::LeftButton); }},
    };
    std::shuffle(actions.begin(), actions.end(), random);
    for (const auto& [name, act] : actions) {
        ASSERT_NO_FATAL_FAILURE(act());
        waitForFull();
        const relief::Scenario before = unchangedPart(scenario());
        QString story = QString::fromLatin1(name);
        for (int n = 0; n < kKeysARound; ++n) {
            const Key& key = viewingKeys()[below(viewingKeys().size())];
            QWidget* const focus = QApplication::focusWidget();
            story += QStringLiteral("; ") + QKeySequence(key.key | int(key.modifiers)).toString();
            if (focus != nullptr) story += QStringLiteral(" in ") + focus->metaObject()->className();
            QTest::keyClick(focus != nullptr ? focus : window_.get(), key.key, key.modifiers);
            if (below(3) == 0) idle();
            ASSERT_EQ(QApplication::activePopupWidget(), nullptr) << story.toStdString();
            ASSERT_EQ(unchangedPart(scenario()), before) << story.toStdString();
        }
        // A number that was typed would take effect when the focus moves.
        window_->result()->setFocus();
        ASSERT_EQ(unchangedPart(scenario()), before) << story.toStdString();
    }
}

}  // namespace

}  // namespace reliefui
