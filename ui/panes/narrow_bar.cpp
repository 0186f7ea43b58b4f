#include "panes/narrow_bar.h"

#include <QEvent>
#include <QScrollBar>
#include <QTimer>

namespace reliefui {

namespace {

constexpr int kLeastWidth = 120;

}  // namespace

NarrowBar::NarrowBar(QWidget* parent) : QScrollArea(parent) {
    auto* const inner = new QWidget(this);
    row_ = new QHBoxLayout(inner);
    row_->setContentsMargins(4, 2, 6, 2);
    setWidget(inner);
    // The pane shines through: it is told that it is seen by being painted.
    inner->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    // Its controls are reached by themselves.
    setFocusPolicy(Qt::NoFocus);
    inner->installEventFilter(this);
}

QSize NarrowBar::minimumSizeHint() const {
    const QSize inner = widget()->minimumSizeHint();
    const bool scrolls = inner.width() > width();
    return {kLeastWidth, inner.height() + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0)};
}

bool NarrowBar::event(QEvent* event) {
    if (event->type() == QEvent::Polish || event->type() == QEvent::StyleChange) fitHeight();
    // When the controls know what they need in sight.
    if (event->type() == QEvent::Show) QTimer::singleShot(0, this, [this] { fitHeight(); });
    return QScrollArea::event(event);
}

void NarrowBar::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    fitHeight();
}

bool NarrowBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fitHeight();
    return QScrollArea::eventFilter(watched, event);
}

void NarrowBar::fitHeight() {
    const int wanted = minimumSizeHint().height();
    if (minimumHeight() != wanted || maximumHeight() != wanted) setFixedHeight(wanted);
}

}  // namespace reliefui
