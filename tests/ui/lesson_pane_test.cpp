// Lessons in the window: pages, live values, guesses, the knob, the lecture mode, lessons of one's own.
#include <filesystem>

#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>

#include "../memory_use.h"
#include "lessons/lesson_pane.h"
#include "lessons/new_lesson.h"
#include "window_fixture.h"
#include "windows/lesson_menu.h"
#include "windows/message_bar.h"

namespace reliefui {

namespace {

using relief::test::usedMegabytes;

QString shipped(const char* name) {
    return QStringLiteral(RELIEF_SOURCE "/ui/lessons/") + QLatin1String(name);
}

// Less than half of what a frame of the page's 800 x 600 pixels takes.
constexpr double kFrameMegabytes = 20;

class LessonPaneTest : public WindowTest {
  protected:
    void openLesson(const QString& folder) {
        openWindow(smallScenario());
        menu_ = window_->findChild<LessonMenu*>();
        ASSERT_NE(menu_, nullptr);
        ASSERT_TRUE(menu_->open(folder));
        ASSERT_NO_FATAL_FAILURE(waitForPage());
    }
    LessonPlayer* player() const { return menu_->player(); }
    // Waits until the page's scenario is on screen and its values are measured.
    void waitForPage() {
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                return !workspace_->loading() && !player()->changed() && !workspace_->busy() &&
                       !player()->measuring() && !text().contains(QStringLiteral("…"));
            },
            30000))
            << text().toStdString();
    }
    QString text() const { return menu_->pane()->plainText(); }
    bool inFront(const char* pane) const {
        const auto* const dock = window_->findChild<QDockWidget*>(QLatin1String(pane) + QStringLiteral("-pane"));
        return QTest::qWaitFor([&] { return !dock->visibleRegion().isEmpty(); }, 10000);
    }
    void click(const char* button) {
        menu_->pane()->findChild<QToolButton*>(QLatin1String(button))->click();
        waitForPage();
    }
    // As a click on a link of the text.
    void follow(const QString& link) { Q_EMIT menu_->pane()->findChild<QTextBrowser*>()->anchorClicked(QUrl(link)); }

    LessonMenu* menu_ = nullptr;
};

TEST_F(LessonPaneTest, GoesFromPageToPageWithLiveValues) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    EXPECT_TRUE(window_->findChild<QDockWidget*>(QStringLiteral("lesson-dock"))->isVisible());
    EXPECT_TRUE(inFront("profile"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario().step == 3; }, 10000)) << "step 4, counted from 1";
    EXPECT_TRUE(text().contains(QStringLiteral("16 equal layers"))) << text().toStdString();
    click("lesson-next");
    EXPECT_TRUE(inFront("duel"));
    EXPECT_EQ(player()->pageNumber(), 1U);
    const std::size_t departs = snapshot()->trace.judgement.step;
    EXPECT_TRUE(QTest::qWaitFor([&] { return static_cast<std::size_t>(scenario().step) == departs; }, 10000));
    // The text follows what is changed, and leads back.
    relief::Scenario more = scenario();
    more.method.options["layers"] = "128";
    workspace_->change(more, QStringLiteral("more"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return text().contains(QStringLiteral("takes %1 steps").arg(snapshot()->trace.steps.size())); }, 10000))
        << text().toStdString();
    EXPECT_TRUE(text().contains(QStringLiteral("You changed the scene")));
    follow(QStringLiteral("restore:"));
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    EXPECT_EQ(scenario().method.options.at("layers"), "16");
    click("lesson-previous");
    EXPECT_EQ(player()->pageNumber(), 0U);
    menu_->pane()->showContents();
    EXPECT_TRUE(text().contains(QStringLiteral("302"))) << text().toStdString();
    follow(QStringLiteral("open:301"));
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    EXPECT_EQ(player()->lesson().name, "301");
    // The page's step is an entry of its own.
    const auto undone = [&] {
        if (!workspace_->busy() && !player()->changed()) workspace_->undo();
        return player()->changed();
    };
    EXPECT_TRUE(QTest::qWaitFor(undone, 10000)) << "opening a lesson can be undone";
}

