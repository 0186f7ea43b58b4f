#include "panes/number_control.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "panes/core_texts.h"

namespace reliefui {

namespace {

// Number of steps above which a linear slider cannot be set precisely.
constexpr double kManySteps = 500;

int decimalsOf(const relief::OptionDescription& description) {
    if (description.kind == relief::OptionKind::Integer) return 0;
    const int digits = static_cast<int>(std::ceil(-std::log10(std::max(description.step, 1e-9)) - 1e-9));
    return std::clamp(digits, 1, 9);
}

}  // namespace

SliderScale::SliderScale(const relief::OptionDescription& description)
    : low_(description.low), high_(description.high), step_(description.step) {
    if (description.unit == "degrees" && high_ - low_ > 360) {
        low_ = -180;
        high_ = 180;
    }
    // The slider ends here; larger pictures can be entered in the box.
    if (description.unit == "pixels") {
        low_ = std::max(low_, 32.0);
        high_ = std::min(high_, 4096.0);
    }
    if ((high_ - low_) / step_ <= kManySteps) return;
    bend_ = low_ > 0 ? Bend::Logarithmic : low_ == 0 ? Bend::Cubic : Bend::Linear;
}

double SliderScale::value(int position) const {
    const double t = static_cast<double>(position) / kPositions;
    double value = low_ + t * (high_ - low_);
    if (bend_ == Bend::Logarithmic) value = low_ * std::pow(high_ / low_, t);
    if (bend_ == Bend::Cubic) value = high_ * t * t * t;
    return std::clamp(std::round(value / step_) * step_, low_, high_);
}

int SliderScale::position(double value) const {
    const double v = std::clamp(value, low_, high_);
    double t = (v - low_) / (high_ - low_);
    if (bend_ == Bend::Logarithmic) t = std::log(v / low_) / std::log(high_ / low_);
    if (bend_ == Bend::Cubic) t = std::cbrt(v / high_);
    return static_cast<int>(std::lround(t * kPositions));
}

QString optionToolTip(const relief::OptionDescription& description) {
    QString text = coreText(description.help);
    if (description.kind == relief::OptionKind::Choice || description.kind == relief::OptionKind::Method) return text;
    if (!text.isEmpty()) text += '\n';
    return text + NumberControl::tr("%1 to %2 %3")
                      .arg(QString::fromStdString(relief::numberText(description.low)),
                           QString::fromStdString(relief::numberText(description.high)), coreText(description.unit))
                      .trimmed();
}

NumberControl::NumberControl(const relief::OptionDescription& description, QWidget* parent)
    : QWidget(parent),
      description_(description),
      scale_(description),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new QDoubleSpinBox(this)) {
    const QString title = optionTitle(description.name);
    slider_->setRange(0, SliderScale::kPositions);
    slider_->setPageStep(SliderScale::kPositions / 20);
    slider_->setSingleStep(SliderScale::kPositions / 200);
    slider_->setMinimumWidth(60);
    slider_->setAccessibleName(tr("%1, slider").arg(title));
    box_->setLocale(QLocale::c());
    box_->setDecimals(decimalsOf(description));
    box_->setRange(description.low, description.high);
    box_->setSingleStep(description.step);
    box_->setSuffix(unitSuffix(description.unit));
    box_->setKeyboardTracking(false);
    box_->setAccessibleName(title);
    fitBox();
    setToolTip(optionToolTip(description));
    setObjectName(QString::fromStdString(description.name));
    setFocusProxy(box_);

    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(slider_, 1);
    row->addWidget(box_);

    connect(slider_, &QSlider::valueChanged, this, [this](int position) {
        const double value = scale_.value(position);
        const QSignalBlocker quiet(box_);
        box_->setValue(value);
        Q_EMIT changed(value, slider_->isSliderDown());
    });
    connect(slider_, &QSlider::sliderReleased, this, &NumberControl::editFinished);
    connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(scale_.position(value));
        Q_EMIT changed(value, false);
    });
    connect(box_, &QDoubleSpinBox::editingFinished, this, &NumberControl::editFinished);
}

void NumberControl::fitBox() {
    box_->setFixedWidth(box_->fontMetrics().horizontalAdvance(QStringLiteral("-0000.0°")) + 28);
}

void NumberControl::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitBox();
}

void NumberControl::setValue(double value) {
    const QSignalBlocker quietBox(box_);
    const QSignalBlocker quietSlider(slider_);
    // Not while the user is typing into the box.
    if (std::abs(box_->value() - value) > 1e-12) box_->setValue(value);
    if (!slider_->isSliderDown()) slider_->setValue(scale_.position(value));
}

}  // namespace reliefui
