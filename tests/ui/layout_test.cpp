// Layouts fit: at the size of the usual projector, of a desktop, and of large screens; in both languages; with a
// filling pane, in teaching and in projector mode.
#include <algorithm>
#include <set>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include "layout_laws.h"
#include "lessons/lessons.h"
#include "panes/compare/compare_view.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/narrow_bar.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/steps/step_sentence.h"
#include "panes/steps/step_table.h"
#include "relief/tracers.h"
#include "window_fixture.h"
#include "windows/layout_menu.h"
#include "windows/message_bar.h"
#include "windows/pane_title.h"
#include "windows/program.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr int kLayoutMs = 150;
constexpr int kSettledMs = 3000;

class LayoutTest : public WindowTest {
  protected:
    void TearDown() override {
        WindowTest::TearDown();
        if (haveDisplay()) installTranslations({});
    }
    QDockWidget* dock(const char* name) const { return window_->findChild<QDockWidget*>(QLatin1String(name)); }
    void fill(const char* name) {
        auto* const title = qobject_cast<PaneTitle*>(dock(name)->titleBarWidget());
        Q_EMIT title->fillRequested();
    }
    void setSize(const QSize& size) {
        // Until the projector's type size has been adapted to the height, large type may need more room.
        window_->resize(size);
        QTest::qWait(kLayoutMs);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                window_->resize(size);
                return window_->size() == size;
            },
            kSettledMs));
        window_->resetLayout();
    }
    // In every mode, with a sentence and a lesson's note.
    void holdIn(const QSize& size) {
        const std::vector<std::pair<const char*, std::function<void()>>> modes{
            {"all", [] {}},
            {"filled", [this] { fill("profile-pane"); }},
            {"taught with", [this] { window_->setTeaching(true); }},
        };
        for (const bool projector : {false, true}) {
            window_->setProjector(projector);
            for (const auto& [name, enter] : modes) {
                setSize(size);
                enter();
                // Panes show other text while they compute.
                const bool settled = QTest::qWaitFor([&] { return layoutFaults(*window_, size).empty(); }, kSettledMs);
                SCOPED_TRACE(std::to_string(size.width()) + " x " + std::to_string(size.height()) + ", " + name +
                             (projector ? ", projector" : ""));
                EXPECT_TRUE(window_->messages()->isVisible()) << "the lesson's text";
                if (settled) continue;
                for (const std::string& fault : layoutFaults(*window_, size)) ADD_FAILURE() << fault;
            }
        }
        window_->setProjector(false);
    }
    void openLessonIn(const QString& language) {
        installTranslations(language);
        openWindow(lessonScenario(QStringLiteral("unsafe_distance")));
        window_->showLesson();
        // The longest sentence, that with the answer.
        workspace_->chooseStep(static_cast<int>(snapshot()->trace.steps.size()) - 1);
    }
    std::map<QString, QRect> places() const {
        std::map<QString, QRect> all;
        for (const QDockWidget* const dock : window_->findChildren<QDockWidget*>()) {
            if (!dock->visibleRegion().isEmpty()) all[dock->objectName()] = dock->geometry();
        }
        all[QStringLiteral("result")] = window_->centralWidget()->geometry();
        return all;
    }
};

TEST_F(LayoutTest, NothingIsCutAndNothingLiesOverAnother) {
    openLessonIn(QStringLiteral("en"));
    // The last one is a screen of 3840 x 2160 with a scale factor of two.
    for (const QSize& size : {QSize(1280, 720), QSize(1366, 768), QSize(1600, 1000), QSize(1920, 1080)}) holdIn(size);
}

TEST_F(LayoutTest, NorInUkrainian) {
    openLessonIn(QStringLiteral("uk"));
    for (const QSize& size : {QSize(1280, 720), QSize(1366, 768)}) holdIn(size);
}

