// A window with a small picture, and functions that many tests use.
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

// Procedural bricks on a wall in a small picture, with a chosen pixel.
relief::Scenario smallScenario();
// The same, with a long log over several levels: the paper's recursion from the top level.
relief::Scenario deepRay();

class WindowTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    // Opens the window with `scenario` and waits for its first full picture.
    void openWindow(const relief::Scenario& scenario);
    // Waits for the full picture of the current scenario; fails the test after some seconds.
    void waitForFull();
    // Lets the panes draw, then returns an image of the widget.
    static QImage grab(QWidget* widget);
    // Saves the pane as a figure and waits for it.
    static void saveFigure(FigureView* view, const QString& path, int pixels = 0);

    relief::Scenario scenario() const { return workspace_->scenario(); }
    std::shared_ptr<const Snapshot> snapshot() const { return workspace_->snapshot(); }
    QPoint onScreen(int x, int y) const { return window_->result()->toWidget({x + 0.5, y + 0.5}).toPoint(); }

    std::unique_ptr<Workspace> workspace_;
    std::unique_ptr<MainWindow> window_;
};

// Returns the number of colours of an image; 1 means that it is blank.
int colorsIn(const QImage& image);
// Returns true if the file is a complete PNG or PDF, or an SVG of text and lines without embedded pictures.
bool validFigure(const QString& file);

}  // namespace reliefui
