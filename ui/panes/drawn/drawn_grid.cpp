// The view of the relief edited by hand, and its reaction to mouse and keys.
#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "painting/painter.h"
#include "panes/drawn/drawn_view.h"
#include "scenario/step_sentence.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// Heights are rounded to multiples of this, which keeps numbers short on the screen and in the file.
constexpr double kHeightUnit = 0.001;
constexpr double kFullDrag = 150;  // length of a drag from height 0 to 1, in points
constexpr double kStep = 0.01;     // change of height by a key
constexpr double kLargeStep = 0.1;

double rounded(double height) {
    return std::clamp(std::round(height / kHeightUnit) / std::round(1 / kHeightUnit), 0.0, 1.0);
}

// Returns false if the relief has changed its size since the texel was chosen.
bool holds(const relief::DrawnRelief& drawn, std::pair<int, int> texel) {
    return !drawn.empty() && texel.first < drawn.width && texel.second < (drawn.profile() ? 1 : drawn.height);
}

struct Parts {
    DrawnPicture picture;
    Drawing legend;
    ViewMap map;
};

Parts partsOf(const DrawnSource& source, const Box& page, const Style& style) {
    constexpr double kMostLegend = 0.2;
    Parts parts;
    parts.legend = drawnLegend(source, page.width() / style.pixelsPerPoint() - 12, style.language);
    if (parts.legend.bounds.height() * style.pixelsPerPoint() > kMostLegend * page.height()) parts.legend = {};
    const Box room = figureRoom(parts.legend, page, style);
    parts.picture = drawnPicture(source, room.height() / std::max(1.0, room.width()));
    parts.map = ViewMap::fitting(parts.picture.drawing.bounds, room);
    return parts;
}

}  // namespace

DrawnSource drawnSource(const Snapshot& snapshot) {
    DrawnSource source;
    source.relief = snapshot.scenario.pictures.drawn;
    source.surface = snapshot.scenario.surface;
    source.address = snapshot.scenario.address;
    source.hasRay = snapshot.trace.onRelief && !source.relief.empty();
    source.ray = snapshot.trace.ray;
    source.hit = snapshot.trace.hit;
    return source;
}

void paintDrawn(QPainter& painter, const DrawnSource& source, const Box& page, const Style& style) {
    const Parts parts = partsOf(source, page, style);
    paintFigure(painter, {&parts.picture.drawing}, parts.legend, page, style);
}

DrawnGrid::DrawnGrid(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
    setObjectName(QStringLiteral("drawn-grid"));
    setAccessibleName(tr("Relief by hand: its texels"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void DrawnGrid::choose(std::optional<std::pair<int, int>> texel) {
    if (texel == chosen_) return;
    // Each texel's changes are an undo step of their own, except those of the columns that one drag draws.
    if (!dragging_) workspace_->finishInteraction();
    chosen_ = texel;
    refresh();
    Q_EMIT chosenChanged();
}

// Shows the scenario's relief at once; the ray follows with the snapshot.
void DrawnGrid::refresh() {
    const PauseLog::Part part("by hand: grid");
    const auto snapshot = workspace_->snapshot();
    source_ = snapshot ? drawnSource(*snapshot) : DrawnSource{};
    source_.hasRay = source_.hasRay && source_.relief.width == drawn().width &&
                     source_.relief.height == drawn().height && source_.relief.profile() == drawn().profile();
    source_.relief = drawn();
    source_.surface = workspace_->scenario().surface;
    source_.address = workspace_->scenario().address;
    if (chosen_ && !holds(drawn(), *chosen_)) {
        chosen_.reset();
        Q_EMIT chosenChanged();
    }
    source_.chosen = chosen_;
    const Style& style = workspace_->style();
    Parts parts = partsOf(source_, {0, 0, double(width()), double(height())}, style);
    picture_ = std::move(parts.picture);
    legend_ = std::move(parts.legend);
    map_ = parts.map;
    update();
    if (pointer_) readOut(*pointer_);
}

Point DrawnGrid::toDrawing(QPointF widget) const {
    return map_.toDrawing(Point{widget.x(), widget.y()});
}

QPointF DrawnGrid::placeOf(int i, int j, double height) const {
    const double y = picture_.profile ? picture_.body.y1 - height * picture_.body.height() : j + 0.5;
    const Point at = map_.toScreen(Point{i + 0.5, y});
    return {at.x, at.y};
}

void DrawnGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Style& style = workspace_->style();
    const Box page{0, 0, double(width()), double(height())};
    if (drawn().empty()) {
        painter.fillRect(rect(), toColor(style.background()));
        painter.setPen(toColor(style.text()));
        const std::string text = relief::sentence(relief::Message(relief::MessageId::DrawDrawnNone), style.language);
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         QString::fromStdString(text));
    } else {
        paintFigure(painter, {&picture_.drawing}, legend_, page, style);
    }
    if (!hasFocus()) return;
    painter.setPen(palette().color(QPalette::Highlight));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void DrawnGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    refresh();
}

void DrawnGrid::setHeights(int first, int last, int row, double height) {
    relief::Scenario scenario = workspace_->scenario();
    relief::DrawnRelief& drawn = scenario.pictures.drawn;
    if (!holds(drawn, {std::max(first, last), row})) return;
    for (int i = std::min(first, last); i <= std::max(first, last); ++i) {
        drawn.heights[static_cast<std::size_t>(drawn.profile() ? i : row * drawn.width + i)] = rounded(height);
    }
    workspace_->change(scenario, changeName([] { return tr("Drag a height"); }), QStringLiteral("drawn"), true);
}

void DrawnGrid::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const auto texel = drawnTexelAt(picture_, drawn(), toDrawing(event->localPos()));
    choose(texel);
    if (!texel) return;
    workspace_->finishInteraction();  // each drag is an undo step of its own
    dragging_ = true;
    pressed_ = event->localPos();
    from_ = drawn().at(texel->first, texel->second);
    lastColumn_ = texel->first;
}

