// The autosaved state of a window: it exists after a crash, is removed at a regular end, and is never another
// process's.
#include <fstream>

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "window_fixture.h"
#include "windows/bookmarks.h"
#include "windows/message_bar.h"
#include "windows/pane_list.h"
#include "windows/program.h"
#include "windows/restore_offer.h"
#include "workspace/change_name.h"
#include "workspace/last_state.h"
#include "workspace/pane_store.h"
#include "workspace/state_keeper.h"
#include "x_keys.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 120000;
static_assert(2 * StateKeeper::kEveryMs < 10000, "what a crash may cost");

class SessionTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (IsSkipped()) return;
        before_ = QFileInfo(settingsFolder()).path();
        useFolder(folder_.path());
    }
    void TearDown() override {
        keeper_.reset();
        WindowTest::TearDown();
        if (!before_.isEmpty()) useFolder(before_);
    }
    static void useFolder(const QString& folder) {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder);
    }
    static QStringList unfinished() { return QDir(settingsFolder()).entryList({QStringLiteral("unfinished-*")}); }
    void open(const relief::Scenario& scenario) {
        openWindow(scenario);
        keeper_ = std::make_unique<StateKeeper>(workspace_.get(), SessionFiles::begin(), this->scenario(),
                                                [this] { return window_->layoutNow(); });
        keeper_->setInterval(20);
    }
    // Writes a scenario as a process that has ended would have left it.
    static QString leave(const relief::Scenario& scenario, const QString& id = QStringLiteral("1-1")) {
        QDir().mkpath(settingsFolder());
        const QString file = settingsFolder() + QStringLiteral("/unfinished-") + id + QStringLiteral(".json");
        relief::saveScenario(file.toStdString(), scenario);
        return file;
    }
    MessageBar* question() { return window_->question(); }
    void answer(const char* button) {
        QTest::mouseClick(question()->findChild<QPushButton*>(QString::fromLatin1(button)), Qt::LeftButton);
    }

    QTemporaryDir folder_;
    QString before_;
    std::unique_ptr<StateKeeper> keeper_;
};

TEST_F(SessionTest, AChangeIsSavedAndACleanEndLeavesNothing) {
    open(smallScenario());
    QTest::qWait(100);
    EXPECT_TRUE(unfinished().filter(QStringLiteral(".json")).isEmpty()) << "nothing was changed";
    workspace_->setBookmarks({{"a", {60, 50}, scenario().camera, 0}}, QStringLiteral("bookmark"));
    const auto saved = [&] {
        const QStringList files = unfinished().filter(QStringLiteral(".json"));
        return files.size() == 1 &&
               loadWindowScenario((settingsFolder() + '/' + files[0]).toStdString(), stateReaders()) == scenario();
    };
    EXPECT_TRUE(QTest::qWaitFor(saved, kPatienceMs));
    EXPECT_EQ(unfinished().filter(QStringLiteral(".ini")).size(), 1) << "the layout is saved, too";
    EXPECT_TRUE(unfinished().filter(QStringLiteral(".starting")).isEmpty()) << "the start is over";
    // A window that starts now does not take it.
    EXPECT_TRUE(SessionFiles::leftBehind().empty());
    EXPECT_TRUE(saved());
    EXPECT_EQ(keeper_->end(), "");
    EXPECT_TRUE(unfinished().isEmpty()) << unfinished().join(' ').toStdString();
    relief::AssetStore store;
    EXPECT_EQ(lastState(store, stateReaders()), scenario());
}

TEST_F(SessionTest, WhatWasLeftIsOfferedAndRestored) {
    relief::Scenario left = smallScenario();
    left.bookmarks = {{"a", {60, 50}, left.camera, 0}};
    const QString file = leave(left);
    auto found = SessionFiles::leftBehind();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(SessionFiles::leftBehind().empty()) << "a second window does not offer it as well";
    open(smallScenario());
    new RestoreOffer(window_.get(), workspace_.get(), keeper_.get(), std::move(found));
    EXPECT_TRUE(question()->isVisible());
    EXPECT_TRUE(scenario().bookmarks.empty()) << "nothing is restored without confirmation";
    answer("restore");
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario() == left && !workspace_->busy(); }, kPatienceMs));
    EXPECT_FALSE(question()->isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !QFileInfo::exists(file); }, kPatienceMs))
        << "it was saved as this window's state";
    EXPECT_EQ(unfinished().filter(QStringLiteral(".json")).size(), 1);
    workspace_->undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario().bookmarks.empty(); }, kPatienceMs));
    EXPECT_EQ(keeper_->end(), "");
    EXPECT_TRUE(unfinished().isEmpty()) << unfinished().join(' ').toStdString();
}

