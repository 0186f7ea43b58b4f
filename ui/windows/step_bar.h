// The bar for stepping: moves through the steps of the chosen ray, forwards or backwards, singly or by playing.
#pragma once

#include <QTimer>
#include <QWidget>

#include "workspace/workspace.h"

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace reliefui {

class StepBar : public QWidget {
    Q_OBJECT
  public:
    explicit StepBar(Workspace* workspace, QWidget* parent = nullptr);

  public slots:
    void first();
    void previous();
    void next();
    void last();
    // Steps over everything on finer levels than that of the chosen step.
    void over();
    void overBack();
    // Runs to the next or previous breakpoint; to the end of the ray if there is none.
    void run();
    void runBack();
    // Runs to the next or previous step at which the chosen watched value changes; to the end of the ray if there is
    // none.
    void runToChange();
    void runBackToChange();
    // Plays until the end of the ray or a breakpoint.
    void togglePlay();
    // Changes the speed to the next higher or lower preset, in steps per second.
    void faster();
    void slower();

  private:
    int count() const;
    int step() const;
    void makeSpeed();
    void setSpeed(double stepsASecond);
    void refresh();
    void advance();
    int levelStep(bool forward) const;
    void runTo(bool forward);
    void runToChange(bool forward);
    void goTo(const std::optional<std::size_t>& step, bool forward);
    QString stopsHere() const;

    Workspace* workspace_;
    QSlider* slider_;
    QLabel* label_;
    QDoubleSpinBox* speed_;
    QToolButton* play_ = nullptr;
    QTimer timer_;
};

}  // namespace reliefui
