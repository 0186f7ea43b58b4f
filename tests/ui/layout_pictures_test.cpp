// Golden figures of the whole window at 1280 x 720, the usual projector: all panes, one that fills the window, teaching
// mode; on a desk and projected; in English dark and in Ukrainian light. They include the 3-D scenes.
#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QWindow>

#include "golden.h"
#include "window_fixture.h"
#include "windows/pane_title.h"
#include "windows/program.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

constexpr QSize kWindow(1280, 720);
constexpr int kSettledMs = 6000;

// At half size with 16 steps per channel, a picture takes 60 kB, and a truncated letter is still detected.
QImage reduced(const QImage& picture) {
    constexpr int kStep = 17;
    QImage small = picture.scaled(kWindow / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                       .convertToFormat(QImage::Format_RGB32);
    const auto coarse = [](int value) { return (value + kStep / 2) / kStep * kStep; };
    for (int y = 0; y < small.height(); ++y) {
        auto* const line = reinterpret_cast<QRgb*>(small.scanLine(y));
        for (int x = 0; x < small.width(); ++x) {
            line[x] = qRgb(coarse(qRed(line[x])), coarse(qGreen(line[x])), coarse(qBlue(line[x])));
        }
    }
    return small;
}

class LayoutPictures : public WindowTest {
  protected:
    void TearDown() override {
        WindowTest::TearDown();
        if (haveDisplay()) installTranslations({});
    }
    QDockWidget* dock(const char* name) const { return window_->findChild<QDockWidget*>(QLatin1String(name)); }
    void fill(const char* name) { Q_EMIT qobject_cast<PaneTitle*>(dock(name)->titleBarWidget())->fillRequested(); }

    // Returns the window's image when it no longer changes. The right half of the status bar shows the frame's time,
    // which differs every time, and is covered.
    QImage settledWindow() const {
        const auto shot = [this] {
            QImage picture = window_->grab().toImage();
            QRect line = window_->statusBar()->geometry();
            line.setLeft(line.center().x());
            QPainter(&picture).fillRect(line, Qt::gray);
            return picture;
        };
        constexpr int kApart = 250;
        QImage now = shot();
        for (int waited = 0; waited < kSettledMs; waited += kApart) {
            QTest::qWait(kApart);
            QImage next = shot();
            if (next == now) return now;
            now = next;
        }
        ADD_FAILURE() << "the window keeps changing";
        return now;
    }
    QString saved() const {
        const QString path = folder_.filePath(QStringLiteral("window.png"));
        EXPECT_TRUE(reduced(settledWindow()).save(path));
        return path;
    }

    void openAt720(const QString& language, bool light) {
        installTranslations(language);
        openWindow(deepRay());
        // Otherwise a control under the pointer, left there by earlier tests, would be highlighted.
        QTest::mouseMove(window_->windowHandle(), QPoint(900, 10));
        window_->setLightTheme(light);
        workspace_->chooseStep(5);
        resize();
    }
    void resize() {
        // The size of the full screen may arrive after this; a change of size in between makes the window adapt its
        // type to the final one.
        window_->resize(kWindow + QSize(1, 1));
        QTest::qWait(200);
        ASSERT_TRUE(QTest::qWaitFor(
            [this] {
                window_->resize(kWindow);
                return window_->size() == kWindow;
            },
            kSettledMs));
        window_->resetLayout();
    }

    // The visible panes cover each kind: numbers next to pictures, a drawing, 3-D.
    void expectAll(const std::string& ending) {
        for (const bool projector : {false, true}) {
            const std::string name = std::string(projector ? "projector" : "desk") + "-" + ending;
            window_->setProjector(projector);
            resize();
            dock("pyramid-pane")->raise();
            expectGolden(saved(), "window-" + name);
            fill("profile-pane");
            expectGolden(saved(), "window-filled-" + name);
            fill("profile-pane");
            dock("trace-pane")->raise();
            window_->setTeaching(true);
            expectGolden(saved(), "window-teach-" + name);
            window_->setTeaching(false);
        }
        window_->setProjector(false);
    }

    QTemporaryDir folder_;
};

TEST_F(LayoutPictures, EnglishDark) {
    openAt720(QStringLiteral("en"), false);
    expectAll("english");
}

TEST_F(LayoutPictures, UkrainianLight) {
    openAt720(QStringLiteral("uk"), true);
    expectAll("ukrainian");
    window_->setLightTheme(false);
}

// Shows that changes are detected: a moved dock, a truncated word, a missing button.
TEST_F(LayoutPictures, WhatIsElsewhereIsSeen) {
    openAt720(QStringLiteral("en"), false);
    dock("pyramid-pane")->raise();
    const std::string name = "window-desk-english";
    EXPECT_LT(goldenDifference(saved(), name).flip, kGoldenBound);
    const auto differs = [&] { return goldenDifference(saved(), name).flip > 1.5 * kGoldenBound; };
    QLabel* count = nullptr;
    for (auto* const label : window_->time()->bar()->findChildren<QLabel*>()) {
        if (label->text().startsWith(QStringLiteral("step "))) count = label;
    }
    ASSERT_NE(count, nullptr);
    const QString said = count->text();
    count->setText(said.left(said.size() - 2));
    EXPECT_TRUE(differs()) << "a label is cut";
    count->setText(said);
    window_->resizeDocks({dock("scene-pane")}, {dock("scene-pane")->width() + 24}, Qt::Horizontal);
    EXPECT_TRUE(differs()) << "a dock is wider";
    window_->resetLayout();
    EXPECT_FALSE(differs());
    window_->addDockWidget(Qt::RightDockWidgetArea, dock("scene-pane"));
    EXPECT_TRUE(differs()) << "a dock has moved";
}

}  // namespace

}  // namespace reliefui