TEST_F(SessionTest, WhoDoesNotAnswerIsAskedAgain) {
    relief::Scenario gone = smallScenario();
    gone.pictures = {};
    gone.pictures.height = "/nowhere/height.png";
    const QString lost = leave(gone, QStringLiteral("1-1"));
    open(smallScenario());
    {
        const RestoreOffer offer(window_.get(), workspace_.get(), keeper_.get(), SessionFiles::leftBehind());
        answer("restore");
        EXPECT_TRUE(QTest::qWaitFor([&] { return window_->messages()->isVisible(); }, kPatienceMs)) << "why not";
        // Meanwhile this window's own state is saved in another file.
        workspace_->setBookmarks({{"a", {60, 50}, scenario().camera, 0}}, QStringLiteral("bookmark"));
        const auto both = [] { return unfinished().filter(QStringLiteral(".json")).size() == 2; };
        EXPECT_TRUE(QTest::qWaitFor(both, kPatienceMs));
        QTest::qWait(100);
        EXPECT_TRUE(QFileInfo::exists(lost)) << "it was saved but not yet shown";
        EXPECT_EQ(keeper_->end(), "");
        keeper_.reset();
    }
    EXPECT_TRUE(QFileInfo::exists(lost)) << "its picture may exist again later";
    auto found = SessionFiles::leftBehind();
    ASSERT_EQ(found.size(), 1U);
    const RestoreOffer offer(window_.get(), workspace_.get(), nullptr, std::move(found));
    EXPECT_TRUE(question()->isVisible());
    // The buttons of the previous offer are no longer connected.
    for (QPushButton* const button : question()->findChildren<QPushButton*>(QStringLiteral("discard"))) button->click();
    EXPECT_FALSE(question()->isVisible());
    EXPECT_FALSE(QFileInfo::exists(lost));
}

// When the language changes, the window is created again and asks in that language; names of undo steps change as well.
TEST_F(SessionTest, AnotherLanguageAsksAgain) {
    leave(smallScenario());
    open(smallScenario());
    workspace_->setBookmarks({{"a", {60, 50}, scenario().camera, 0}},
                             changeName([] { return BookmarkMenu::tr("Add bookmark"); }));
    auto* offer = new RestoreOffer(window_.get(), workspace_.get(), keeper_.get(), SessionFiles::leftBehind());
    ASSERT_TRUE(question()->isVisible());
    EXPECT_TRUE(question()->text().contains(QStringLiteral("Reliefscope ended"))) << question()->text().toStdString();
    installTranslations(QStringLiteral("uk"));
    auto left = offer->unanswered();
    ASSERT_EQ(left.size(), 1U);
    window_ = std::make_unique<MainWindow>(workspace_.get(), QString());
    window_->show();
    offer = new RestoreOffer(window_.get(), workspace_.get(), keeper_.get(), std::move(left));
    EXPECT_TRUE(question()->isVisible());
    EXPECT_FALSE(question()->text().contains(QStringLiteral("ended"))) << question()->text().toStdString();
    const auto undo = [&] {
        for (const QAction* const action : window_->findChildren<QAction*>()) {
            if (action->shortcut() == QKeySequence::Undo) return action->text();
        }
        return QString();
    };
    EXPECT_EQ(undo(), MainWindow::tr("&Undo") + QStringLiteral(": ") + BookmarkMenu::tr("Add bookmark"));
    EXPECT_FALSE(undo().contains(QStringLiteral("bookmark")));
    // After the question is closed, this run does not ask again.
    question()->close();
    EXPECT_TRUE(offer->unanswered().empty());
    installTranslations({});
}

TEST_F(SessionTest, ADamagedFileIsNotOffered) {
    std::ofstream(leave(smallScenario()).toStdString()) << "{";
    openWindow(smallScenario());
    const RestoreOffer offer(window_.get(), workspace_.get(), nullptr, SessionFiles::leftBehind());
    EXPECT_FALSE(question()->isVisible());
}

TEST_F(SessionTest, AStateThatEndedTheStartIsNotTriedAgain) {
    ASSERT_EQ(keepState(smallScenario()), "");
    std::ofstream((settingsFolder() + QStringLiteral("/unfinished-1-1.starting")).toStdString());
    auto found = SessionFiles::leftBehind();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].failedToStart());
    EXPECT_EQ(loadWindowScenario(found[0].scenarioFile().toStdString(), stateReaders()), smallScenario());
    relief::AssetStore store;
    EXPECT_FALSE(lastState(store, stateReaders()));
    found.clear();
    EXPECT_FALSE(SessionFiles::leftBehind().at(0).failedToStart()) << "said once";
}

