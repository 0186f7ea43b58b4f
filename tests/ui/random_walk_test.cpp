// Random operation of all controls: buttons, lists, sliders, numbers, menus, keys, the mouse in every pane. The window
// must survive, Qt and VTK must not report errors, memory must not grow without limit, and undo must still lead back.
#include <algorithm>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <random>

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTableView>
#include <QThreadPool>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include "../memory_use.h"
#include "crash_report.h"
#include "panes/drawing_canvas.h"
#include "window_fixture.h"
#include "windows/program.h"

namespace reliefui {
namespace {

using relief::test::usedMegabytes;

constexpr std::uint64_t kSeed = 20261121;  // set RELIEF_SEED for another one
constexpr int kShortMs = 30000;            // of a round
// Of a long walk (RELIEF_LONG). The number of rounds is RELIEF_ROUNDS, default 2; the window's language is
// RELIEF_WALK_LANGUAGE (en, uk), default that of the system.
constexpr int kLongMs = 300000;
// Dialogs and menus are closed as soon as they appear.
constexpr int kDismissMs = 40;
constexpr qint64 kLongestStepMs = 5000;
constexpr int kEndMs = 120000;
constexpr int kMostUndone = 100000;
constexpr int kEmptiedMs = 4000;  // twice the delay after which the window frees a closed pane
constexpr std::size_t kRemembered = 25;
// Memory that may remain in use after everything is undone, in addition to the cached maps: among others, resources of
// opened panes, since a walk of a thousand steps opens all of them. Measured: 33 to 480.
constexpr double kOpenMegabytes = 600;
// The same after the panes are closed and the maps are freed. Measured: 7 to 42, rising and falling.
constexpr double kGrowthMegabytes = 80;
// The same after the window is destroyed. Measured: -35 to -20.
constexpr double kLeftMegabytes = 20;

// Controls that are made when they are first shown, after the first round. Measured: up to 1.09.
constexpr double kMoreObjects = 1.1;

QStringList& complaints() {
    static QStringList all;
    return all;
}

void noteQt(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtDebugMsg || type == QtInfoMsg) return;
    // The X server's error when the focus cannot be set, since there is no window manager.
    if (text.startsWith(QLatin1String("QXcbConnection: XCB error")) && text.contains(QLatin1String("SetInputFocus"))) {
        return;
    }
    complaints() << QStringLiteral("Qt: ") + text;
}

class NotingOutput : public vtkOutputWindow {
  public:
    static NotingOutput* New();
    vtkTypeMacro(NotingOutput, vtkOutputWindow) void DisplayText(const char* text) override {
        complaints() << QStringLiteral("VTK: ") + QString::fromUtf8(text);
    }

  protected:
    NotingOutput() = default;
};
vtkStandardNewMacro(NotingOutput)

    class Walk {
  public:
    Walk(QWidget* window, std::uint64_t seed) : window_(window), random_(seed) {
        QObject::connect(&dismiss_, &QTimer::timeout, [] {
            if (QWidget* const popup = QApplication::activePopupWidget()) popup->close();
            QWidget* const modal = QApplication::activeModalWidget();
            if (auto* const dialog = qobject_cast<QDialog*>(modal)) {
                dialog->reject();
            } else if (modal != nullptr) {
                modal->close();
            }
        });
        dismiss_.start(kDismissMs);
    }

    void step() {
        const auto widgets = window_->findChildren<QWidget*>();
        switch (random_() % 8) {
            case 0:
                return action();
            case 1:
                return key();
            case 2:
            case 3:
                return mouse(widgets);
            default:
                return control(widgets);
        }
    }
    QString story() const {
        QStringList all;
        for (const QString& line : story_) all << line;
        return all.join(QStringLiteral("\n"));
    }

  private:
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    void note(const QString& text) {
        story_.push_back(text);
        rememberForCrash(text.toStdString());
        // Prints each step, to follow a walk.
        if (std::getenv("RELIEF_WALK") != nullptr) std::fprintf(stderr, "%s\n", qPrintable(text));
        if (story_.size() > kRemembered) story_.pop_front();
    }
    static QString describe(const QWidget* widget) {
        return QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName() +
               QLatin1Char(' ') + widget->accessibleName();
    }

