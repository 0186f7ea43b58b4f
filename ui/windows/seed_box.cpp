#include "windows/seed_box.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <QLineEdit>
#include <QStyleOptionSpinBox>

namespace reliefui {

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kUsual = 9999;  // seeds up to this one do not make the box wider
constexpr int kCursor = 2;              // width of the cursor in pixels, as in Qt's own boxes

std::optional<std::uint64_t> parsed(const QString& text) {
    bool whole = false;
    const std::uint64_t value = text.toULongLong(&whole);
    if (!whole || !text[0].isDigit()) return std::nullopt;
    return value;
}

}  // namespace

SeedBox::SeedBox(QWidget* parent) : QAbstractSpinBox(parent) {
    setValue(0);
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] { take(typed().value_or(value_)); });
}

std::optional<std::uint64_t> SeedBox::typed() const {
    return parsed(text());
}

void SeedBox::setValue(std::uint64_t value) {
    value_ = value;
    const QString shown = QString::number(value);
    if (shown != text()) lineEdit()->setText(shown);
    updateGeometry();
}

void SeedBox::take(std::uint64_t value) {
    const bool other = value != value_;
    setValue(value);
    if (other) Q_EMIT edited();
}

void SeedBox::stepBy(int steps) {
    const std::uint64_t from = typed().value_or(value_);
    const auto by = static_cast<std::uint64_t>(std::abs(std::int64_t{steps}));
    take(steps < 0 ? from - std::min(from, by) : from + std::min(kMost - from, by));
    selectAll();
}

QValidator::State SeedBox::validate(QString& input, int&) const {
    if (input.isEmpty()) return QValidator::Intermediate;
    return parsed(input) ? QValidator::Acceptable : QValidator::Invalid;
}

QAbstractSpinBox::StepEnabled SeedBox::stepEnabled() const {
    StepEnabled enabled = StepNone;
    if (value_ > 0) enabled |= StepDownEnabled;
    if (value_ < kMost) enabled |= StepUpEnabled;
    return enabled;
}

QSize SeedBox::sizeHint() const {
    ensurePolished();
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QString widest = QString::number(std::max(value_, kUsual)) + QLatin1Char(' ');
    const QSize room(fontMetrics().horizontalAdvance(widest) + kCursor, lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, room, this);
}

}  // namespace reliefui
