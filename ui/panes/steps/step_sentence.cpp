#include "panes/steps/step_sentence.h"

#include <algorithm>

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// Text sizes, relative to the style's text size.
constexpr double kLargest = 1.4;
constexpr double kSmallest = 0.7;
constexpr double kStep = 0.05;
constexpr int kMargin = 10;
constexpr int kLeastLines = 2;
constexpr int kLeastLetters = 16;

}  // namespace

StepSentence::StepSentence(Workspace* workspace, QWidget* parent) : QLabel(parent), workspace_(workspace) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setMargin(kMargin);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setAccessibleName(tr("The chosen step in words"));
    connect(workspace_, &Workspace::snapshotChanged, this, &StepSentence::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &StepSentence::refresh);
    connect(workspace_, &Workspace::styleChanged, this, &StepSentence::refresh);
    refresh();
}

QSize StepSentence::sizeHint() const {
    QFont least = font();
    least.setPointSizeF(Style::kTextPoints * workspace_->style().scale());
    const QFontMetrics metrics(least);
    return {kLeastLetters * metrics.averageCharWidth() + 2 * kMargin,
            kLeastLines * metrics.lineSpacing() + 2 * kMargin};
}

QString StepSentence::words() const {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return tr("The steps of the chosen pixel's ray will appear here.");
    const relief::Language language = workspace_->style().language;
    const auto inWords = [&](const relief::Message& message) {
        return QString::fromStdString(relief::sentence(message, language));
    };
    if (snapshot->trace.hidden) return inWords(relief::Message(relief::MessageId::DrawHidden));
    const PixelTrace& trace = snapshot->trace;
    if (trace.steps.empty()) {
        return trace.onRelief ? tr("This method logged no step.")
                              : tr("No polygon covers the chosen pixel: click on the relief.");
    }
    const int end = static_cast<int>(trace.steps.size()) - 1;
    const auto at = static_cast<std::size_t>(std::clamp(workspace_->scenario().step, 0, end));
    const QString step = inWords(relief::stepSentence(trace.steps, at, trace.ray, trace.exact));
    // The answer is described at the last step, and at every step if it is wrong.
    const bool last = at + 1 == trace.steps.size();
    if (!last && relief::answerError(trace.hit, trace.exact, trace.ray) <= relief::kSameAnswer) return step;
    return step + QLatin1Char('\n') + inWords(relief::answerSentence(trace.hit, trace.exact, trace.ray));
}

void StepSentence::refresh() {
    setText(words());
    setToolTip(text());
    fit();
}

// Chooses the largest font size at which the whole text is visible.
void StepSentence::fit() {
    if (!isVisible()) return;
    QFont type = font();
    const QRect room = rect().adjusted(kMargin, kMargin, -kMargin, -kMargin);
    for (double size = kLargest; size >= kSmallest; size -= kStep) {
        type.setPointSizeF(Style::kTextPoints * workspace_->style().scale() * size);
        const QRect needed =
            QFontMetrics(type).boundingRect(QRect(0, 0, room.width(), 1 << 20), Qt::TextWordWrap, text());
        if (needed.height() <= room.height() && needed.width() <= room.width()) break;
    }
    setFont(type);
}

void StepSentence::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void StepSentence::showEvent(QShowEvent* event) {
    QLabel::showEvent(event);
    fit();
}

}  // namespace reliefui
