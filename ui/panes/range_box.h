// The dialog for a colour range. It always applies to the picture on the screen: after undo, or when another picture is
// shown, it shows that picture's range.
#pragma once

#include <QFrame>

#include "panes/range_button.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace reliefui {

class RangeBox : public QFrame {
    Q_OBJECT
  public:
    RangeBox(Workspace* workspace, RangeButton::Shown shown, QWidget* parent);

    void refresh();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QDoubleSpinBox* addNumber(const char* name, const QString& help, double ColorRange::*part);
    void makeControls();
    void chooseEnds(int ends);
    void chooseThreshold(bool on);
    void fitNumbers(const RangedValues& values);
    void set(const ColorRange& range, const char* drag = nullptr);

    Workspace* workspace_;
    RangeButton::Shown shown_;
    std::optional<RangedValues> values_;
    QWidget* legend_;
    QComboBox* scale_ = nullptr;
    QComboBox* ends_ = nullptr;
    QLabel* lowName_ = nullptr;
    QDoubleSpinBox* low_ = nullptr;
    QDoubleSpinBox* high_ = nullptr;
    QCheckBox* thresholdOn_ = nullptr;
    QDoubleSpinBox* threshold_ = nullptr;
};

}  // namespace reliefui
