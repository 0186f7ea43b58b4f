#include "panes/drawing_canvas.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "painting/painter.h"
#include "painting/paragraph.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kNear = 20000;    // largest zoom, relative to the home scale
constexpr double kFar = 0.5;       // smallest zoom
constexpr double kClickReach = 4;  // largest movement of a click, in pixels

}  // namespace

DrawingCanvas::DrawingCanvas(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
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
    update();
    if (pointer_) deferredReading_.start();
}

std::shared_ptr<const Drawing> DrawingCanvas::showLegend(Drawing legend, double most) {
    if (legend.bounds.height() * style_.pixelsPerPoint() > most * height()) legend = {};
    auto shown = std::make_shared<const Drawing>(std::move(legend));
    setLayers({}, shown);
    return shown;
}

double DrawingCanvas::legendWidth() const {
    return width() / style_.pixelsPerPoint() - 2 * kFigureMargin;
}

void DrawingCanvas::showText(const relief::Message& text) {
    auto words = std::make_shared<Drawing>();
    words->bounds = {0, 0, std::max(1.0, legendWidth()), 1};
    addParagraph(*words, words->bounds.center(), text, words->bounds.width(), style_.language);
    setLayers({std::move(words)}, nullptr);
}

void DrawingCanvas::releaseContents() {
    layers_.clear();
    legend_.reset();
    cells_ = {};
    update();
}

void DrawingCanvas::setStyle(const Style& style) {
    style_ = style;
    if (home_) map_ = ViewMap::fitting(bounds(), screenRoom());
    update();
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
    const double margin = kFigureMargin * deviceStyle().pixelsPerPoint();
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
    const double margin = kFigureMargin * deviceStyle().pixelsPerPoint();
    return map_.toDrawing(screenRoom().grown(margin / 2));
}

double DrawingCanvas::zoom() const {
    return map_.scale / deviceStyle().pixelsPerPoint();
}

// The legend stands at the lower edge.
ViewMap DrawingCanvas::legendMap() const {
    const double unit = deviceStyle().pixelsPerPoint();
    return {unit, kFigureMargin * unit, height() * devicePixelRatioF() - legendHeight() - kFigureMargin * unit / 2};
}

ItemId DrawingCanvas::itemAt(QPointF widget) const {
    const QPointF at = widget * devicePixelRatioF();
    const double unit = deviceStyle().pixelsPerPoint();
    if (legend_ && !legend_->bounds.empty()) {
        const Point legend = legendMap().toDrawing(Point{at.x(), at.y()});
        for (const Item& item : legend_->items) {
            const auto* const bar = std::get_if<Rectangle>(&item.primitive);
            if (bar != nullptr && item.id.kind == ItemKind::ColorBar && bar->box.contains(legend)) return item.id;
        }
    }
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
        if (const ItemId id = pick(**layer, map_, {at.x(), at.y()}, unit)) return id;
    }
    return {};
}

void DrawingCanvas::resetZoom() {
    home_ = true;
    map_ = ViewMap::fitting(bounds(), screenRoom());
    update();
    if (pointer_) deferredReading_.start();
    Q_EMIT moved();
}

void DrawingCanvas::zoomTo(const Box& drawing) {
    const Box room = screenRoom();
    constexpr double kAround = 0.06;
    setMap(ViewMap::fitting(drawing, room.grown(-kAround * std::min(room.width(), room.height()))));
}

// Limits the map, so that the drawing cannot be moved out of view or zoomed beyond the limits.
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
    update();
    if (pointer_) deferredReading_.start();
    Q_EMIT moved();
}

// Reads out what lies under a resting pointer, after another drawing or part of it has come there.
void DrawingCanvas::readAgain() {
    if (!pointer_ || dragging_) return;
    const QPointF at = *pointer_;
    Q_EMIT hovered(itemAt(at));
    Q_EMIT pointed(at);
}

void DrawingCanvas::paintEvent(QPaintEvent*) {
    const DrawingTime time("pane");
    const double ratio = devicePixelRatioF();
    const Style style = deviceStyle();
    const Box screen{0, 0, width() * ratio, height() * ratio};
    QPainter painter(this);
    painter.scale(1 / ratio, 1 / ratio);
    painter.fillRect(QRectF(0, 0, screen.x1, screen.y1), toColor(style.background()));
    cells_.begin();
    for (const auto& layer : layers_) reliefui::paint(painter, *layer, map_, style, screen, &cells_);
    cells_.end();
    if (!legend_) return;
    reliefui::paint(painter, *legend_, legendMap(), style, screen);
}

void DrawingCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    Q_EMIT resized();
    if (home_) map_ = ViewMap::fitting(bounds(), screenRoom());
    update();
}

void DrawingCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    pressed_ = last_ = event->localPos();
    dragging_ = false;
}

void DrawingCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    pointer_ = at;
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
            Q_EMIT pointQueried(event->localPos());
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
    QWidget::leaveEvent(event);
    pointer_.reset();
    Q_EMIT hovered({});
    Q_EMIT left();
}

void DrawingCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_R && event->modifiers() == Qt::NoModifier) {
        resetZoom();
    } else {
        event->ignore();  // left for the window's shortcuts
    }
}

}  // namespace reliefui
