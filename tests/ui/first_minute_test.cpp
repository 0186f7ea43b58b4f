// The first minute of a new user: the messages, the first view, the controls; later no message is outdated.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QSettings>
#include <QStyleOptionToolButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include "lessons/lessons.h"
#include "panes/file_dialogs.h"
#include "panes/profile/profile_view.h"
#include "window_fixture.h"
#include "windows/message_bar.h"
#include "windows/pane_title.h"
#include "windows/program.h"
#include "windows/top_bar.h"
#include "windows/window_style.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 20000;

class FirstMinute : public WindowTest {
  protected:
    MessageBar* messages() { return window_->messages(); }
    bool rowIsThere() { return window_->findChild<QToolBar*>(QStringLiteral("messages"))->isVisible(); }
    void trigger(const char* action) { window_->findChild<QAction*>(QLatin1String(action))->trigger(); }
    QAction* entry(const QKeySequence& keys) {
        for (QAction* const action : window_->findChildren<QAction*>()) {
            if (action->shortcut() == keys) return action;
        }
        return nullptr;
    }
};

TEST_F(FirstMinute, AWelcomeIsShownOnce) {
    QSettings().remove(QStringLiteral("welcomed"));
    openWindow(smallScenario());
    EXPECT_FALSE(messages()->isVisible());
    window_->welcome();
    EXPECT_TRUE(messages()->isVisible());
    for (const char* const thing : {"pixel", ",", "drag", "F1"}) {
        EXPECT_TRUE(messages()->text().contains(QLatin1String(thing))) << thing;
    }
    messages()->close();
    window_->welcome(true);
    EXPECT_TRUE(messages()->isVisible()) << "a start anew";
    messages()->close();
    window_->welcome();
    EXPECT_FALSE(messages()->isVisible());
}

TEST_F(FirstMinute, ARayIsShownFromItsFirstStep) {
    openWindow(deepRay());
    const auto choose = [&](int x, int y) {
        workspace_->choosePixel(x, y);
        waitForFull();
        return scenario().step;
    };
    workspace_->chooseStep(3);
    EXPECT_EQ(choose(60, 50), 0);
    // Also after the last step was chosen.
    workspace_->chooseStep(static_cast<int>(snapshot()->trace.steps.size()) - 1);
    EXPECT_EQ(choose(100, 75), 0);
    // The menu offers to start at the ray's end, and the choice is kept.
    workspace_->setRaysFromEnd(true);
    const int last = choose(60, 50);
    EXPECT_GT(last, 0);
    EXPECT_EQ(last, static_cast<int>(snapshot()->trace.steps.size()) - 1);
}

TEST_F(FirstMinute, MethodsHaveNamesAndSources) {
    openWindow(smallScenario());
    const QComboBox* const list = window_->topBar()->method();
    EXPECT_EQ(list->currentData().toString().toStdString(), scenario().method.name);
    int named = 0;
    for (const relief::MethodDescription& method : relief::tracerList()) {
        const int at = list->findData(QString::fromStdString(method.name));
        if (at < 0) continue;
        EXPECT_EQ(list->itemText(at).toLower().toStdString(), method.title);
        EXPECT_EQ(list->itemData(at, Qt::UserRole + 1).toString().toStdString(), method.source);
        ++named;
    }
    EXPECT_GT(named, 15);
    const QComboBox* const filters = window_->topBar()->findChild<QComboBox*>(QStringLiteral("filter"));
    for (const relief::FilterDescription& filter : relief::filterList()) {
        const int at = filters->findData(QString::fromStdString(filter.name));
        ASSERT_GE(at, 0) << filter.name;
        EXPECT_EQ(filters->itemText(at).toLower().toStdString(), filter.title);
        EXPECT_FALSE(filter.title.empty()) << filter.name;
    }
}

TEST_F(FirstMinute, NoMessageOutlivesWhatItSpeaksOf) {
    openWindow(smallScenario());
    const QTemporaryDir folder;
    QFile(folder.filePath(QStringLiteral("empty.png"))).open(QIODevice::WriteOnly);
    workspace_->open(folder.filePath(QStringLiteral("empty.png")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return messages()->isVisible(); }, kPatienceMs));
    EXPECT_TRUE(messages()->isProblem());
    EXPECT_TRUE(rowIsThere());
    workspace_->open(QStringLiteral(RELIEF_DATASETS "/gray_rocks/height.png"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !scenario().pictures.height.empty(); }, kPatienceMs));
    EXPECT_FALSE(messages()->isVisible() && messages()->isProblem());
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    // The message of a lesson disappears when the lesson is left.
    window_->openLesson(QStringLiteral("vain_descent"));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return scenario() == lessonScenario(QStringLiteral("vain_descent")); }, kPatienceMs));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    EXPECT_TRUE(messages()->isVisible());
    workspace_->chooseStep(1);
    EXPECT_TRUE(messages()->isVisible()) << "it is still the lesson";
    window_->startAnew();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !messages()->isVisible(); }, kPatienceMs));
    EXPECT_FALSE(rowIsThere());
    // The message about an impossible change disappears after a possible one.
    relief::Scenario impossible = scenario();
    impossible.width = 100000;
    impossible.height = 100000;
    workspace_->change(impossible, QStringLiteral("test"));
    EXPECT_TRUE(messages()->isVisible());
    QTest::qWait(50);
    EXPECT_TRUE(messages()->isVisible()) << "it is to be read";
    relief::Scenario possible = scenario();
    possible.reliefDepth += 0.05;
    workspace_->change(possible, QStringLiteral("test"));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    EXPECT_FALSE(messages()->isVisible());
}

