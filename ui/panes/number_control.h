// A control for a number: a slider and a box side by side, generated from its description.
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "relief/describe.h"

namespace reliefui {

// Mapping of values to slider positions. Wide ranges are mapped non-linearly, so that the useful part is not too short.
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

    // Emits no signal.
    void setValue(double value);
    double value() const { return box_->value(); }
    QSlider* slider() { return slider_; }
    QDoubleSpinBox* box() { return box_; }

  signals:
    void changed(double value, bool live);  // live: the slider is being dragged
    void editFinished();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fitBox();

    relief::OptionDescription description_;
    SliderScale scale_;
    QSlider* slider_;
    QDoubleSpinBox* box_;
};

// Tool tip of an option: help text, unit, range.
QString optionToolTip(const relief::OptionDescription& description);

}  // namespace reliefui
