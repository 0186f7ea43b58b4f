#include "panes/range_box.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>

#include "painting/chart.h"
#include "painting/painter.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/range_json.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

constexpr double kLegendWidth = 400;  // in points
constexpr double kLegendHeight = 52;
constexpr double kErrorThreshold = 0.5;  // in texels: results within half a texel of the exact hit
constexpr double kManyPercent = 99;

}  // namespace

RangeBox::RangeBox(Workspace* workspace, RangeButton::Shown shown, QWidget* parent)
    : QFrame(parent, Qt::Popup), workspace_(workspace), shown_(std::move(shown)), legend_(new QWidget(this)) {
    setObjectName(QStringLiteral("range-box"));
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameShape(QFrame::StyledPanel);
    makeControls();
    connect(workspace_, &Workspace::snapshotChanged, this, &RangeBox::refresh);
    connect(workspace_, &Workspace::panesChanged, this, &RangeBox::refresh);
    connect(workspace_, &Workspace::scenarioChanged, this, &RangeBox::refresh);
    refresh();
    scale_->setFocus();
}

void RangeBox::makeControls() {
    const double unit = workspace_->style().pixelsPerPoint();
    legend_->setFixedSize(static_cast<int>(kLegendWidth * unit), static_cast<int>(kLegendHeight * unit));
    const auto chooser = [this](const char* name, const QString& help, const QStringList& names) {
        auto* const box = new QComboBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setAccessibleName(help);
        box->setToolTip(help);
        box->addItems(names);
        return box;
    };
    scale_ = chooser("range-scale", tr("Mapping of values to colours"), {tr("linear"), tr("logarithmic")});
    ends_ =
        chooser("range-ends", tr("Ends of the colour range"), {tr("all values"), tr("percentiles"), tr("custom ends")});
    low_ = addNumber("range-low", tr("Lower end of the colour range"), &ColorRange::low);
    high_ = addNumber("range-high", tr("Upper end of the colour range"), &ColorRange::high);
    thresholdOn_ = new QCheckBox(tr("only values above"), this);
    thresholdOn_->setObjectName(QStringLiteral("range-threshold-on"));
    thresholdOn_->setToolTip(tr("Values up to it share one colour; the legend counts those above it"));
    threshold_ = new QDoubleSpinBox(this);
    threshold_->setObjectName(QStringLiteral("range-threshold"));
    threshold_->setAccessibleName(tr("Threshold"));
    threshold_->setKeyboardTracking(false);
    auto* const standard = new QPushButton(tr("Standard"), this);
    standard->setObjectName(QStringLiteral("range-standard"));
    standard->setToolTip(tr("Reset to the default range of this picture"));
    lowName_ = new QLabel(tr("from"), this);

    auto* const grid = new QGridLayout(this);
    grid->addWidget(legend_, 0, 0, 1, 6);
    grid->addWidget(scale_, 1, 0);
    grid->addWidget(ends_, 1, 1);
    grid->addWidget(lowName_, 1, 2);
    grid->addWidget(low_, 1, 3);
    grid->addWidget(new QLabel(tr("to"), this), 1, 4);
    grid->addWidget(high_, 1, 5);
    grid->addWidget(thresholdOn_, 2, 0, 1, 2);
    grid->addWidget(threshold_, 2, 3);
    grid->addWidget(standard, 2, 5);
    connect(scale_, qOverload<int>(&QComboBox::activated), this, [this](int n) {
        ColorRange range = values_->range;
        range.logarithmic = n == 1;
        set(range);
    });
    connect(ends_, qOverload<int>(&QComboBox::activated), this, &RangeBox::chooseEnds);
    connect(thresholdOn_, &QCheckBox::clicked, this, &RangeBox::chooseThreshold);
    connect(threshold_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
        ColorRange range = values_->range;
        range.threshold = value;
        set(range, "range-threshold");
    });
    connect(standard, &QPushButton::clicked, this, [this] { set(standardRange(values_->of)); });
}

QDoubleSpinBox* RangeBox::addNumber(const char* name, const QString& help, double ColorRange::*part) {
    auto* const box = new QDoubleSpinBox(this);
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(help);
    box->setToolTip(help);
    box->setKeyboardTracking(false);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, part, name](double value) {
        ColorRange range = values_->range;
        range.*part = value;
        set(range, name);
    });
    return box;
}