TEST_F(LayoutTest, ResetGivesTheModesLayout) {
    openWindow(smallScenario());
    window_->setProjector(true);
    QTest::qWait(kLayoutMs);
    const auto projected = places();
    EXPECT_FALSE(projected.contains(QStringLiteral("scene-pane"))) << "nobody reads controls from the last row";
    dock("rows-pane")->setFloating(true);
    dock("profile-pane")->hide();
    window_->resetLayout();
    QTest::qWait(kLayoutMs);
    EXPECT_EQ(places(), projected);
    window_->setProjector(false);
    window_->resetLayout();
    QTest::qWait(kLayoutMs);
    EXPECT_TRUE(places().contains(QStringLiteral("scene-pane")));
    EXPECT_TRUE(places().contains(QStringLiteral("trace-pane")));
    EXPECT_TRUE(places().contains(QStringLiteral("pyramid-pane")));
    // In a low window there is one large pane instead of two small ones.
    setSize({1280, 720});
    QTest::qWait(kLayoutMs);
    EXPECT_GT(dock("profile-pane")->height() + dock("pyramid-pane")->height(), 380);
    EXPECT_EQ(places().contains(QStringLiteral("trace-pane")) + places().contains(QStringLiteral("pyramid-pane")) +
                  places().contains(QStringLiteral("profile-pane")),
              1);
}

TEST_F(LayoutTest, TheWindowIsAsItWasAfterTheProjector) {
    openWindow(smallScenario());
    window_->resize(1400, 880);
    dock("charts-pane")->raise();
    // The display server needs some time; then the panes are laid out again.
    ASSERT_TRUE(QTest::qWaitFor([&] { return dock("trace-pane")->width() < 1400 * 2 / 5; }, kSettledMs));
    QTest::qWait(kLayoutMs);
    const auto before = places();
    const QSize size = window_->size();
    for (const bool teaching : {false, true}) {
        window_->setProjector(true);
        QTest::qWait(kLayoutMs);
        window_->setTeaching(teaching);
        QTest::qWait(kLayoutMs);
        window_->setProjector(false);
        QTest::qWait(kLayoutMs);
        EXPECT_EQ(window_->teaching(), teaching) << "the mode is unaffected";
        window_->setTeaching(false);
        QTest::qWait(kLayoutMs);
        EXPECT_EQ(window_->size(), size);
        EXPECT_EQ(window_->windowState() & Qt::WindowFullScreen, 0);
        EXPECT_EQ(places(), before);
    }
    // A maximised window is restored maximised.
    window_->setWindowState(Qt::WindowMaximized);
    window_->setProjector(true);
    window_->setProjector(false);
    EXPECT_TRUE(window_->isMaximized());
}

TEST_F(LayoutTest, TeachingShowsOnePaneThePictureAndTheStepInWords) {
    openWindow(deepRay());
    dock("pyramid-pane")->raise();
    QTest::qWait(kLayoutMs);
    const auto before = places();
    window_->result()->setFocus();
    QTest::keyClick(window_->result(), Qt::Key_T);
    QTest::qWait(kLayoutMs);
    EXPECT_TRUE(window_->teaching());
    EXPECT_GT(window_->pane<PyramidView>()->width(), window_->width() * 3 / 5);
    EXPECT_TRUE(window_->result()->isVisible());
    EXPECT_TRUE(window_->time()->bar()->isVisible());
    EXPECT_FALSE(window_->time()->table()->isVisible());
    const auto* const words = window_->centralWidget()->findChild<StepSentence*>();
    ASSERT_TRUE(words->isVisible());
    EXPECT_EQ(words->text(), window_->time()->table()->sentence());
    // Another pane, one step on: the same view.
    QTest::keyClick(window_.get(), Qt::Key_6);
    QTest::qWait(kLayoutMs);
    EXPECT_TRUE(window_->teaching());
    EXPECT_GT(window_->pane<ProfileView>()->width(), window_->width() * 3 / 5);
    const QString said = words->text();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Comma);
    EXPECT_NE(words->text(), said);
    // Large type and back, and the end of teaching: the pane in use stays in front.
    const auto profileInFront = [&] { return !dock("profile-pane")->visibleRegion().isEmpty(); };
    for (const bool projector : {true, false}) {
        window_->setProjector(projector);
        QTest::qWait(kLayoutMs);
        EXPECT_TRUE(profileInFront()) << projector;
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_T);
    QTest::qWait(kLayoutMs);
    EXPECT_FALSE(window_->teaching());
    EXPECT_TRUE(profileInFront());
    dock("pyramid-pane")->raise();
    QTest::qWait(kLayoutMs);
    EXPECT_EQ(places(), before);
    EXPECT_FALSE(words->isVisible());
}