TEST_F(LessonPaneTest, MeasuresOnlyWhatIsShown) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    click("lesson-next");
    auto* const dock = window_->findChild<QDockWidget*>(QStringLiteral("lesson-dock"));
    dock->hide();
    relief::Scenario more = scenario();
    more.method.options["layers"] = "128";
    workspace_->change(more, QStringLiteral("more"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    const auto current = [&] {
        return text().contains(QStringLiteral("takes %1 steps").arg(snapshot()->trace.steps.size()));
    };
    EXPECT_FALSE(QTest::qWaitFor([&] { return player()->measuring() || current(); }, 500));
    menu_->showDock();
    EXPECT_TRUE(QTest::qWaitFor(current, 10000)) << text().toStdString();
    // The lecturer's notes have values as well.
    menu_->showNotes();
    dock->hide();
    more.method.options["layers"] = "64";
    workspace_->change(more, QStringLiteral("fewer"));
    EXPECT_TRUE(QTest::qWaitFor(current, 10000)) << text().toStdString();
    // What they were measured on, among others the frame of this scene, is freed.
    EXPECT_TRUE(QTest::qWaitFor([&] { return !player()->measuring() && !workspace_->busy(); }, 10000));
    const double before = usedMegabytes();
    window_->findChild<QDialog*>(QStringLiteral("lesson-notes"))->close();
    const auto freed = [&] { return before - usedMegabytes(); };
    EXPECT_TRUE(QTest::qWaitFor([&] { return freed() > kFrameMegabytes; }, 5000)) << freed();
    // Behind another tab it is soon needed again, and stays measured.
    menu_->showDock();
    EXPECT_TRUE(QTest::qWaitFor(current, 10000)) << text().toStdString();
    const auto behind = window_->tabifiedDockWidgets(dock);
    ASSERT_FALSE(behind.isEmpty());
    behind.front()->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return menu_->pane()->visibleRegion().isEmpty(); }, 5000));
    more.method.options["layers"] = "16";
    workspace_->change(more, QStringLiteral("as at first"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    EXPECT_TRUE(QTest::qWaitFor(current, 10000)) << text().toStdString();
}

// A page's step is found on its own ray, not on that of a picture that comes while its own is drawn.
TEST_F(LessonPaneTest, TheStepIsThatOfThePagesPicture) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    relief::Scenario exact = scenario();
    exact.method = {"exact", {}};
    workspace_->change(exact, QStringLiteral("exact"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    ASSERT_EQ(snapshot()->trace.judgement.kind, relief::Departure::None);
    QObject::connect(workspace_.get(), &Workspace::scenarioChanged, player(),
                     [this] { QTimer::singleShot(0, player(), [this] { Q_EMIT workspace_->snapshotChanged(); }); });
    click("lesson-next");
    ASSERT_NE(snapshot()->trace.judgement.kind, relief::Departure::None);
    const int departs = static_cast<int>(snapshot()->trace.judgement.step);
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario().step == departs; }, 10000));
}

TEST_F(LessonPaneTest, AsksBeforeItAnswers) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    click("lesson-next");
    const QString answer = QStringLiteral("texels too far");
    EXPECT_FALSE(text().contains(answer));
    follow(QStringLiteral("hint:"));
    EXPECT_TRUE(text().contains(QStringLiteral("stops before")));
    follow(QStringLiteral("choose:0"));
    EXPECT_EQ(player()->chosen(), std::size_t{0});
    EXPECT_FALSE(text().contains(answer));
    follow(QStringLiteral("answer:"));
    EXPECT_TRUE(text().contains(answer));
    EXPECT_TRUE(text().contains(QStringLiteral("Not so.")));
    follow(QStringLiteral("choose:1"));
    EXPECT_EQ(player()->chosen(), std::size_t{0}) << "after the answer no guess counts";
    // The right one.
    player()->restore();
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    follow(QStringLiteral("choose:%1").arg(*player()->right()));
    follow(QStringLiteral("answer:"));
    EXPECT_TRUE(text().contains(QStringLiteral("Right.")));
    // A question for a click hides the answer until it is given.
    ASSERT_TRUE(menu_->open(shipped("301")));
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    click("lesson-next");
    EXPECT_TRUE(workspace_->guessing());
    EXPECT_TRUE(workspace_->snapshot()->trace.hidden);
    follow(QStringLiteral("answer:"));
    EXPECT_FALSE(workspace_->guessing());
}

