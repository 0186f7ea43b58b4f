#include "panes/picture_view.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "panes/orbit.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr double kDegreesPerPixel = 0.3;
constexpr double kWheelFactor = 1.12;  // per notch of the wheel
constexpr double kLargestZoom = 256;
constexpr int kWheelRestMs = 150;
constexpr int kFarPixels = 10;

}  // namespace

PictureView::PictureView(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_OpaquePaintEvent);
    wheelRest_.setSingleShot(true);
    wheelRest_.setInterval(kWheelRestMs);
    connect(&wheelRest_, &QTimer::timeout, workspace_, &Workspace::finishInteraction);
}

QSize PictureView::pictureSize() const {
    const auto snapshot = workspace_->snapshot();
    const relief::Scenario& scenario = snapshot ? snapshot->scenario : workspace_->scenario();
    return {scenario.width, scenario.height};
}

double PictureView::scaleIn(const QRectF& room) const {
    const QSize size = pictureSize();
    return zoom_ * std::min(room.width() / size.width(), room.height() / size.height());
}

QPointF PictureView::inRoom(QPointF picture, const QRectF& room) const {
    const QSize size = pictureSize();
    const QPointF middle(center_.x() * size.width(), center_.y() * size.height());
    return (picture - middle) * scaleIn(room) + room.center();
}

QPointF PictureView::fromRoom(QPointF widget, const QRectF& room) const {
    const QSize size = pictureSize();
    const QPointF middle(center_.x() * size.width(), center_.y() * size.height());
    return (widget - room.center()) / scaleIn(room) + middle;
}

QRectF PictureView::pictureIn(const QRectF& room) const {
    const QSize size = pictureSize();
    return {inRoom({0, 0}, room), inRoom({double(size.width()), double(size.height())}, room)};
}

std::optional<relief::PixelChoice> PictureView::pixelAt(QPointF widget) const {
    const QRectF room = roomAt(widget);
    if (room.isEmpty()) return std::nullopt;
    const QPointF p = fromRoom(widget, room);
    const relief::PixelChoice pixel{static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
    const QSize size = pictureSize();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width() || pixel.y >= size.height()) return std::nullopt;
    return pixel;
}

void PictureView::resetZoom() {
    zoom_ = 1;
    center_ = {0.5, 0.5};
    update();
    readAgain();
}

void PictureView::readAgain() {
    if (pointer_ && drag_ == Drag::None) readOutHover(*pointer_);
}

void PictureView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    pointer_.reset();
}

void PictureView::zoom(double factor, QPointF at) {
    const QRectF room = roomAt(at);
    if (room.isEmpty()) return;
    const QPointF fixed = fromRoom(at, room);
    zoom_ = std::clamp(zoom_ * factor, 1.0, kLargestZoom);
    const QPointF moved = fixed - fromRoom(at, room);
    const QSize size = pictureSize();
    center_ += QPointF(moved.x() / size.width(), moved.y() / size.height());
    if (zoom_ == 1.0) center_ = {0.5, 0.5};
    update();
    readAgain();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
    const bool pan = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ControlModifier) != 0);
    if (event->button() != Qt::LeftButton && !pan) return;
    pressed_ = last_ = event->localPos();
    drag_ = pan ? Drag::Pan : Drag::Pressed;
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    const QPointF delta = at - last_;
    pointer_ = at;
    if (drag_ == Drag::Pressed && (at - pressed_).manhattanLength() >= QApplication::startDragDistance()) {
        workspace_->finishInteraction();
        drag_ = Drag::Orbit;
    }
    if (drag_ == Drag::Orbit) {
        turn(delta);
        last_ = at;
    } else if (drag_ == Drag::Pan) {
        const QRectF room = roomAt(pressed_);
        const QSize size = pictureSize();
        if (!room.isEmpty()) {
            center_ -= QPointF(delta.x() / scaleIn(room) / size.width(), delta.y() / scaleIn(room) / size.height());
        }
        last_ = at;
        update();
    } else if (drag_ == Drag::None) {
        readOutHover(at);
    }
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
    const Drag ended = drag_;
    drag_ = Drag::None;
    if (ended == Drag::Orbit) workspace_->finishInteraction();
    if (ended != Drag::Pressed) return;
    const auto pixel = pixelAt(event->localPos());
    if (!pixel) return;
    workspace_->finishInteraction();  // each click is an undo step of its own
    workspace_->choosePixel(pixel->x, pixel->y);
}

void PictureView::turn(QPointF delta) {
    if (!workspace_->snapshot()) return;
    relief::Scenario scenario = workspace_->scenario();
    scenario.camera =
        turned(scenario.camera, -delta.x() * kDegreesPerPixel, delta.y() * kDegreesPerPixel, scenario.scene);
    workspace_->change(scenario, changeName([] { return tr("Turn the camera"); }), QStringLiteral("orbit"), true);
}

void PictureView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    event->accept();
    if (notches == 0 || !workspace_->snapshot()) return;
    if ((event->modifiers() & Qt::ControlModifier) != 0) {
        zoom(std::pow(kWheelFactor, 2 * notches), event->position());
        return;
    }
    relief::Scenario scenario = workspace_->scenario();
    scenario.camera = moved(scenario.camera, std::pow(kWheelFactor, -notches));
    workspace_->change(scenario, changeName([] { return tr("Move the camera"); }), QStringLiteral("distance"), true);
    wheelRest_.start();
}

bool PictureView::movePixel(int key, bool far) {
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

void PictureView::keyPressEvent(QKeyEvent* event) {
    if (movePixel(event->key(), (event->modifiers() & Qt::ShiftModifier) != 0)) return;
    if (event->key() == Qt::Key_R && event->modifiers() == Qt::NoModifier) {
        resetZoom();
        return;
    }
    if ((event->modifiers() & Qt::ControlModifier) != 0 &&
        (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal || event->key() == Qt::Key_Minus)) {
        const double factor = kWheelFactor * kWheelFactor;
        // If there is no picture in the middle, the first picture is used.
        const QPointF middle = rect().center();
        zoom(event->key() == Qt::Key_Minus ? 1 / factor : factor, roomAt(middle).isEmpty() ? QPointF(1, 1) : middle);
        return;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace reliefui