TEST_F(FirstMinute, AClosedNoteLeavesNoEmptyRow) {
    openWindow(lessonScenario(QStringLiteral("vain_descent")));
    window_->showLesson();
    auto* const profile = window_->findChild<QDockWidget*>(QStringLiteral("profile-pane"));
    auto* const title = qobject_cast<PaneTitle*>(profile->titleBarWidget());
    Q_EMIT title->fillRequested();
    EXPECT_TRUE(rowIsThere()) << "the lesson's text is seen in a filled pane";
    messages()->close();
    EXPECT_FALSE(rowIsThere());
    Q_EMIT title->fillRequested();
    EXPECT_FALSE(rowIsThere());
    window_->resetLayout();
    EXPECT_FALSE(rowIsThere());
}

TEST_F(FirstMinute, AMessageHasRoomInALargerFont) {
    MessageBar bar;
    bar.resize(300, 100);
    bar.showNotice(QStringLiteral("a message of so many words that it takes more than one line"));
    const QList<QLabel*> labels = bar.findChildren<QLabel*>();
    const auto at =
        std::find_if(labels.begin(), labels.end(), [&](QLabel* label) { return label->text() == bar.text(); });
    ASSERT_NE(at, labels.end());
    const int before = (*at)->minimumHeight();
    QFont larger = bar.font();
    larger.setPointSizeF(2 * larger.pointSizeF());
    bar.setFont(larger);
    EXPECT_GT((*at)->minimumHeight(), 2 * before);
}

TEST_F(FirstMinute, TheCameraComesHome) {
    relief::Scenario wall = smallScenario();
    wall.scene = relief::SceneKind::Wall;
    wall.camera.azimuth = -40;
    wall.camera.elevation = 12;
    openWindow(wall);
    const relief::Camera first = scenario().camera;
    // The camera never moves behind the wall, however far it is dragged.
    ResultView* const view = window_->result();
    const auto drag = [&](const QPoint& from, const QPoint& by) {
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
        for (int n = 1; n <= 10; ++n) {
            const QPoint at = from + by * n / 10;
            QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(view, &move);
        }
        QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, from + by);
        waitForFull();
    };
    for (const int way : {3000, -6000}) {
        drag(view->rect().center(), {way, 0});
        EXPECT_NE(scenario().camera, first);
        EXPECT_LT(std::abs(scenario().camera.azimuth), 90);
    }
    QTest::keyClick(view, Qt::Key_H);
    waitForFull();
    EXPECT_EQ(scenario().camera, first);
    workspace_->undo();
    waitForFull();
    EXPECT_NE(scenario().camera, first) << "a step of undo";
    // Another scenario has another home view.
    window_->openLesson(QStringLiteral("grazing_rays"));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return scenario() == lessonScenario(QStringLiteral("grazing_rays")); }, kPatienceMs));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    const relief::Camera lesson = scenario().camera;
    drag(view->rect().center(), {50, 30});
    QTest::keyClick(view, Qt::Key_H);
    EXPECT_EQ(scenario().camera, lesson);
}

TEST_F(FirstMinute, TheLanguageIsChosenInTheMenu) {
    openWindow(smallScenario());
    const QString english = window_->menuBar()->actions().front()->text();
    QString chosen = QStringLiteral("none");
    QObject::connect(window_.get(), &MainWindow::languageChosen, [&](const QString& language) { chosen = language; });
    trigger("language-uk");
    EXPECT_TRUE(QTest::qWaitFor([&] { return chosen == QStringLiteral("uk"); }, kPatienceMs));
    const relief::Camera home = scenario().camera;
    relief::Scenario turned = scenario();
    turned.camera.azimuth += 5;
    workspace_->change(turned, QStringLiteral("test"));
    workspace_->setLayer(Layer::Depth);
    EXPECT_EQ(window_->findChild<QComboBox*>(QStringLiteral("layer"))->currentIndex(), static_cast<int>(Layer::Depth));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    workspace_->chooseStep(1);
    workspace_->setGuessing(true);
    // The window is created again for the same workspace.
    const relief::Scenario before = scenario();
    const QVariantMap layout = window_->layoutNow();
    window_.reset();
    installTranslations(QStringLiteral("uk"));
    window_ = std::make_unique<MainWindow>(workspace_.get(), QString());
    window_->takeLayout(layout);
    window_->show();
    EXPECT_NE(window_->menuBar()->actions().front()->text(), english);
    EXPECT_EQ(scenario(), before);
    EXPECT_FALSE(window_->findChild<QLabel*>(QStringLiteral("status-pixel"))->text().isEmpty());
    EXPECT_EQ(window_->findChild<QComboBox*>(QStringLiteral("layer"))->currentIndex(), static_cast<int>(Layer::Depth));
    EXPECT_TRUE(window_->pane<ProfileView>()->options().guessing);
    EXPECT_TRUE(entry(Qt::Key_G)->isChecked());
    EXPECT_NE(translatedChangeName(workspace_->undoText()), workspace_->undoText()) << "the name of the step chosen";
    entry(Qt::Key_H)->trigger();
    EXPECT_EQ(scenario().camera, home);
    installTranslations({});
}