TEST_F(LessonPaneTest, TheKnobTurnsTheScenario) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    click("lesson-next");
    click("lesson-next");
    auto* const knob = menu_->pane()->findChild<QSlider*>(QStringLiteral("lesson-knob"));
    ASSERT_TRUE(knob->isVisible());
    EXPECT_EQ(knob->value(), 1) << "16 layers";
    EXPECT_EQ(workspace_->layer(), Layer::Error);
    knob->setValue(3);
    EXPECT_EQ(scenario().method.options.at("layers"), "64");
    ASSERT_TRUE(QTest::qWaitFor([&] { return player()->turns().size() == 2; }, 20000));
    EXPECT_LT(player()->turns().at(3)[0], player()->turns().at(1)[0]) << "the mean error";
    EXPECT_TRUE(text().contains(QStringLiteral("frame.error.mean")));
    // A method without the knob's option.
    relief::Scenario exact = scenario();
    exact.method = {"exact", {}};
    workspace_->change(exact, QStringLiteral("exact"));
    knob->setValue(2);
    EXPECT_EQ(scenario().method, exact.method);
    EXPECT_EQ(knob->value(), 3) << "it goes back";
    ASSERT_TRUE(window_->messages()->isProblem());
    EXPECT_TRUE(window_->messages()->text().contains(QStringLiteral("layers")));
    EXPECT_FALSE(window_->messages()->text().contains(QStringLiteral("json"))) << "no file is at fault";
}

TEST_F(LessonPaneTest, TheKnobKeepsThePixelInThePicture) {
    openWindow(smallScenario());
    menu_ = window_->findChild<LessonMenu*>();
    ASSERT_TRUE(menu_->open(shipped("103"), 1));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace_->loading() && !player()->changed(); }, 30000));
    auto* const knob = menu_->pane()->findChild<QSlider*>(QStringLiteral("lesson-knob"));
    knob->setValue(2);
    ASSERT_EQ(scenario().width, 16384);
    workspace_->choosePixel(2000, 100);
    knob->setValue(0);
    EXPECT_EQ(scenario().width, 1024);
    EXPECT_EQ(scenario().pixel, (relief::PixelChoice{1023, 100}));
}

TEST_F(LessonPaneTest, ALectureNeedsTwoKeys) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    menu_->setLecture(true);
    const auto press = [&](Qt::Key key) { QTest::keyClick(window_->result(), key); };
    press(Qt::Key_PageDown);
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    EXPECT_EQ(player()->pageNumber(), 1U);
    press(Qt::Key_2);
    press(Qt::Key_2);
    press(Qt::Key_1);
    EXPECT_EQ(player()->votes(), (std::vector<int>{1, 2, 0}))
        << "guesses of the class; no pane is chosen by the digits";
    EXPECT_TRUE(text().contains(QStringLiteral("– 2")));
    press(Qt::Key_PageDown);
    EXPECT_TRUE(player()->revealed()) << "first the answer";
    EXPECT_EQ(player()->pageNumber(), 1U);
    press(Qt::Key_PageDown);
    EXPECT_EQ(player()->pageNumber(), 2U) << "then the next page";
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    press(Qt::Key_PageUp);
    EXPECT_EQ(player()->pageNumber(), 1U);
    press(Qt::Key_B);
    auto* black = window_->findChild<QWidget*>(QStringLiteral("black-screen"));
    ASSERT_NE(black, nullptr);
    EXPECT_EQ(black->size(), window_->size());
    EXPECT_EQ(colorsIn(black->grab().toImage()), 1);
    press(Qt::Key_PageDown);
    EXPECT_EQ(window_->findChild<QWidget*>(QStringLiteral("black-screen")), nullptr);
    EXPECT_FALSE(player()->revealed()) << "the key only ends the black screen";
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    // From the last page of a lesson to the next lesson, and back.
    ASSERT_TRUE(player()->open(shipped("301"), 99));
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    press(Qt::Key_PageDown);
    EXPECT_EQ(player()->lesson().name, "302");
    EXPECT_EQ(player()->pageNumber(), 0U);
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    press(Qt::Key_PageUp);
    EXPECT_EQ(player()->lesson().name, "301");
    press(Qt::Key_Escape);
    EXPECT_FALSE(menu_->lecturing());
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    menu_->showNotes();
    auto* const notes = window_->findChild<QDialog*>(QStringLiteral("lesson-notes"));
    ASSERT_NE(notes, nullptr);
    EXPECT_TRUE(notes->findChild<QTextBrowser*>()->toPlainText().contains(QStringLiteral("Usual misunderstanding")));
    notes->close();
}

