// A number that is turned: slider and box beside each other, made from its description.
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "relief/describe.h"

namespace reliefui {

// How far along the slider a value lies. Wide ranges are bent, so that the useful part is not a hair's breadth.
class SliderScale {
  public:
    explicit SliderScale(const relief::OptionDescription& description);
    double value(int position) const;
    int position(double value) const;

    static constexpr int kPositions = 1000;

  private:
    enum class Bend : std::uint8_t { Linear, Logarithmic, Cubic };
    Bend bend_ = Bend::Linear;
    double low_ = 0;
    double high_ = 1;
    double step_ = 0.01;
};

class NumberControl : public QWidget {
    Q_OBJECT
  public:
    explicit NumberControl(const relief::OptionDescription& description, QWidget* parent = nullptr);

    // Without a signal.
    void setValue(double value);
    double value() const { return box_->value(); }
    QSlider* slider() { return slider_; }
    QDoubleSpinBox* box() { return box_; }

  signals:
    void changed(double value, bool live);  // live: the slider is being dragged
    void settled();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitBox();

    relief::OptionDescription description_;
    SliderScale scale_;
    QSlider* slider_;
    QDoubleSpinBox* box_;
};

// What a tool tip says of it: help, unit, range.
QString optionToolTip(const relief::OptionDescription& description);

}  // namespace reliefui
