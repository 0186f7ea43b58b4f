#include "windows/message_bar.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace reliefui {

namespace {

constexpr int kLeastWidth = 200;  // of the text, in pixels

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), row_(new QHBoxLayout(this)), sign_(new QLabel(this)), label_(new QLabel(this)) {
    setObjectName(QStringLiteral("message-bar"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    row_->setContentsMargins(10, 4, 4, 4);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label_->setTextFormat(Qt::PlainText);
    label_->setWordWrap(true);
    label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    label_->setAccessibleName(tr("Message"));
    auto* const close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(tr("Close this message"));
    row_->addWidget(sign_);
    row_->addWidget(label_, 1);
    row_->addWidget(close);
    connect(close, &QToolButton::clicked, this, &MessageBar::close);
}

void MessageBar::close() {
    label_->clear();
    hide();
    Q_EMIT closed();
}

QPushButton* MessageBar::addAnswer(const QString& answer, const QString& help) {
    auto* const button = new QPushButton(answer, this);
    button->setToolTip(help);
    row_->insertWidget(row_->count() - 1, button);
    return button;
}

QString MessageBar::text() const {
    return label_->text();
}

void MessageBar::showText(const QString& text, bool problem) {
    // Black text on a light background in both themes; a symbol as well as the colour tells problems from notices.
    QPalette colors = palette();
    const QColor ground = problem ? QColor(0xff, 0xd9, 0xc2) : QColor(0xdc, 0xee, 0xfb);
    colors.setColor(QPalette::Window, ground);
    colors.setColor(QPalette::Button, ground);
    for (const auto role : {QPalette::WindowText, QPalette::ButtonText, QPalette::Text}) {
        colors.setColor(role, Qt::black);
    }
    setPalette(colors);
    sign_->setText(problem ? QStringLiteral("⚠") : QStringLiteral("ℹ"));
    label_->setText(text);
    label_->setToolTip(text);
    problem_ = problem;
    show();
    fitHeight();
}

// Makes room for all lines of the text: a tool bar does not use the height for width of its widgets.
void MessageBar::fitHeight() {
    const int side = sign_->sizeHint().width() + 2 * row_->spacing() + row_->contentsMargins().left();
    int answers = 0;
    for (int n = 2; n < row_->count(); ++n) answers += row_->itemAt(n)->sizeHint().width() + row_->spacing();
    const QRect room(0, 0, std::max(kLeastWidth, width() - side - answers), 1 << 20);
    const int height = label_->fontMetrics().boundingRect(room, Qt::TextWordWrap, label_->text()).height();
    if (label_->minimumHeight() != height) label_->setFixedHeight(height);
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitHeight();
}

void MessageBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitHeight();
}

}  // namespace reliefui
