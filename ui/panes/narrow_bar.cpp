#include "panes/narrow_bar.h"

#include <QEvent>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

namespace reliefui {

namespace {

constexpr int kLeastWidth = 120;
constexpr int kEndWidth = 18;

}  // namespace

NarrowBar::NarrowBar(QWidget* parent) : QScrollArea(parent) {
    auto* const inner = new QWidget(this);
    row_ = new QHBoxLayout(inner);
    row_->setContentsMargins(4, 2, 6, 2);
    setWidget(inner);
    // Transparent: the pane is painted, and thereby detects that it is visible, only if nothing opaque covers it.
    inner->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    // The focus goes to the controls themselves, which are then scrolled into view.
    setFocusPolicy(Qt::NoFocus);
    back_ = addEnd(Qt::LeftArrow, tr("The controls further left"));
    on_ = addEnd(Qt::RightArrow, tr("The controls further right"));
    inner->installEventFilter(this);
    connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, &NarrowBar::placeEnds);
    connect(horizontalScrollBar(), &QScrollBar::rangeChanged, this, &NarrowBar::placeEnds);
}

QToolButton* NarrowBar::addEnd(Qt::ArrowType arrow, const QString& help) {
    auto* const end = new QToolButton(this);
    end->setArrowType(arrow);
    end->setToolTip(help);
    end->setAccessibleName(help);
    end->setFocusPolicy(Qt::NoFocus);
    end->hide();
    connect(end, &QToolButton::clicked, this,
            [this, arrow] { go((arrow == Qt::LeftArrow ? -1 : 1) * viewport()->width() / 2); });
    return end;
}

void NarrowBar::go(int pixels) {
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + pixels);
}

QSize NarrowBar::minimumSizeHint() const {
    return {kLeastWidth, widget()->minimumSizeHint().height()};
}

bool NarrowBar::event(QEvent* event) {
    if (event->type() == QEvent::Polish || event->type() == QEvent::StyleChange) fitHeight();
    // Delayed until the visible controls know their size.
    if (event->type() == QEvent::Show) QTimer::singleShot(0, this, [this] { fitHeight(); });
    return QScrollArea::event(event);
}

void NarrowBar::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    fitHeight();
    placeEnds();
}

void NarrowBar::wheelEvent(QWheelEvent* event) {
    const QPoint by = event->angleDelta();
    go(-(by.x() != 0 ? by.x() : by.y()) / 2);
    event->accept();
}

bool NarrowBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fitHeight();
    return QScrollArea::eventFilter(watched, event);
}

void NarrowBar::fitHeight() {
    const int needed = minimumSizeHint().height();
    if (minimumHeight() != needed || maximumHeight() != needed) setFixedHeight(needed);
}

// Places the buttons over the controls at the ends, if more controls lie beyond them.
void NarrowBar::placeEnds() {
    const QScrollBar* const along = horizontalScrollBar();
    back_->setGeometry(0, 0, kEndWidth, height());
    on_->setGeometry(width() - kEndWidth, 0, kEndWidth, height());
    back_->setVisible(along->value() > along->minimum());
    on_->setVisible(along->value() < along->maximum());
}

}  // namespace reliefui