// As after a change of language: another window for the same workspace goes on with the lesson.
TEST_F(LessonPaneTest, AnotherWindowKeepsTheSceneAndTheAnswers) {
    ASSERT_NO_FATAL_FAILURE(openLesson(shipped("302")));
    click("lesson-next");
    player()->vote(1);
    follow(QStringLiteral("choose:0"));
    follow(QStringLiteral("answer:"));
    relief::Scenario more = scenario();
    more.method.options["layers"] = "128";
    workspace_->change(more, QStringLiteral("more"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    more = scenario();
    const QTemporaryDir own;  // as if a folder of lessons had been opened
    const auto notes = [&] { return window_->findChild<QDialog*>(QStringLiteral("lesson-notes")); };
    menu_->showNotes();
    const auto replaceWindow = [&] {
        LessonMenu::Kept kept = menu_->kept();
        kept.own = own.path();
        window_.reset();
        window_ = std::make_unique<MainWindow>(workspace_.get(), QStringLiteral(RELIEF_DATASETS));
        window_->show();
        menu_ = window_->findChild<LessonMenu*>();
        menu_->resume(std::move(kept));
        return !window_->findChild<QDockWidget*>(QStringLiteral("lesson-dock"))->isHidden();
    };
    EXPECT_TRUE(replaceWindow());
    EXPECT_EQ(menu_->kept().own, own.path());
    ASSERT_TRUE(notes() != nullptr && notes()->isVisible());
    notes()->close();
    const QString steps = QStringLiteral("takes %1 steps").arg(snapshot()->trace.steps.size());
    EXPECT_TRUE(QTest::qWaitFor([&] { return text().contains(steps); }, 10000)) << text().toStdString();
    EXPECT_EQ(scenario(), more) << "the page's scene is not opened again";
    EXPECT_EQ(player()->pageNumber(), 1U);
    EXPECT_EQ(player()->chosen(), std::size_t{0});
    EXPECT_TRUE(player()->revealed() && player()->changed());
    EXPECT_EQ(player()->votes(), (std::vector<int>{0, 1, 0}));
    // A lesson whose dock was closed does not come back by itself.
    window_->findChild<QDockWidget*>(QStringLiteral("lesson-dock"))->hide();
    EXPECT_FALSE(replaceWindow());
    EXPECT_EQ(notes(), nullptr);
    EXPECT_TRUE(player()->isOpen());
    EXPECT_EQ(scenario(), more);
}

TEST_F(LessonPaneTest, LessonsOfOnesOwnAreMadeAndOpened) {
    const QTemporaryDir folder;
    openWindow(deepRay());
    menu_ = window_->findChild<LessonMenu*>();
    const QString made = folder.filePath(QStringLiteral("mine"));
    writeNewLesson(made, scenario(), QStringLiteral("profile"), QStringLiteral(RELIEF_DATASETS));
    ASSERT_TRUE(menu_->open(folder.path())) << "a folder of lessons opens its first";
    ASSERT_NO_FATAL_FAILURE(waitForPage());
    EXPECT_EQ(player()->lesson().name, "mine");
    EXPECT_TRUE(text().contains(QString::number(snapshot()->trace.steps.size())));
    EXPECT_THROW(writeNewLesson(made, scenario(), {}, {}), relief::InputError);
    EXPECT_FALSE(menu_->open(folder.filePath(QStringLiteral("none"))));
    EXPECT_TRUE(window_->messages()->isProblem());
    EXPECT_EQ(player()->lesson().name, "mine") << "the open lesson stays";
}

}  // namespace

}  // namespace reliefui