// Switches the kind of ends, with initial values that correspond to what is visible.
void RangeBox::chooseEnds(int ends) {
    ColorRange range = values_->range;
    range.ends = static_cast<RangeEnds>(ends);
    if (range.ends == RangeEnds::Own) {
        range.low = values_->scale.twoSided ? 0 : values_->scale.low;
        range.high = values_->scale.high > range.low ? values_->scale.high : range.low + 1;
    } else {
        range.low = 0;
        range.high = range.ends == RangeEnds::Percentile ? kManyPercent : 1;
    }
    set(range);
}

void RangeBox::chooseThreshold(bool on) {
    ColorRange range = values_->range;
    range.threshold.reset();
    constexpr double kPlace = 0.75;  // position on a two-sided scale: half of one side
    if (on) {
        range.threshold = values_->of == RangeOf::Error ? kErrorThreshold
                                                        : values_->scale.value(values_->scale.twoSided ? kPlace : 0.5);
    }
    set(range);
}

void RangeBox::set(const ColorRange& range, const char* drag) {
    RangesState state{rangesOf(workspace_->scenario())};
    state.ranges.set(values_->of, range);
    workspace_->change(withState(workspace_->scenario(), state), changeName([] { return tr("Range of the colours"); }),
                       QString::fromLatin1(drag));
}

// Sets the decimals and steps of the boxes according to the values shown.
void RangeBox::fitNumbers(const RangedValues& values) {
    constexpr double kMost = 1e9;
    constexpr double kSteps = 100;
    const double span = std::max(values.scale.high - values.scale.low, 1e-9);
    const double step = chart::niceStep(span, kSteps);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 8);
    const bool percent = values.range.ends == RangeEnds::Percentile;
    for (QDoubleSpinBox* const box : {low_, high_, threshold_}) {
        const bool percents = percent && box != threshold_;
        box->setDecimals(percents ? 3 : decimals);
        box->setRange(percents ? 0 : -kMost, percents ? 100 : kMost);
        box->setSingleStep(percents ? 0.5 : step);
        box->setSuffix(percents ? QStringLiteral(" %") : QString());
    }
}

void RangeBox::refresh() {
    auto now = shown_();
    if (!now) return;
    values_ = std::move(now);
    // A choice made just now may not have been drawn yet.
    values_->range = rangesOf(workspace_->scenario()).of(values_->of);
    const ColorRange& range = values_->range;
    const QSignalBlocker quiet[] = {QSignalBlocker(low_), QSignalBlocker(high_), QSignalBlocker(threshold_)};
    const bool own = range.ends == RangeEnds::Own;
    const bool twoSided = values_->scale.twoSided;
    fitNumbers(*values_);
    scale_->setCurrentIndex(range.logarithmic ? 1 : 0);
    ends_->setCurrentIndex(static_cast<int>(range.ends));
    const bool all = range.ends == RangeEnds::All;
    low_->setEnabled(!all);
    high_->setEnabled(!all);
    low_->setVisible(!twoSided);
    lowName_->setText(twoSided ? tr("both sides") : tr("from"));
    low_->setValue(all ? values_->scale.low : range.low);
    high_->setValue(all ? values_->scale.high : range.high);
    if (own && twoSided) high_->setMinimum(0);
    thresholdOn_->setChecked(range.threshold.has_value());
    threshold_->setEnabled(range.threshold.has_value());
    threshold_->setValue(range.threshold.value_or(threshold_->value()));
    update();
}

void RangeBox::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    if (!values_) return;
    Style style = workspace_->style();
    QPainter painter(this);
    const QRect at = legend_->geometry();
    painter.fillRect(at, toColor(style.background()));
    const reliefui::Box room{double(at.left()), double(at.top()), double(at.right()), double(at.bottom())};
    constexpr double kPad = 4;
    const double unit = style.pixelsPerPoint();
    painter.setClipRect(at);
    const auto shown = shown_();
    if (!shown) return;
    paint(painter, rangeLegend(*shown, kLegendWidth - 2 * kPad), {unit, room.x0 + kPad * unit, room.y0 + kPad * unit},
          style, room);
}

}  // namespace reliefui
