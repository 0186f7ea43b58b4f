// Displays that close while the program runs, and displays without OpenGL. Each test has an X server of its own.
#include <csignal>

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "measuring/random_rays.h"
#include "window_fixture.h"
#include "windows/pane_list.h"
#include "workspace/last_state.h"
#include "workspace/pane_store.h"
#include "workspace/session_files.h"
#include "x_keys.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 120000;

// An X server that ends with this object, or earlier.
class Screen {
  public:
    explicit Screen(const QStringList& more = {}) {
        server_.setStandardErrorFile(QProcess::nullDevice());
        server_.start(QStringLiteral("Xvfb"),
                      QStringList{QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-noreset"),
                                  QStringLiteral("-nolisten"), QStringLiteral("tcp"), QStringLiteral("-screen"),
                                  QStringLiteral("0"), QStringLiteral("1280x800x24")} +
                          more);
        // The server chooses a free number, and writes it when it is ready.
        while (server_.state() != QProcess::NotRunning && !server_.canReadLine()) server_.waitForReadyRead(kPatienceMs);
        const QByteArray number = server_.readLine().trimmed();
        if (!number.isEmpty()) name_ = ":" + number;
    }
    ~Screen() { kill(); }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    const QByteArray& name() const { return name_; }
    void kill() {
        server_.kill();
        server_.waitForFinished();
    }

  private:
    QProcess server_;
    QByteArray name_;
};

// Makes functions of Xlib use another display than the tests' own.
class OnDisplay {
  public:
    explicit OnDisplay(const QByteArray& name) : before_(qgetenv("DISPLAY")) { qputenv("DISPLAY", name); }
    ~OnDisplay() { qputenv("DISPLAY", before_); }
    OnDisplay(const OnDisplay&) = delete;
    OnDisplay& operator=(const OnDisplay&) = delete;

  private:
    QByteArray before_;
};

class DisplayTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (IsSkipped()) return;
        if (QStandardPaths::findExecutable(QStringLiteral("Xvfb")).isEmpty()) GTEST_SKIP() << "there is no Xvfb";
        before_ = QFileInfo(settingsFolder()).path();
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        scenario_ = smallScenario();
        scenario_.step = 3;
        file_ = folder_.filePath(QStringLiteral("small.json"));
        relief::saveScenario(file_.toStdString(), scenario_);
    }
    void TearDown() override {
        WindowTest::TearDown();
        if (!before_.isEmpty()) QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, before_);
    }

    bool start(QProcess& process, const Screen& screen, const QStringList& arguments,
               const QStringList& variables = {}) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder_.path());
        environment.insert(QStringLiteral("DISPLAY"), QString::fromLatin1(screen.name()));
        environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
        for (const QString& variable : variables) {
            environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
        }
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(RELIEFSCOPE), arguments);
        return process.waitForStarted();
    }
    static bool ended(QProcess& process) {
        return QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatienceMs);
    }
    static QStringList saved() { return QDir(settingsFolder()).entryList({QStringLiteral("unfinished-*.json")}); }
    // The state that the next start would offer.
    static std::optional<relief::Scenario> offered() {
        const QStringList files = saved();
        if (files.isEmpty()) return std::nullopt;
        return loadWindowScenario((settingsFolder() + '/' + files[0]).toStdString(), stateReaders());
    }
    static void expectOneLine(QProcess& process, const QByteArray& contains) {
        const QByteArray said = process.readAllStandardError();
        EXPECT_EQ(said.count('\n'), 1) << said.toStdString();
        EXPECT_TRUE(said.startsWith("reliefscope: ")) << said.toStdString();
        EXPECT_TRUE(said.contains(contains)) << said.toStdString();
    }

    QTemporaryDir folder_;
    QString before_, file_;
    relief::Scenario scenario_;
};