    void action() {
        std::vector<QAction*> actions;
        for (QAction* const candidate : window_->findChildren<QAction*>()) {
            const bool ends = candidate->menuRole() == QAction::QuitRole ||
                              candidate->shortcut() == QKeySequence(QKeySequence::Quit) ||
                              candidate->shortcut() == QKeySequence(QKeySequence::Close);
            if (candidate->isEnabled() && !candidate->isSeparator() && candidate->menu() == nullptr && !ends) {
                actions.push_back(candidate);
            }
        }
        if (actions.empty()) return;
        QAction* const chosen = actions[static_cast<std::size_t>(below(static_cast<int>(actions.size())))];
        note(QStringLiteral("action ") + chosen->text() + QLatin1Char(' ') + chosen->objectName());
        chosen->trigger();
    }

    void key() {
        static const std::vector<std::pair<Qt::Key, Qt::KeyboardModifiers>> keys{
            {Qt::Key_Comma, Qt::NoModifier},
            {Qt::Key_Period, Qt::NoModifier},
            {Qt::Key_Home, Qt::NoModifier},
            {Qt::Key_End, Qt::NoModifier},
            {Qt::Key_Space, Qt::NoModifier},
            {Qt::Key_Left, Qt::NoModifier},
            {Qt::Key_Right, Qt::ShiftModifier},
            {Qt::Key_Up, Qt::NoModifier},
            {Qt::Key_Down, Qt::ShiftModifier},
            {Qt::Key_Z, Qt::ControlModifier},
            {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier},
            {Qt::Key_R, Qt::NoModifier},
            {Qt::Key_F11, Qt::NoModifier},
            {Qt::Key_Escape, Qt::NoModifier}};
        if (below(3) == 0) {
            const auto digit = static_cast<Qt::Key>(Qt::Key_0 + below(10));
            note(QStringLiteral("key %1").arg(digit - Qt::Key_0));
            QTest::keyClick(window_, digit);
            return;
        }
        const auto& [chosen, modifiers] = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
        note(QStringLiteral("key ") + QKeySequence(chosen).toString());
        QWidget* const focus = QApplication::focusWidget();
        QTest::keyClick(focus != nullptr ? focus : window_, chosen, modifiers);
    }

    void mouse(const QList<QWidget*>& widgets) {
        std::vector<QWidget*> panes;
        for (QWidget* const widget : widgets) {
            const bool drawn =
                qobject_cast<DrawingCanvas*>(widget) != nullptr || qobject_cast<ResultView*>(widget) != nullptr ||
                widget->inherits("QVTKOpenGLNativeWidget") || qobject_cast<QTableView*>(widget) != nullptr;
            if (drawn && widget->isVisible() && widget->width() > 4 && widget->height() > 4) panes.push_back(widget);
        }
        if (panes.empty()) return;
        QWidget* const pane = panes[static_cast<std::size_t>(below(static_cast<int>(panes.size())))];
        const auto place = [&] { return QPoint(below(pane->width()), below(pane->height())); };
        const Qt::MouseButton button = below(5) == 0 ? Qt::RightButton : Qt::LeftButton;
        const Qt::KeyboardModifiers modifiers = below(4) == 0 ? Qt::ControlModifier : Qt::NoModifier;
        const QPoint from = place();
        switch (below(4)) {
            case 0:
                note(QStringLiteral("click ") + describe(pane));
                QTest::mouseClick(pane, button, modifiers, from);
                break;
            case 1: {
                note(QStringLiteral("drag ") + describe(pane));
                const QPoint to = place();
                QTest::mousePress(pane, Qt::LeftButton, modifiers, from);
                for (int i = 1; i <= 3; ++i) QTest::mouseMove(pane, from + (to - from) * i / 3);
                QTest::mouseRelease(pane, Qt::LeftButton, modifiers, to);
                break;
            }
            case 2: {
                note(QStringLiteral("wheel ") + describe(pane));
                QWheelEvent event(from, pane->mapToGlobal(from), {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton,
                                  modifiers, Qt::NoScrollPhase, false);
                QApplication::sendEvent(pane, &event);
                break;
            }
            default:
                note(QStringLiteral("hover ") + describe(pane));
                QTest::mouseMove(pane, from);
        }
    }

    void control(const QList<QWidget*>& widgets) {
        std::vector<QWidget*> all;
        for (QWidget* const widget : widgets) {
            const bool ours =
                qobject_cast<QAbstractButton*>(widget) != nullptr || qobject_cast<QComboBox*>(widget) != nullptr ||
                qobject_cast<QAbstractSlider*>(widget) != nullptr ||
                qobject_cast<QAbstractSpinBox*>(widget) != nullptr || qobject_cast<QTabBar*>(widget) != nullptr;
            if (ours && widget->isVisible() && widget->isEnabled()) all.push_back(widget);
        }
        if (all.empty()) return;
        QWidget* const chosen = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
        note(QStringLiteral("use ") + describe(chosen));
        if (auto* const button = qobject_cast<QAbstractButton*>(chosen)) {
            QTest::mouseClick(button, Qt::LeftButton);
        } else if (auto* const tabs = qobject_cast<QTabBar*>(chosen)) {
            if (tabs->count() > 0) tabs->setCurrentIndex(below(tabs->count()));
        } else if (qobject_cast<QAbstractSpinBox*>(chosen) != nullptr) {
            static const QStringList texts{QStringLiteral("0"),   QStringLiteral("-1"),   QStringLiteral("1e9"),
                                           QStringLiteral("abc"), QStringLiteral("12.5"), QString(),
                                           QStringLiteral("33")};
            if (below(3) == 0) {
                auto* const line = chosen->findChild<QLineEdit*>();
                if (line == nullptr) return;
                line->selectAll();
                QTest::keyClicks(line, texts[below(static_cast<int>(texts.size()))]);
                QTest::keyClick(chosen, Qt::Key_Return);
            } else {
                QTest::keyClick(chosen, below(2) == 0 ? Qt::Key_Up : Qt::Key_Down);
            }
        } else {
            static const std::vector<Qt::Key> keys{Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
            QTest::keyClick(chosen, keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))]);
        }
    }

