// What blocks the window's thread is logged: how long, by which part, and how much of it was painting.
#include <QApplication>
#include <QMenu>
#include <QMessageBox>
#include <QTimer>
#include <thread>

#include "window_fixture.h"
#include "workspace/pause_log.h"

namespace reliefui {
namespace {

constexpr double kHeldMs = 60;  // the shortest duration of an event of this test: it sleeps

void hold() {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kHeldMs));
}

// Returns the pause whose name contains this text.
PauseLog::Pause named(const QString& words) {
    for (const PauseLog::Pause& pause : PauseLog::instance().worst(1000)) {
        if (pause.what.contains(words)) return pause;
    }
    return {};
}

TEST_F(WindowTest, WhatHoldsTheThreadIsLogged) {
    QObject receiver;
    receiver.setObjectName(QStringLiteral("sleeper"));
    QTest::qWait(1);
    PauseLog& log = PauseLog::instance();
    log.clear();
    EXPECT_EQ(log.longestGap().ms, 0);
    QMetaObject::invokeMethod(
        &receiver, [] { hold(); }, Qt::QueuedConnection);
    QTest::qWait(1);
    const PauseLog::Pause pause = named(QStringLiteral("sleeper"));
    EXPECT_GE(pause.ms, kHeldMs);
    EXPECT_EQ(pause.drawing, 0);
    EXPECT_EQ(pause.times, 1);
    EXPECT_GE(log.longestGap().ms, kHeldMs);
    EXPECT_TRUE(log.longestGap().what.contains(QStringLiteral("sleeper"))) << log.longestGap().what.toStdString();
    EXPECT_GE(log.longestComputation().computed(), kHeldMs);
    EXPECT_TRUE(log.text(5).contains(QStringLiteral("sleeper")));
}

// Two events without an idle event loop in between are one pause of the window, but two logged events.
TEST_F(WindowTest, EventsInARowAreOnePause) {
    QObject receiver;
    QTest::qWait(1);
    PauseLog& log = PauseLog::instance();
    log.clear();
    for (const char* const name : {"first", "second"}) {
        QMetaObject::invokeMethod(
            &receiver,
            [name] {
                const PauseLog::Part part(name);
                hold();
            },
            Qt::QueuedConnection);
    }
    QTest::qWait(1);
    EXPECT_GE(log.longestGap().ms, 2 * kHeldMs);
    EXPECT_EQ(named(QStringLiteral("first")).times, 1);
    EXPECT_EQ(named(QStringLiteral("second")).times, 1);
    EXPECT_GE(log.longestGap().ms, named(QStringLiteral("first")).ms + named(QStringLiteral("second")).ms - 1e-6);
}

TEST_F(WindowTest, PaintingIsCountedSeparately) {
    QObject receiver;
    QTest::qWait(1);
    PauseLog::instance().clear();
    QMetaObject::invokeMethod(
        &receiver,
        [] {
            const PauseLog::Part part("both");
            hold();
            const DrawingTime time("drawn");
            hold();
            // A part within painting counts as ours.
            const PauseLog::Part inner("within");
            hold();
        },
        Qt::QueuedConnection);
    QTest::qWait(1);
    const PauseLog::Pause pause = named(QStringLiteral("both"));
    EXPECT_GE(pause.drawing, kHeldMs);
    EXPECT_GE(pause.computed(), 2 * kHeldMs - 1e-6);
    EXPECT_GE(pause.ms, 3 * kHeldMs);
}

// An open dialog blocks nothing.
TEST_F(WindowTest, WaitingInALoopOfItsOwnIsNoPause) {
    QObject receiver;
    QTest::qWait(1);
    PauseLog& log = PauseLog::instance();
    log.clear();
    bool inside = false;
    QMetaObject::invokeMethod(
        &receiver,
        [&] {
            const PauseLog::Part part("dialog");
            QEventLoop loop;
            QTimer::singleShot(static_cast<int>(10 * kHeldMs), &loop, &QEventLoop::quit);
            QMetaObject::invokeMethod(
                &receiver,
                [&] {
                    const PauseLog::Part held("inside");
                    hold();
                    inside = true;
                },
                Qt::QueuedConnection);
            loop.exec();
        },
        Qt::QueuedConnection);
    QTest::qWait(1);
    ASSERT_TRUE(inside);
    EXPECT_GE(named(QStringLiteral("inside")).ms, kHeldMs);
    // The dialog's event lasted ten times as long as the event handled inside it.
    EXPECT_LT(named(QStringLiteral("dialog")).ms, 10 * kHeldMs);
    EXPECT_LT(log.longestGap().ms, 10 * kHeldMs);
}

TEST_F(WindowTest, PausesAreShown) {
    ASSERT_NO_FATAL_FAILURE(openWindow(smallScenario()));
    QAction* shown = nullptr;
    for (QAction* const action : window_->findChildren<QAction*>()) {
        if (action->text() == MainWindow::tr("&Longest pauses…")) shown = action;
    }
    ASSERT_NE(shown, nullptr);
    EXPECT_GT(PauseLog::instance().longestGap().ms, 0) << "the first picture was drawn";
    shown->trigger();
    auto* const box = window_->findChild<QMessageBox*>(QStringLiteral("pauses"));
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains(PauseLog::instance().longestGap().what));
    box->close();
}

}  // namespace
}  // namespace reliefui
