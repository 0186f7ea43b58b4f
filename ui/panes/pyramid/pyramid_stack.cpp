#include "panes/pyramid/pyramid_stack.h"

#include <algorithm>
#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "panes/screen_gl.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kClickReach = 4;  // in pixels

}  // namespace

PyramidStack::PyramidStack(QWidget* parent)
    : QWidget(parent),
      widget_(new QVTKOpenGLNativeWidget(glParent(this))),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
    for (const Qt::GestureType gesture : {Qt::TapGesture, Qt::TapAndHoldGesture}) widget_->ungrabGesture(gesture);
    setAccessibleName(tr("Pyramid in 3-D"));
    widget_->setAccessibleName(accessibleName());
    setFocusProxy(widget_);
    widget_->setFocusPolicy(Qt::StrongFocus);
    widget_->setMouseTracking(true);
    window_->SetMultiSamples(0);
    window_->AddRenderer(scene_.renderer());
    // VTK lays out no text in a window one pixel wide or high, and then complains that its texture is empty.
    widget_->setMinimumSize(2, 2);
    widget_->setRenderWindow(window_);
    widget_->interactor()->SetInteractorStyle(nullptr);
    widget_->installEventFilter(this);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    addGlWidget(*widget_, *column, *this);
}

PyramidStack::~PyramidStack() {
    deferredRender_.stop();
}

void PyramidStack::show(const PyramidParts& parts, const Style& style) {
    Style device = style;
    device.screenPixelsPerPoint *= widget_->devicePixelRatioF();
    scene_.show(parts, device);
    const SlabTower& tower = scene_.tower();
    const Box ground = parts.parts.empty() ? Box{} : tower.domain(0);
    const std::pair now(widget_->size(), std::array<double, 3>{ground.width(), ground.height(),
                                                               static_cast<double>(tower.top() + parts.parts.size())});
    if (!turned_) scene_.lookFromHome();
    if (std::exchange(placedFor_, now) != now) showAll();
    deferredRender_.start();
}

void PyramidStack::showStep(int step) {
    scene_.showStep(step);
    deferredRender_.start();
}

void PyramidStack::releaseContents() {
    scene_.releaseContents();
}

QPointF PyramidStack::toWidget(std::size_t part, int level, Point texel) const {
    const std::array<double, 2> pixel = scene_.toPixel(part, level, texel);
    const double ratio = widget_->devicePixelRatioF();
    return {pixel[0] / ratio, widget_->height() - pixel[1] / ratio};
}

bool PyramidStack::drawingAt(QPointF widget, Point& drawing) const {
    const double ratio = widget_->devicePixelRatioF();
    const auto found = scene_.drawingAt(widget.x() * ratio, (widget_->height() - widget.y()) * ratio);
    if (found) drawing = *found;
    return found.has_value();
}

void PyramidStack::showAll() {
    const double ratio = widget_->devicePixelRatioF();
    scene_.showAll(ratio * widget_->width(), ratio * widget_->height());
}

void PyramidStack::fit() {
    turned_ = false;
    scene_.lookFromHome();
    showAll();
    deferredRender_.start();
}

bool PyramidStack::handleMouse(QMouseEvent* event, bool released) {
    if (event->type() == QEvent::MouseButtonPress) {
        widget_->setFocus(Qt::MouseFocusReason);
        pressed_ = last_ = event->localPos();
        return true;
    }
    Point at;
    if (released) {
        const bool click = QLineF(pressed_, event->localPos()).length() <= kClickReach;
        if (click && event->button() == Qt::LeftButton && drawingAt(event->localPos(), at)) Q_EMIT clickedAt(at);
        return true;
    }
    pointer_ = event->localPos();
    if (event->buttons() == Qt::NoButton) {
        readAgain();
        return false;
    }
    const QPointF by = event->localPos() - last_;
    last_ = event->localPos();
    const bool turns = (event->buttons() & Qt::LeftButton) != 0 && (event->modifiers() & Qt::ShiftModifier) == 0;
    turned_ = turned_ || turns;
    turns ? scene_.camera.turn(by.x(), by.y(), widget_->height())
          : scene_.camera.move(by.x(), by.y(), widget_->height());
    deferredRender_.start();
    return true;
}

bool PyramidStack::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            return handleMouse(static_cast<QMouseEvent*>(event), event->type() == QEvent::MouseButtonRelease);
        case QEvent::Wheel: {
            const auto* const wheel = static_cast<QWheelEvent*>(event);
            const double half = widget_->height() / 2.0;
            scene_.camera.zoom(std::pow(1.2, wheel->angleDelta().y() / 120.0),
                               (wheel->position().x() - widget_->width() / 2.0) / half,
                               (half - wheel->position().y()) / half);
            deferredRender_.start();
            return true;
        }
        case QEvent::KeyPress: {
            const auto* const key = static_cast<QKeyEvent*>(event);
            if (key->key() != Qt::Key_R || key->modifiers() != Qt::NoModifier) return false;
            fit();
            return true;
        }
        case QEvent::Leave:
            pointer_.reset();
            return false;
        case QEvent::Resize:
            Q_EMIT resized();
            return false;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

void PyramidStack::render() {
    scene_.place();
    if (!widget_->isVisible() || !widget_->isValid()) return;
    const DrawingTime time("pyramid in 3-D");
    window_->Render();
    readAgain();
}

// Reads out the slab under the pointer, which may rest while other slabs come there.
void PyramidStack::readAgain() {
    Point at;
    if (pointer_) Q_EMIT hoveredAt(drawingAt(*pointer_, at) ? at : Point{NAN, NAN});
}

}  // namespace reliefui
