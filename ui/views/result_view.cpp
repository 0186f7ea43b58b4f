#include "views/result_view.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include "views/orbit.h"
#include "views/result_painting.h"

namespace reliefui {

namespace {

constexpr double kDegreesPerPixel = 0.3;
constexpr double kWheelFactor = 1.12;  // a notch
constexpr double kLargestZoom = 256;
constexpr int kWheelRestMs = 150;
constexpr int kFarPixels = 10;

}  // namespace

ResultView::ResultView(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
    setObjectName(QStringLiteral("result"));
    setAccessibleName(tr("Result: the rendered picture"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_OpaquePaintEvent);
    wheelRest_.setSingleShot(true);
    wheelRest_.setInterval(kWheelRestMs);
    connect(&wheelRest_, &QTimer::timeout, workspace_, &Workspace::settle);
    connect(workspace_, &Workspace::snapshotChanged, this, qOverload<>(&QWidget::update));
    connect(workspace_, &Workspace::styleChanged, this, qOverload<>(&QWidget::update));
}

QSize ResultView::pictureSize() const {
    const auto snapshot = workspace_->snapshot();
    const relief::Scenario& scenario = snapshot ? snapshot->scenario : workspace_->scenario();
    return {scenario.width, scenario.height};
}

double ResultView::scale() const {
    const QSize size = pictureSize();
    return zoom_ * std::min(double(width()) / size.width(), double(height()) / size.height());
}

QPointF ResultView::toWidget(QPointF picture) const {
    const QSize size = pictureSize();
    const QPointF middle(center_.x() * size.width(), center_.y() * size.height());
    return (picture - middle) * scale() + QPointF(width() / 2.0, height() / 2.0);
}

QPointF ResultView::toPicture(QPointF widget) const {
    const QSize size = pictureSize();
    const QPointF middle(center_.x() * size.width(), center_.y() * size.height());
    return (widget - QPointF(width() / 2.0, height() / 2.0)) / scale() + middle;
}

std::optional<relief::PixelChoice> ResultView::pixelAt(QPointF widget) const {
    const QPointF p = toPicture(widget);
    const relief::PixelChoice pixel{static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
    const QSize size = pictureSize();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width() || pixel.y >= size.height()) return std::nullopt;
    return pixel;
}

void ResultView::resetZoom() {
    zoom_ = 1;
    center_ = {0.5, 0.5};
    update();
}

void ResultView::zoom(double factor, QPointF at) {
    const QPointF fixed = toPicture(at);
    zoom_ = std::clamp(zoom_ * factor, 1.0, kLargestZoom);
    const QPointF moved = fixed - toPicture(at);
    const QSize size = pictureSize();
    center_ += QPointF(moved.x() / size.width(), moved.y() / size.height());
    if (zoom_ == 1.0) center_ = {0.5, 0.5};
    update();
}

void ResultView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), toColor(workspace_->style().background()));
    if (!workspace_->snapshot()) {
        paintEmpty(painter);
        return;
    }
    paintPicture(painter);
    paintOverlays(painter);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ResultView::paintEmpty(QPainter& painter) const {
    painter.setPen(toColor(workspace_->style().text()));
    const QString text = workspace_->busy() ? tr("Drawing the first picture…")
                                            : tr("No picture yet: open a height map, or drop one here.");
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void ResultView::paintPicture(QPainter& painter) const {
    const auto snapshot = workspace_->snapshot();
    const QImage& image = snapshot->layer.image;
    const QSize size = pictureSize();
    const QRectF target(toWidget({0, 0}), toWidget({double(size.width()), double(size.height())}));
    // Texels stay sharp when enlarged; a coarse picture is a picture of something smooth.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < 1 || snapshot->coarse);
    painter.drawImage(target, image);
}

void ResultView::paintOverlays(QPainter& painter) const {
    const auto snapshot = workspace_->snapshot();
    const Style& style = workspace_->style();
    const int margin = 8;
    paintLegend(&painter, snapshot->layer, QPoint(margin, height() - margin), style);
    if (!snapshot->scenario.pixel) return;
    const relief::PixelChoice pixel = *snapshot->scenario.pixel;
    const QPointF at = toWidget({pixel.x + 0.5, pixel.y + 0.5});
    paintChosenPixel(painter, at, scale(), style);

    // In the upper corner that is further from the pixel.
    const QSize magnifier = magnifierSize(style, width());
    if (magnifier.width() * 2 > width() || magnifier.height() * 2 > height()) return;
    const bool left = at.x() > width() / 2.0;
    const QPoint corner(left ? margin : width() - margin - magnifier.width(), margin);
    const QSize full = pictureSize();
    const QImage& image = snapshot->layer.image;
    const QPoint center(pixel.x * image.width() / full.width(), pixel.y * image.height() / full.height());
    paintMagnifier(painter, image, center, QRect(corner, magnifier), style);
}

void ResultView::mousePressEvent(QMouseEvent* event) {
    const bool pan = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ControlModifier) != 0);
    if (event->button() != Qt::LeftButton && !pan) return;
    pressed_ = last_ = event->localPos();
    drag_ = pan ? Drag::Pan : Drag::Pressed;
}