TEST_F(LayoutTest, AFilledPaneKeepsTheStepInWords) {
    openWindow(deepRay());
    fill("profile-pane");
    QTest::qWait(kLayoutMs);
    const auto* const words = window_->time()->findChild<StepSentence*>(QString(), Qt::FindDirectChildrenOnly);
    ASSERT_TRUE(words->isVisible());
    EXPECT_EQ(words->text(), window_->time()->table()->sentence());
    EXPECT_GT(window_->pane<ProfileView>()->height(), window_->height() * 7 / 10);
    fill("profile-pane");
    QTest::qWait(kLayoutMs);
    EXPECT_FALSE(words->isVisible());
    // Escape leaves the filled pane, guessing and large type as well, one at a time.
    fill("profile-pane");
    window_->setProjector(true);
    workspace_->setGuessing(true);
    QTest::qWait(kLayoutMs);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace_->busy(); }, kSettledMs));
    const auto escape = [&] {
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QTest::qWait(kLayoutMs);
    };
    escape();
    EXPECT_FALSE(workspace_->guessing());
    EXPECT_FALSE(window_->result()->isVisible());
    escape();
    EXPECT_TRUE(window_->result()->isVisible());
    EXPECT_TRUE(workspace_->style().projector);
    escape();
    EXPECT_FALSE(workspace_->style().projector);
}

TEST_F(LayoutTest, LayoutsOfOnesOwnAreKept) {
    openWindow(smallScenario());
    auto* layouts = window_->findChild<LayoutMenu*>();
    ASSERT_NE(layouts, nullptr);
    dock("rows-pane")->raise();
    dock("scene-pane")->hide();
    QTest::qWait(kLayoutMs);
    const auto mine = places();
    layouts->save(QStringLiteral("rows & no controls"));
    window_->setTeaching(true);
    layouts->save(QStringLiteral("taught"));
    window_->setTeaching(false);
    window_->resetLayout();
    QTest::qWait(kLayoutMs);
    EXPECT_NE(places(), mine);
    // Also in a new window.
    window_.reset();
    workspace_.reset();
    openWindow(smallScenario());
    layouts = window_->findChild<LayoutMenu*>();
    EXPECT_EQ(LayoutMenu::names(), (QStringList{QStringLiteral("rows & no controls"), QStringLiteral("taught")}));
    layouts->choose(QStringLiteral("taught"));
    QTest::qWait(kLayoutMs);
    EXPECT_TRUE(window_->teaching());
    layouts->choose(QStringLiteral("rows & no controls"));
    QTest::qWait(kLayoutMs);
    EXPECT_FALSE(window_->teaching());
    EXPECT_EQ(places(), mine);
    for (const QString& name : LayoutMenu::names()) layouts->remove(name);
    EXPECT_TRUE(LayoutMenu::names().isEmpty());
}

// Controls without room are hidden without moving what is below them.
TEST_F(LayoutTest, ControlsDoNotMoveWhatLiesBelow) {
    openWindow(smallScenario());
    auto* const view = window_->pane<DistanceView>();
    dock("distance-pane")->setFloating(true);
    dock("distance-pane")->show();
    std::set<int> tops;
    bool ends = false;
    bool all = false;
    for (int width = 300; width <= 800; width += 20) {
        dock("distance-pane")->resize(width, 400);
        QTest::qWait(20);
        tops.insert(view->canvas()->y());
        const auto arrows =
            view->findChild<NarrowBar*>()->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
        const bool some = std::any_of(arrows.begin(), arrows.end(), [](const auto* one) { return one->isVisible(); });
        (some ? ends : all) = true;
    }
    EXPECT_EQ(tops.size(), 1U);
    EXPECT_TRUE(ends && all) << "of both kinds";
    dock("distance-pane")->resize(300, 400);
    QTest::qWait(kLayoutMs);
    auto* const bar = view->findChild<NarrowBar*>();
    auto* const fit = bar->row()->itemAt(bar->row()->count() - 1)->widget();
    EXPECT_TRUE(fit->visibleRegion().isEmpty());
    for (auto* const arrow : bar->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
        while (arrow->isVisible() && arrow->arrowType() == Qt::RightArrow) arrow->click();
    }
    EXPECT_EQ(fit->visibleRegion().boundingRect(), fit->rect());
}

