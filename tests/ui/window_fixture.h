// A window with a small picture in it, and what the tests ask it again and again.
#pragma once

#include <memory>

#include <gtest/gtest.h>
#include <QImage>
#include <QTest>

#include "panes/figure_view.h"
#include "panes/result/result_view.h"
#include "windows/main_window.h"
#include "workspace/workspace.h"

namespace reliefui {

// Set by main().
bool& haveDisplay();

// Procedural bricks on a wall, drawn small, a pixel chosen.
relief::Scenario smallScenario();
// The same, with a long log over several levels: the paper's recursion, from the top.
relief::Scenario deepRay();

class WindowTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    // Opens the window on `scenario`, waits for its first full picture.
    void openWindow(const relief::Scenario& scenario);
    // Waits for the full picture of what is asked for; fails the test after some seconds.
    void waitForFull();
    // Lets the panes draw, then takes a picture of one.
    static QImage grab(QWidget* widget);
    // Saves the pane as a figure and waits for it.
    static void saveFigure(FigureView* view, const QString& path, int pixels = 0);

    relief::Scenario scenario() const { return workspace_->scenario(); }
    std::shared_ptr<const Snapshot> snapshot() const { return workspace_->snapshot(); }
    QPoint onScreen(int x, int y) const { return window_->result()->toWidget({x + 0.5, y + 0.5}).toPoint(); }

    std::unique_ptr<Workspace> workspace_;
    std::unique_ptr<MainWindow> window_;
};

// How many colours an image has: 1 is a blank one.
int colorsIn(const QImage& image);
// Whether it is a whole PNG or PDF, or an SVG of words and lines without any picture in it.
bool validFigure(const QString& file);

}  // namespace reliefui
