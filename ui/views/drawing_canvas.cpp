#include "views/drawing_canvas.h"

#include <cmath>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "views/drawing_item.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kMargin = 6;      // points
constexpr double kNear = 20000;    // most times the home scale
constexpr double kFar = 0.5;       // least
constexpr double kClickReach = 4;  // pixels that a click may move

}  // namespace

struct DrawingCanvas::Scene {
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkContextActor> actor;
    vtkNew<DrawingItem> item;
};

DrawingCanvas::DrawingCanvas(QWidget* parent) : QVTKOpenGLNativeWidget(parent), scene_(std::make_unique<Scene>()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    // Smooth lines: the pane has few of them, and no depth.
    scene_->window->SetMultiSamples(4);
    scene_->window->AddRenderer(scene_->renderer);
    scene_->item->renderer = scene_->renderer;
    scene_->actor->GetScene()->SetRenderer(scene_->renderer);
    scene_->actor->GetScene()->AddItem(scene_->item);
    scene_->renderer->AddActor(scene_->actor);
    // Text is sized in device pixels already (deviceStyle()); VTK would enlarge it again on fine screens.
    setEnableHiDPI(false);
    setRenderWindow(scene_->window);
    // The grammar of all panes is ours. VTK's gestures would be made of mouse drags, too, and Qt complains of those
    // that end when the pane is hidden.
    for (const Qt::GestureType gesture :
         {Qt::PinchGesture, Qt::PanGesture, Qt::TapGesture, Qt::TapAndHoldGesture, Qt::SwipeGesture}) {
        ungrabGesture(gesture);
    }
    interactor()->SetInteractorStyle(nullptr);
    setStyle(style_);
}

DrawingCanvas::~DrawingCanvas() {
    redrawSoon_.stop();
}

Style DrawingCanvas::deviceStyle() const {
    Style style = style_;
    style.screenPixelsPerPoint *= devicePixelRatioF();
    return style;
}

void DrawingCanvas::setLayers(std::vector<std::shared_ptr<const Drawing>> layers,
                              std::shared_ptr<const Drawing> legend) {
    layers_ = std::move(layers);
    legend_ = std::move(legend);
    if (home_) map_ = ViewMap::fitting(bounds(), screenRoom());
    redraw();
}

void DrawingCanvas::showText(relief::MessageId why) {
    auto drawing = std::make_shared<Drawing>();
    drawing->bounds = {0, 0, 100, 100};
    Label label;
    label.at = drawing->bounds.center();
    label.text = relief::Message(why);
    label.anchor = Anchor::Center;
    drawing->add({}, Role::Label, std::move(label));
    setLayers({std::move(drawing)}, nullptr);
}

void DrawingCanvas::letGo() {
    layers_.clear();
    legend_.reset();
    scene_->item->layers.clear();
    scene_->item->legend.reset();
    redraw();
}

void DrawingCanvas::setStyle(const Style& style) {
    style_ = style;
    const Rgba ground = style.background();
    scene_->renderer->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    if (home_) map_ = ViewMap::fitting(bounds(), screenRoom());
    redraw();
}

Box DrawingCanvas::bounds() const {
    Box all;
    for (const auto& layer : layers_) all = all.joined(layer->bounds);
    return all;
}

double DrawingCanvas::legendHeight() const {
    return legend_ && !legend_->bounds.empty() ? legend_->bounds.height() * deviceStyle().pixelsPerPoint() : 0;
}

Box DrawingCanvas::screenRoom() const {
    const double margin = kMargin * deviceStyle().pixelsPerPoint();
    const double legend = legendHeight();
    return {margin, margin, width() * devicePixelRatioF() - margin,
            height() * devicePixelRatioF() - margin - (legend > 0 ? legend + margin / 2 : 0)};
}

QSizeF DrawingCanvas::room() const {
    const Box room = screenRoom();
    const double unit = deviceStyle().pixelsPerPoint();
    return {std::max(0.0, room.width() / unit), std::max(0.0, room.height() / unit)};
}

QPointF DrawingCanvas::toWidget(Point drawing) const {
    const Point at = map_.toScreen(drawing);
    return QPointF(at.x, at.y) / devicePixelRatioF();
}

Point DrawingCanvas::toDrawing(QPointF widget) const {
    const QPointF at = widget * devicePixelRatioF();
    return map_.toDrawing(Point{at.x(), at.y()});
}

Box DrawingCanvas::visible() const {
    const double margin = kMargin * deviceStyle().pixelsPerPoint();
    return map_.toDrawing(screenRoom().grown(margin / 2));
}

