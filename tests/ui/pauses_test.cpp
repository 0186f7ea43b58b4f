// What holds the window's thread is logged: how long, by what, and how much of it was drawing.
#include <QApplication>
#include <QMenu>
#include <QMessageBox>
#include <QTimer>
#include <thread>

#include "window_fixture.h"
#include "workspace/pause_log.h"

namespace reliefui {
namespace {

constexpr double kHeldMs = 60;  // what an event here takes at least: it sleeps

void hold() {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kHeldMs));
}

// The pause with these words in its name.
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

// Two events between two looks at the queue are one pause of the window, but neither is as long.
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

TEST_F(WindowTest, DrawingIsToldApart) {
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
            // Ours within the drawing's is ours.
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

// A dialog that is open for long holds nobody.
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
    // It lasted ten times as long as what it held.
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
