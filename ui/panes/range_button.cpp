#include "panes/range_button.h"

#include <QGuiApplication>
#include <QPainter>
#include <QScreen>

#include "painting/painter.h"
#include "panes/range_box.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

// Icon with a colour bar: clicking the bar in a legend opens the same dialog.
QIcon barIcon() {
    constexpr int kWide = 32;
    constexpr int kHigh = 32;
    constexpr int kBar = 14;
    QPixmap picture(kWide, kHigh);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    for (int x = 0; x < kWide; ++x) {
        painter.fillRect(x, (kHigh - kBar) / 2, 1, kBar,
                         toColor(Style().mapped(ColorMap::Count, static_cast<double>(x) / (kWide - 1))));
    }
    painter.setPen(Qt::gray);
    painter.drawRect(0, (kHigh - kBar) / 2, kWide - 1, kBar - 1);
    return {picture};
}

}  // namespace

RangeButton::RangeButton(Workspace* workspace, Shown shown, QWidget* parent)
    : QToolButton(parent), workspace_(workspace), shown_(std::move(shown)) {
    const QString help =
        tr("Range of the colours: linear, logarithmic, percentiles, custom ends, a threshold; a click on the colour "
           "bar also opens it");
    setObjectName(QStringLiteral("color-range"));
    setIcon(barIcon());
    setToolTip(help);
    setAccessibleName(tr("Range of the colours"));
    setAutoRaise(true);
    connect(this, &QToolButton::clicked, this, &RangeButton::open);
}

void RangeButton::refresh() {
    setEnabled(shown_().has_value());
    if (box_) box_->refresh();
}

void RangeButton::open() {
    if (!shown_()) return;
    if (box_) box_->close();
    box_ = new RangeBox(workspace_, shown_, this);
    box_->adjustSize();
    const QScreen* const screen = QGuiApplication::screenAt(mapToGlobal(rect().center()));
    const QRect room = (screen != nullptr ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    QPoint at = mapToGlobal(QPoint(0, height()));
    at.setX(std::max(room.left(), std::min(at.x(), room.right() - box_->width())));
    if (at.y() + box_->height() > room.bottom()) at.setY(mapToGlobal(QPoint(0, 0)).y() - box_->height());
    box_->move(at.x(), std::max(at.y(), room.top()));
    box_->show();
}

}  // namespace reliefui