void ResultView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    const QPointF delta = at - last_;
    if (drag_ == Drag::Pressed && (at - pressed_).manhattanLength() >= QApplication::startDragDistance()) {
        workspace_->settle();
        drag_ = Drag::Orbit;
    }
    if (drag_ == Drag::Orbit) {
        turn(delta);
        last_ = at;
    } else if (drag_ == Drag::Pan) {
        const QSize size = pictureSize();
        center_ -= QPointF(delta.x() / scale() / size.width(), delta.y() / scale() / size.height());
        last_ = at;
        update();
    } else if (drag_ == Drag::None) {
        tellHover(at);
    }
}

void ResultView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag ended = drag_;
    drag_ = Drag::None;
    if (ended == Drag::Orbit) workspace_->settle();
    if (ended != Drag::Pressed) return;
    const auto pixel = pixelAt(event->localPos());
    if (!pixel) return;
    workspace_->settle();  // each click is a step of undo by itself
    workspace_->choosePixel(pixel->x, pixel->y);
}

void ResultView::turn(QPointF delta) {
    if (!workspace_->snapshot()) return;
    relief::Scenario scenario = workspace_->scenario();
    scenario.camera = turned(scenario.camera, -delta.x() * kDegreesPerPixel, delta.y() * kDegreesPerPixel);
    workspace_->change(scenario, tr("Turn the camera"), QStringLiteral("orbit"), true);
}

void ResultView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    event->accept();
    if (notches == 0 || !workspace_->snapshot()) return;
    if ((event->modifiers() & Qt::ControlModifier) != 0) {
        zoom(std::pow(kWheelFactor, 2 * notches), event->position());
        return;
    }
    relief::Scenario scenario = workspace_->scenario();
    scenario.camera = moved(scenario.camera, std::pow(kWheelFactor, -notches));
    workspace_->change(scenario, tr("Move the camera"), QStringLiteral("distance"), true);
    wheelRest_.start();
}

bool ResultView::movePixel(int key, bool far) {
    const int by = far ? kFarPixels : 1;
    QPoint move;
    switch (key) {
        case Qt::Key_Left:
            move = {-by, 0};
            break;
        case Qt::Key_Right:
            move = {by, 0};
            break;
        case Qt::Key_Up:
            move = {0, -by};
            break;
        case Qt::Key_Down:
            move = {0, by};
            break;
        default:
            return false;
    }
    const relief::Scenario& scenario = workspace_->scenario();
    const relief::PixelChoice from =
        scenario.pixel.value_or(relief::PixelChoice{scenario.width / 2, scenario.height / 2});
    workspace_->choosePixel(from.x + move.x(), from.y + move.y());
    return true;
}

void ResultView::keyPressEvent(QKeyEvent* event) {
    if (movePixel(event->key(), (event->modifiers() & Qt::ShiftModifier) != 0)) return;
    if (event->key() == Qt::Key_R && event->modifiers() == Qt::NoModifier) {
        resetZoom();
        return;
    }
    if ((event->modifiers() & Qt::ControlModifier) != 0 &&
        (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal || event->key() == Qt::Key_Minus)) {
        zoom(event->key() == Qt::Key_Minus ? 1 / (kWheelFactor * kWheelFactor) : kWheelFactor * kWheelFactor,
             rect().center());
        return;
    }
    QWidget::keyPressEvent(event);
}

void ResultView::tellHover(QPointF at) {
    const auto snapshot = workspace_->snapshot();
    const auto pixel = pixelAt(at);
    Q_EMIT hovered(snapshot && pixel ? pixelReadout(*snapshot, *pixel, true).join(QStringLiteral("   ")) : QString());
}

void ResultView::leaveEvent(QEvent*) {
    Q_EMIT hovered({});
}

void ResultView::contextMenuEvent(QContextMenuEvent* event) {
    Q_EMIT menuRequested(event->globalPos());
}

bool ResultView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const auto snapshot = workspace_->snapshot();
    const auto pixel = pixelAt(help->pos());
    if (snapshot && pixel) {
        QToolTip::showText(help->globalPos(), pixelReadout(*snapshot, *pixel).join('\n'), this);
    } else {
        QToolTip::hideText();
    }
    return true;
}

}  // namespace reliefui