    QWidget* window_;
    std::mt19937_64 random_;
    QTimer dismiss_;
    std::deque<QString> story_;
};

// Returns the number of open files, pipes and events. Sockets are not counted: connections to the display and the
// desktop are made when they are first used.
int openFiles() {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code closed;  // as the folder itself is
        count += std::filesystem::read_symlink(entry.path(), closed).string().starts_with("socket:") ? 0 : 1;
    }
    return count;
}

// Returns the number of objects of each class: of the window, of the application, and widgets without a parent.
std::map<QString, int> objectsOf(QObject* window) {
    std::map<QString, int> count;
    const auto add = [&](const QObject* one) { ++count[QString::fromLatin1(one->metaObject()->className())]; };
    for (const QObject* const one : window->findChildren<QObject*>()) add(one);
    for (const QObject* const one : QCoreApplication::instance()->findChildren<QObject*>()) add(one);
    for (const QWidget* const one : QApplication::topLevelWidgets()) {
        if (one->parent() == nullptr) add(one);
    }
    return count;
}

// What a window with nothing but the first scenario's result holds, besides memory.
struct Held {
    int files = 0;
    std::map<QString, int> objects;
};

class RandomWalk : public WindowTest {
  protected:
    // Undoes every change. Each one takes time if pictures must be loaded again. The history keeps only a thousand
    // entries, so finally the first scenario is set.
    void undoAll(const relief::Scenario& first) {
        int undone = 0;
        for (; workspace_->canUndo(); ++undone) {
            ASSERT_LT(undone, kMostUndone);
            workspace_->undo();
            ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace_->loading(); }, kEndMs));
        }
        std::printf("%d changes undone\n", undone);
        workspace_->show(first, QStringLiteral("first"));
        EXPECT_TRUE(QTest::qWaitFor([&] { return snapshot() && !workspace_->busy(); }, kEndMs));
    }
    // Closes all panes except the result, and waits until their resources are freed.
    void closePanes() {
        window_->resetLayout();  // a pane may fill the window
        for (QDockWidget* const dock : window_->findChildren<QDockWidget*>()) dock->hide();
        for (QDialog* const dialog : window_->findChildren<QDialog*>()) dialog->close();
        QTest::qWait(kEmptiedMs);
        QThreadPool::globalInstance()->waitForDone();
    }
    static void expectNoMore(const Held& before, const Held& now) {
        EXPECT_LE(now.files, before.files);
        QStringList more;
        int first = 0, last = 0;
        for (const auto& [kind, count] : before.objects) first += count;
        for (const auto& [kind, count] : now.objects) {
            last += count;
            const auto known = before.objects.find(kind);
            const int was = known != before.objects.end() ? known->second : 0;
            if (count > was) more << QStringLiteral("%1: %2 after %3").arg(kind).arg(count).arg(was);
        }
        std::printf("%d objects, %d after the first round\n", last, first);
        EXPECT_LE(last, kMoreObjects * first) << qPrintable(more.join(QStringLiteral("\n")));
    }
};