double DrawingCanvas::zoom() const {
    return map_.scale / deviceStyle().pixelsPerPoint();
}

ItemId DrawingCanvas::itemAt(QPointF widget) const {
    const QPointF at = widget * devicePixelRatioF();
    const double unit = deviceStyle().pixelsPerPoint();
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
        if (const ItemId id = pick(**layer, map_, {at.x(), at.y()}, unit)) return id;
    }
    return {};
}

void DrawingCanvas::resetZoom() {
    home_ = true;
    map_ = ViewMap::fitting(bounds(), screenRoom());
    redraw();
    Q_EMIT moved();
}

void DrawingCanvas::zoomTo(const Box& drawing) {
    const Box room = screenRoom();
    constexpr double kAround = 0.06;
    setMap(ViewMap::fitting(drawing, room.grown(-kAround * std::min(room.width(), room.height()))));
}

// Neither lost beyond the edge nor beyond all measure.
void DrawingCanvas::setMap(const ViewMap& map) {
    const Box room = screenRoom();
    const double homeScale = ViewMap::fitting(bounds(), room).scale;
    if (!(map.scale >= homeScale * kFar && map.scale <= homeScale * kNear)) return;
    map_ = map;
    const Box now = map_.toScreen(bounds());
    const double keep = 40 * deviceStyle().pixelsPerPoint();
    map_.dx += std::max(0.0, room.x0 + keep - now.x1) - std::max(0.0, now.x0 - (room.x1 - keep));
    map_.dy += std::max(0.0, room.y0 + keep - now.y1) - std::max(0.0, now.y0 - (room.y1 - keep));
    home_ = false;
    redraw();
    Q_EMIT moved();
}

void DrawingCanvas::redraw() {
    if (isVisible()) redrawSoon_.start();
}

void DrawingCanvas::paint() {
    DrawingItem& item = *scene_->item;
    item.style = deviceStyle();
    item.layers = layers_;
    item.legend = legend_;
    item.map = map_;
    item.width = static_cast<int>(std::lround(width() * devicePixelRatioF()));
    item.height = static_cast<int>(std::lround(height() * devicePixelRatioF()));
    const double unit = item.style.pixelsPerPoint();
    item.legendMap = {unit, kMargin * unit, item.height - legendHeight() - kMargin * unit / 2};
    scene_->actor->GetScene()->SetDirty(true);
    if (!isValid()) return;
    const DrawingTime time("pane");
    scene_->window->Render();
}

void DrawingCanvas::resizeEvent(QResizeEvent* event) {
    QVTKOpenGLNativeWidget::resizeEvent(event);
    Q_EMIT resized();
    if (home_) map_ = ViewMap::fitting(bounds(), screenRoom());
    redrawSoon_.start();
}

void DrawingCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    pressed_ = last_ = event->localPos();
    dragging_ = false;
}

void DrawingCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) == 0) {
        Q_EMIT hovered(itemAt(at));
        Q_EMIT pointed(at);
        return;
    }
    const QPointF moved = at - pressed_;
    if (!dragging_ && std::hypot(moved.x(), moved.y()) <= kClickReach) return;
    dragging_ = true;
    const QPointF by = (at - last_) * devicePixelRatioF();
    last_ = at;
    setMap({map_.scale, map_.dx + by.x(), map_.dy + by.y()});
}

void DrawingCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !dragging_) {
        if ((event->modifiers() & Qt::ControlModifier) != 0) {
            Q_EMIT asked(event->localPos());
        } else {
            Q_EMIT clickedAt(event->localPos());
            Q_EMIT clicked(itemAt(event->localPos()));
        }
    }
    dragging_ = false;
}

void DrawingCanvas::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    const QPointF at = event->position() * devicePixelRatioF();
    setMap(map_.zoomed(std::pow(1.25, notches), {at.x(), at.y()}));
    event->accept();
}

void DrawingCanvas::leaveEvent(QEvent* event) {
    QVTKOpenGLNativeWidget::leaveEvent(event);
    Q_EMIT hovered({});
    Q_EMIT left();
}

// What came while it was hidden was not drawn.
void DrawingCanvas::showEvent(QShowEvent* event) {
    QVTKOpenGLNativeWidget::showEvent(event);
    redrawSoon_.start();
}

void DrawingCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_R && event->modifiers() == Qt::NoModifier) {
        resetZoom();
    } else {
        event->ignore();  // the window's shortcuts
    }
}

}  // namespace reliefui
