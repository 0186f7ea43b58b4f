#include "windows/pane_title.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>

namespace reliefui {

PaneTitle::PaneTitle(const QString& title, const QString& shortcut, const QString& help, QWidget* parent)
    : QWidget(parent), title_(title), row_(new QHBoxLayout(this)), note_(new QLabel(this)) {
    setObjectName(QStringLiteral("pane-title"));
    auto* const name = new QLabel(title, this);
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    note_->setTextFormat(Qt::PlainText);
    auto* const fill = new QToolButton(this);
    fill->setObjectName(QStringLiteral("pane-fill"));
    fill->setText(QStringLiteral("□"));
    fill->setAutoRaise(true);
    fill->setToolTip(tr("Fill the window with this pane, and back (double click on the title)"));
    fill->setAccessibleName(tr("Fill the window with %1").arg(title));
    row_->setContentsMargins(8, 2, 4, 2);
    row_->addWidget(name);
    row_->addWidget(note_, 1);
    row_->addWidget(fill);
    setToolTip(help + '\n' + tr("%1: press %2 to go there, double-click to fill the window").arg(title, shortcut));
    connect(fill, &QToolButton::clicked, this, &PaneTitle::fillRequested);
}

void PaneTitle::setClosable() {
    setToolTip(toolTip() + '\n' + tr("Drag it to another place, or out of the window"));
    auto* const close = new QToolButton(this);
    close->setObjectName(QStringLiteral("pane-close"));
    close->setText(QStringLiteral("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this pane; the menu View, Panes opens it again"));
    close->setAccessibleName(tr("Close %1").arg(title_));
    row_->addWidget(close);
    connect(close, &QToolButton::clicked, this, &PaneTitle::closeRequested);
}

void PaneTitle::addControl(QWidget* control) {
    row_->insertWidget(2, control);
}

void PaneTitle::setNote(const QString& note) {
    text_ = note;
    fitNote();
}

void PaneTitle::fitNote() {
    // A few letters say nothing.
    constexpr int kLeastLetters = 8;
    const QString fitting = note_->fontMetrics().elidedText(text_, Qt::ElideRight, note_->width());
    note_->setText(fitting == text_ || fitting.size() > kLeastLetters ? fitting : QString());
}

void PaneTitle::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitNote();
}

void PaneTitle::mouseDoubleClickEvent(QMouseEvent* event) {
    event->accept();
    Q_EMIT fillRequested();
}

}  // namespace reliefui