TEST_F(FirstMinute, HoverDoesNotLookLikeChecked) {
    const WindowStyle style;
    const auto drawn = [&](QStyle::State state) {
        QImage image(60, 24, QImage::Format_RGB32);
        image.fill(Qt::black);
        QPainter painter(&image);
        QStyleOptionToolButton option;
        option.rect = image.rect();
        option.state = state | QStyle::State_Enabled | QStyle::State_AutoRaise;
        style.drawPrimitive(QStyle::PE_PanelButtonTool, &option, &painter, nullptr);
        return image.pixelColor(30, 12);
    };
    const QColor plain = drawn(QStyle::State_None);
    const QColor hover = drawn(QStyle::State_MouseOver);
    const QColor on = drawn(QStyle::State_On);
    EXPECT_EQ(hover, plain) << "only its edge is drawn";
    EXPECT_NE(on, plain);
    EXPECT_EQ(drawn(QStyle::State_On | QStyle::State_MouseOver), on) << "it still looks checked";
}

TEST_F(FirstMinute, DialogsOpenInTheLastFolderOfTheirKind) {
    const QTemporaryDir maps;
    const QTemporaryDir figures;
    keepFolder(QStringLiteral("test-maps"), maps.filePath(QStringLiteral("a.png")));
    keepFolder(QStringLiteral("test-figures"), figures.filePath(QStringLiteral("b.svg")));
    EXPECT_EQ(lastFolder(QStringLiteral("test-maps"), QStringLiteral("/")), maps.path());
    EXPECT_EQ(lastFolder(QStringLiteral("test-figures")), figures.path());
    EXPECT_EQ(lastFolder(QStringLiteral("test-none"), QStringLiteral("/x")), QStringLiteral("/x"));
    keepFolder(QStringLiteral("test-maps"), {});
    EXPECT_EQ(lastFolder(QStringLiteral("test-maps")), maps.path()) << "a cancelled dialog changes nothing";
    QDir(maps.path()).removeRecursively();
    EXPECT_EQ(lastFolder(QStringLiteral("test-maps"), QStringLiteral("/x")), QStringLiteral("/x"));
}

TEST_F(FirstMinute, NoFileIsReplacedUnasked) {
    const QTemporaryDir folder;
    const QString kept = folder.filePath(QStringLiteral("kept.json"));
    ASSERT_TRUE(QFile(kept).open(QIODevice::WriteOnly));
    keepFolder(QStringLiteral("test"), kept);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QStringList typed{QStringLiteral("kept"), QStringLiteral("kept"), QStringLiteral("new")};
    QList<QMessageBox::StandardButton> answers{QMessageBox::No, QMessageBox::Yes};
    // The dialogs run event loops of their own.
    QTimer user;
    QObject::connect(&user, &QTimer::timeout, [&] {
        QWidget* const dialog = QApplication::activeModalWidget();
        if (dialog == nullptr) return;
        if (auto* const question = qobject_cast<QMessageBox*>(dialog)) {
            question->button(answers.isEmpty() ? QMessageBox::No : answers.takeFirst())->click();
        } else if (typed.isEmpty()) {
            QMetaObject::invokeMethod(dialog, "reject");
        } else if (auto* const name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))) {
            name->setText(typed.takeFirst());
            QMetaObject::invokeMethod(dialog, "accept");
        }
    });
    user.start(20);
    const auto ask = [] {
        return askSaveFile(nullptr, QStringLiteral("test"), QStringLiteral("Save"), QStringLiteral("scenario.json"),
                           QStringLiteral("Scenarios (*.json)"));
    };
    EXPECT_EQ(ask(), kept);
    EXPECT_TRUE(answers.isEmpty()) << "after No, another name can be given";
    EXPECT_EQ(ask(), folder.filePath(QStringLiteral("new.json")));
    user.stop();
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs, false);
}

}  // namespace

}  // namespace reliefui
