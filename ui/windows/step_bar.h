// Time: the steps of the chosen ray, forwards and backwards, one after the other or by themselves.
#pragma once

#include <QTimer>
#include <QWidget>

#include "workspace/workspace.h"

class QComboBox;
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
    void togglePlay();

  private:
    int count() const;
    int step() const;
    void refresh();
    void advance();

    Workspace* workspace_;
    QSlider* slider_;
    QLabel* label_;
    QComboBox* speed_;
    QToolButton* play_ = nullptr;
    QTimer timer_;
};

}  // namespace reliefui