// Four pictures in the smallest pane: large enough to be distinguished, scrolled if there is no room; the pane's
// buttons stay visible.
TEST_F(LayoutTest, ComparedPicturesAreNotTooSmall) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"distance-conservative", {}};
    scenario.comparison.others = {{"max-pyramid", {}}, {"layers", {}}, {"cone", {}}};
    openWindow(scenario);
    auto* const view = window_->pane<CompareView>();
    for (const QSize& size : {QSize(1280, 720), QSize(1600, 1000)}) {
        for (const bool projector : {false, true}) {
            SCOPED_TRACE(std::to_string(size.width()) + (projector ? ", projector" : ""));
            window_->setProjector(projector);
            setSize(size);
            dock("compare-pane")->raise();
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return view->isUpToDate() && view->view() && view->view()->rated; }, 60000));
            QTest::qWait(kLayoutMs);
            const CompareLayout& layout = view->pictures()->layoutNow();
            ASSERT_EQ(layout.rooms.size(), 4U);
            const double unit = workspace_->style().pixelsPerPoint();
            for (const Box& room : layout.rooms) EXPECT_GE(room.height() * unit, 75);
            const auto* const area = view->findChild<QScrollArea*>(QStringLiteral("compare-area"));
            EXPECT_EQ(area->verticalScrollBar()->isVisible(), view->pictures()->height() > area->viewport()->height());
            for (const char* const name : {"compare-add", "compare-remove", "compare-options"}) {
                const auto* const button = view->findChild<QToolButton*>(QLatin1String(name));
                EXPECT_EQ(button->visibleRegion().boundingRect(), button->rect()) << name;
            }
        }
    }
    window_->setProjector(false);
}

// Qt makes a window that needs more than its screen larger than that, if only for a moment, and leaves it so.
TEST_F(LayoutTest, NoModeNeedsMoreThanTheScreen) {
    constexpr QSize kSmall(1280, 720);
    for (const char* const language : {"en", "uk"}) {
        openLessonIn(QLatin1String(language));
        setSize(kSmall);
        for (const bool projector : {false, true}) {
            SCOPED_TRACE(std::string(language) + (projector ? ", projector" : ""));
            window_->setProjector(projector);
            QTest::qWait(kLayoutMs);
            const QRect screen = window_->screen()->geometry();
            EXPECT_LE(window_->width(), screen.width());
            EXPECT_LE(window_->height(), screen.height());
            setSize(kSmall);
            QTest::qWait(kLayoutMs);
            EXPECT_LE(window_->minimumSizeHint().width(), kSmall.width());
            EXPECT_LE(window_->minimumSizeHint().height(), kSmall.height());
        }
        window_->setProjector(false);
        WindowTest::TearDown();
    }
}

// Whatever options a method has, none lies under the scroll bar.
TEST_F(LayoutTest, TheControlsAreNoWiderThanTheirPane) {
    for (const char* const language : {"en", "uk"}) {
        openLessonIn(QLatin1String(language));
        setSize({1280, 720});
        const auto* const area = dock("scene-pane")->findChild<QScrollArea*>();
        for (const relief::MethodDescription& method : relief::tracerList()) {
            if (method.kind == relief::MethodKind::AnyHit) continue;
            relief::Scenario scenario = workspace_->scenario();
            scenario.method = {method.name, {}};
            workspace_->change(scenario, changeName([] { return QStringLiteral("Method"); }));
            const auto fits = [&] { return area->widget()->width() <= area->viewport()->width(); };
            EXPECT_TRUE(QTest::qWaitFor(fits, kLayoutMs))
                << language << " " << method.name << " " << area->widget()->width() << " in "
                << area->viewport()->width();
            EXPECT_LE(window_->minimumSizeHint().width(), 1280) << language << " " << method.name;
        }
        WindowTest::TearDown();
    }
}

TEST_F(LayoutTest, TheHelpFitsTheScreen) {
    openWindow(smallScenario());
    for (const bool projector : {false, true}) {
        window_->setProjector(projector);
        QTest::keyClick(window_.get(), Qt::Key_F1);
        auto* const dialog = window_->findChild<QDialog*>();
        ASSERT_NE(dialog, nullptr);
        QTest::qWait(kLayoutMs);
        EXPECT_LE(dialog->height(), QApplication::primaryScreen()->availableSize().height());
        EXPECT_LE(dialog->width(), QApplication::primaryScreen()->availableSize().width());
        EXPECT_GT(dialog->height(), 400);
        delete dialog;
    }
    window_->setProjector(false);
}

}  // namespace

}  // namespace reliefui