void DrawnGrid::drag(QPointF at) {
    if (!picture_.profile) {
        const double by = (pressed_.y() - at.y()) / (kFullDrag * workspace_->style().pixelsPerPoint());
        return setHeights(chosen_->first, chosen_->first, chosen_->second, from_ + by);
    }
    // In a profile the pointer draws: all columns that it has passed are set, however fast it moves.
    const Point place = toDrawing(at);
    const int column = std::clamp(static_cast<int>(std::floor(place.x)), 0, drawn().width - 1);
    const int from = column == lastColumn_ ? column : lastColumn_ + (column > lastColumn_ ? 1 : -1);
    setHeights(from, column, 0, drawnHeightAt(picture_, place));
    lastColumn_ = column;
    choose(std::pair{column, 0});
}

void DrawnGrid::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->localPos();
    if (dragging_ && chosen_ && holds(drawn(), *chosen_)) drag(event->localPos());
    readOut(event->localPos());
}

void DrawnGrid::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragging_ || event->button() != Qt::LeftButton) return;
    dragging_ = false;
    workspace_->finishInteraction();
}

void DrawnGrid::mouseDoubleClickEvent(QMouseEvent* event) {
    choose(drawnTexelAt(picture_, drawn(), toDrawing(event->localPos())));
    if (chosen_) Q_EMIT typingRequested(nullptr);
}

// Arrow keys choose a neighbouring texel; + and − raise and lower it (Shift: by more).
bool DrawnGrid::step(int key, bool large) {
    if (!holds(drawn(), chosen_.value_or(std::pair{0, 0}))) return false;
    auto [i, j] = chosen_.value_or(std::pair{0, 0});
    const int rows = drawn().profile() ? 1 : drawn().height;
    const double by = large ? kLargeStep : kStep;
    switch (key) {
        case Qt::Key_Left:
            choose(std::pair{std::max(0, i - 1), j});
            return true;
        case Qt::Key_Right:
            choose(std::pair{std::min(drawn().width - 1, i + 1), j});
            return true;
        case Qt::Key_Up:
            choose(std::pair{i, std::max(0, j - 1)});
            return true;
        case Qt::Key_Down:
            choose(std::pair{i, std::min(rows - 1, j + 1)});
            return true;
        case Qt::Key_Plus:
        case Qt::Key_PageUp:
            choose(std::pair{i, j});
            setHeights(i, i, j, drawn().at(i, j) + by);
            return true;
        case Qt::Key_Minus:
        case Qt::Key_PageDown:
            choose(std::pair{i, j});
            setHeights(i, i, j, drawn().at(i, j) - by);
            return true;
        default:
            return false;
    }
}

// A digit starts typing the height of the chosen texel.
bool DrawnGrid::typesHeight(const QKeyEvent& event) const {
    const bool plain = (event.modifiers() & ~Qt::KeypadModifier) == 0;
    return chosen_ && plain && event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9;
}

// Claims digits, which otherwise choose panes.
bool DrawnGrid::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && typesHeight(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void DrawnGrid::keyPressEvent(QKeyEvent* event) {
    if (step(event->key(), (event->modifiers() & Qt::ShiftModifier) != 0)) return;
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (typesHeight(*event) || (chosen_ && enter)) {
        Q_EMIT typingRequested(enter ? nullptr : event);
        return;
    }
    QWidget::keyPressEvent(event);
}

void DrawnGrid::readOut(QPointF at) {
    const auto texel = drawnTexelAt(picture_, drawn(), toDrawing(at));
    if (!texel) {
        Q_EMIT hovered({});
        return;
    }
    const QString height = QString::fromStdString(relief::fixedText(drawn().at(texel->first, texel->second), 3));
    Q_EMIT hovered(drawn().profile()
                       ? tr("column %1: height %2").arg(texel->first).arg(height)
                       : tr("texel (%1, %2): height %3").arg(texel->first).arg(texel->second).arg(height));
}

void DrawnGrid::leaveEvent(QEvent*) {
    pointer_.reset();
    Q_EMIT hovered({});
}

}  // namespace reliefui
