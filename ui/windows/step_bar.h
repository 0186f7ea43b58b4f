// Time: the steps of the chosen ray, forwards and backwards, one after the other or by themselves.
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
    // Over what lies on finer levels than the chosen step.
    void over();
    void overBack();
    // To the next breakpoint, or the one before; to the end of the ray where there is none.
    void run();
    void runBack();
    // Until the ray's end or a breakpoint.
    void togglePlay();
    // To the next round number of steps a second.
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
    QString stopsHere() const;

    Workspace* workspace_;
    QSlider* slider_;
    QLabel* label_;
    QDoubleSpinBox* speed_;
    QToolButton* play_ = nullptr;
    QTimer timer_;
};

}  // namespace reliefui