// The last change is newer than any autosave: it is saved when the display goes.
TEST_F(DisplayTest, WhenItGoesTheStateIsKeptAndOneLineSaysSo) {
    Screen screen;
    ASSERT_FALSE(screen.name().isEmpty());
    QProcess process;
    ASSERT_TRUE(start(process, screen, {file_}));
    const auto press = [&](const char* key) {
        const OnDisplay other(screen.name());
        return sendKey(process.processId(), key);
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return press("Home"); }, kPatienceMs)) << "no window";
    const auto arrived = [&] {
        press("Home");
        const auto now = offered();
        return now && now->step == 0;
    };
    ASSERT_TRUE(QTest::qWaitFor(arrived, kPatienceMs)) << "not saved";
    ASSERT_TRUE(press("period"));
    QTest::qWait(500);
    screen.kill();
    ASSERT_TRUE(ended(process));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 1);
    expectOneLine(process, "the display " + screen.name() + " has gone; the state of the window is kept");
    scenario_.step = 1;
    EXPECT_EQ(offered(), scenario_);
    const auto left = SessionFiles::leftBehind();
    EXPECT_EQ(left.size(), 1U) << "the next start does not offer it";
}

TEST_F(DisplayTest, AtAnyMomentOfTheStartItEndsInOneLine) {
    relief::Random random(3);
    const int times = std::getenv("RELIEF_LONG") != nullptr ? 100 : 3;
    for (int n = 0; n < times; ++n) {
        Screen screen;
        ASSERT_FALSE(screen.name().isEmpty());
        QProcess process;
        ASSERT_TRUE(start(process, screen, {file_}));
        const int after = random.below(1500);
        SCOPED_TRACE("after " + std::to_string(after) + " ms");
        QTest::qWait(after);
        screen.kill();
        ASSERT_TRUE(ended(process));
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_TRUE(process.exitCode() == 1 || process.exitCode() == 2) << process.exitCode();
        expectOneLine(process, screen.name());
        for (const QString& file : saved()) {
            EXPECT_NO_THROW(loadWindowScenario((settingsFolder() + '/' + file).toStdString(), stateReaders()));
        }
    }
}

// Libraries that read a reply which did not come crash. The signals wait until the process goes on, so that the crash
// comes first.
TEST_F(DisplayTest, ACrashOfALibraryBecauseItWentIsOneLineToo) {
    for (const bool gone : {true, false}) {
        Screen screen;
        ASSERT_FALSE(screen.name().isEmpty());
        QProcess process;
        ASSERT_TRUE(start(process, screen, {file_}));
        const auto press = [&] {
            const OnDisplay other(screen.name());
            return sendKey(process.processId(), "Home");
        };
        ASSERT_TRUE(QTest::qWaitFor(press, kPatienceMs)) << "no window";
        const auto id = static_cast<pid_t>(process.processId());
        ::kill(id, SIGSTOP);
        if (gone) screen.kill();
        ::kill(id, SIGSEGV);
        ::kill(id, SIGCONT);
        ASSERT_TRUE(ended(process));
        EXPECT_EQ(process.exitStatus(), gone ? QProcess::NormalExit : QProcess::CrashExit);
        EXPECT_EQ(process.exitCode(), gone ? 1 : SIGSEGV);
        if (gone) expectOneLine(process, "the display " + screen.name() + " has gone");
    }
}

// Neither through GLX nor, as Qt tries then, through EGL.
TEST_F(DisplayTest, WithoutOpenGlTheOtherPanesWork) {
    const Screen screen({QStringLiteral("-extension"), QStringLiteral("GLX")});
    ASSERT_FALSE(screen.name().isEmpty());
    for (const QStringList& variables : {QStringList{}, QStringList{QStringLiteral("QT_XCB_GL_INTEGRATION=none")}}) {
        const QString picture = folder_.filePath(QStringLiteral("window.png"));
        QProcess process;
        ASSERT_TRUE(start(process, screen, {QStringLiteral("--screenshot"), picture, file_}, variables));
        ASSERT_TRUE(ended(process));
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(process.exitCode(), 0);
        EXPECT_EQ(process.readAllStandardError().toStdString(), "");
        EXPECT_GT(colorsIn(QImage(picture)), 100);
        QFile::remove(picture);
    }
    QProcess check;
    ASSERT_TRUE(start(check, screen, {QStringLiteral("--check-display")}));
    ASSERT_TRUE(ended(check));
    EXPECT_EQ(check.exitCode(), 0);
}

}  // namespace

}  // namespace reliefui