// A window that is closed while the first pictures are being loaded.
TEST_F(SessionTest, WithoutAFirstPictureTheLastStateStays) {
    ASSERT_EQ(keepState(smallScenario()), "");
    Workspace workspace;
    StateKeeper keeper(&workspace, SessionFiles::begin(), smallScenario(), [] { return QVariantMap(); });
    EXPECT_EQ(keeper.end(), "");
    EXPECT_TRUE(unfinished().isEmpty()) << unfinished().join(' ').toStdString();
    relief::AssetStore store;
    EXPECT_EQ(lastState(store, stateReaders()), smallScenario());
}

TEST_F(SessionTest, WhereNothingCanBeWrittenThereIsOneMessage) {
    const QString file = folder_.filePath(QStringLiteral("file"));
    std::ofstream(file.toStdString()) << "no folder";
    useFolder(file);
    openWindow(smallScenario());
    StateKeeper keeper(workspace_.get(), SessionFiles::begin(), scenario(), [] { return QVariantMap(); });
    keeper.setInterval(20);
    QSignalSpy problems(&keeper, &StateKeeper::problem);
    workspace_->choosePixel(30, 40);
    QTest::qWait(300);
    workspace_->choosePixel(31, 40);
    QTest::qWait(300);
    EXPECT_EQ(problems.count(), 1);
    EXPECT_NE(keeper.end(), "");
}

// The program itself: a key is pressed, and it is killed some seconds later; the next start offers the state.
TEST_F(SessionTest, KillingTheProgramCostsSeconds) {
    const QString file = folder_.filePath(QStringLiteral("small.json"));
    relief::Scenario first = smallScenario();
    first.step = 3;
    relief::saveScenario(file.toStdString(), first);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder_.path());
    const auto start = [&](QProcess& process, const QStringList& arguments) {
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        process.start(QStringLiteral(RELIEFSCOPE), arguments);
        return process.waitForStarted();
    };
    const auto saved = [&]() -> std::optional<relief::Scenario> {
        const QStringList files = unfinished().filter(QStringLiteral(".json"));
        if (files.isEmpty()) return std::nullopt;
        return loadWindowScenario((settingsFolder() + '/' + files[0]).toStdString(), stateReaders());
    };
    QProcess process;
    ASSERT_TRUE(start(process, {file}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return sendKey(process.processId(), "Home"); }, kPatienceMs)) << "no window";
    // The steps exist when the first picture does.
    const auto arrived = [&] {
        sendKey(process.processId(), "Home");
        const auto now = saved();
        return now && now->step == 0;
    };
    ASSERT_TRUE(QTest::qWaitFor(arrived, kPatienceMs)) << "not saved";
    process.kill();  // SIGKILL
    process.waitForFinished();
    first.step = 0;
    EXPECT_EQ(saved(), first);
    // The next process takes over the file in order to offer it.
    ASSERT_TRUE(start(process, {file}));
    const QString lock =
        settingsFolder() + '/' + unfinished().filter(QStringLiteral(".json"))[0].replace(".json", ".lock");
    const auto offered = [&] {
        QLockFile other(lock);
        qint64 owner = 0;
        QString host;
        QString program;
        return other.getLockInfo(&owner, &host, &program) && owner == process.processId();
    };
    EXPECT_TRUE(QTest::qWaitFor(offered, kPatienceMs));
    process.kill();
    process.waitForFinished();
    const auto left = SessionFiles::leftBehind();
    ASSERT_EQ(left.size(), 1U) << "the second process left no file";
    EXPECT_EQ(loadWindowScenario(left[0].scenarioFile().toStdString(), stateReaders()), first);
}

// The next start opens the last state without a question.
TEST_F(SessionTest, AMisspeltLessonIsNoCrash) {
    ASSERT_EQ(keepState(smallScenario()), "");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder_.path());
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RELIEFSCOPE), {QStringLiteral("--lesson"), QStringLiteral("3o1")});
    ASSERT_TRUE(process.waitForFinished(kPatienceMs));
    EXPECT_EQ(process.exitCode(), 2);
    EXPECT_TRUE(unfinished().isEmpty()) << unfinished().join(' ').toStdString();
    relief::AssetStore store;
    EXPECT_EQ(lastState(store, stateReaders()), smallScenario());
}

// A shutdown of the system asks every program to end; that is no crash.
TEST_F(SessionTest, AskingTheProgramToEndLeavesNothing) {
    const QString file = folder_.filePath(QStringLiteral("small.json"));
    relief::saveScenario(file.toStdString(), smallScenario());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder_.path());
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(QStringLiteral(RELIEFSCOPE), {file});
    ASSERT_TRUE(process.waitForStarted());
    ASSERT_TRUE(QTest::qWaitFor([&] { return sendKey(process.processId(), "Home"); }, kPatienceMs)) << "no window";
    process.terminate();  // SIGTERM
    ASSERT_TRUE(QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatienceMs));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 0);
    EXPECT_TRUE(unfinished().isEmpty()) << unfinished().join(' ').toStdString();
}

}  // namespace

}  // namespace reliefui