TEST_F(RandomWalk, overAllControls) {
    const char* const given = std::getenv("RELIEF_SEED");
    const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 10) : kSeed;
    const bool isLong = std::getenv("RELIEF_LONG") != nullptr;
    const char* const repeated = std::getenv("RELIEF_ROUNDS");
    const int rounds = repeated != nullptr ? std::max(1, std::atoi(repeated)) : 2;
    if (const char* const language = std::getenv("RELIEF_WALK_LANGUAGE")) installTranslations(QLatin1String(language));
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    complaints().clear();
    const QtMessageHandler handler = qInstallMessageHandler(noteQt);
    const vtkSmartPointer<vtkOutputWindow> output = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(vtkSmartPointer<NotingOutput>::New());
    openWindow(smallScenario());
    ASSERT_FALSE(HasFatalFailure());
    const auto cached = [&] { return static_cast<double>(snapshot()->maps->bytes()) / 1e6; };
    const double atFirst = usedMegabytes() - cached();
    Walk walk(window_.get(), seed);
    Held before;
    for (int round = 0; round < rounds; ++round) {
        int steps = 0;
        qint64 left = isLong ? kLongMs : kShortMs;
        while (left > 0) {
            QElapsedTimer clock;
            clock.start();
            walk.step();
            ++steps;
            QTest::qWait(5);
            // Time during which the machine is suspended does not count.
            left -= std::min<qint64>(clock.elapsed(), kLongestStepMs);
            if (!window_->isVisible()) window_->show();
            ASSERT_TRUE(complaints().isEmpty()) << qPrintable(complaints().join(QStringLiteral("\n"))) << "\nafter\n"
                                                << qPrintable(walk.story());
        }
        const double walked = usedMegabytes();
        // The window still responds.
        EXPECT_TRUE(QTest::qWaitFor([&] { return snapshot() && !workspace_->busy(); }, kEndMs));
        undoAll(smallScenario());
        QTest::qWait(1000);
        const double undone = usedMegabytes() - cached() - atFirst;
        closePanes();
        const double maps = cached();
        snapshot()->maps->clear();  // they count up to 4 MB too little each, since large pages are aligned
        // Resources of panes are freed in the background, which takes longer on a slow machine.
        double closed = 0;
        const auto freed = [&] {
            closed = usedMegabytes() - cached() - atFirst;
            return closed < kGrowthMegabytes;
        };
        EXPECT_TRUE(QTest::qWaitFor(freed, kEndMs)) << closed << " MB after round " << round + 1;
        Held now;
        now.files = openFiles();
        now.objects = objectsOf(window_.get());
        std::printf(
            "%d steps; %.0f MB at first, %.0f walked; besides %.0f of cached maps %.0f more than at first when all is "
            "undone, %.0f when all panes are closed; %d files open\n",
            steps, atFirst, walked, maps, undone, closed, now.files);
        EXPECT_LT(undone, kOpenMegabytes);
        if (round == 0) {
            before = now;
        } else {
            expectNoMore(before, now);
        }
    }
    window_.reset();
    workspace_.reset();
    QThreadPool::globalInstance()->waitForDone();
    const double left = usedMegabytes() - atFirst;
    std::printf("%.0f MB more than at first when the window is gone\n", left);
    EXPECT_LT(left, kLeftMegabytes);
    EXPECT_TRUE(complaints().isEmpty()) << qPrintable(complaints().join(QStringLiteral("\n")));
    vtkOutputWindow::SetInstance(output);
    qInstallMessageHandler(handler);
}

}  // namespace
}  // namespace reliefui
