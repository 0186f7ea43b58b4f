#include "windows/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace reliefui {

namespace {

constexpr int kTabSpace = 12;  // around a tab's text, in pixels
constexpr double kRound = 2;
constexpr int kFilled = 150;  // opacity of the background of a checked button

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int WindowStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    return metric == PM_TabBarTabHSpace ? kTabSpace : QProxyStyle::pixelMetric(metric, option, widget);
}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    if (element != PE_PanelButtonTool) return QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool on = (option->state & State_On) != 0;
    const bool pressed = (option->state & State_Sunken) != 0;
    const bool under = (option->state & State_MouseOver) != 0 && (option->state & State_Enabled) != 0;
    if (!on && !pressed && !under && (option->state & State_AutoRaise) != 0) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    QColor ground = option->palette.color(QPalette::Highlight);
    ground.setAlpha(kFilled);
    const bool filled = on || pressed;
    const bool raised = (option->state & State_AutoRaise) == 0;
    QColor edge = option->palette.color(QPalette::ButtonText);
    edge.setAlpha(under ? kFilled : kFilled / 3);
    painter->setPen(under || raised ? QPen(edge) : QPen(Qt::NoPen));
    painter->setBrush(filled ? QBrush(ground) : raised ? option->palette.button() : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(box, kRound, kRound);
    // A bar at the bottom marks a checked button as well, so that colour is not the only cue.
    if (on) {
        painter->fillRect(QRectF(box.left() + kRound, box.bottom() - 2, box.width() - 2 * kRound, 2),
                          option->palette.color(QPalette::ButtonText));
    }
    painter->restore();
}

}  // namespace reliefui
