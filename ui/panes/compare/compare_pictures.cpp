// The pictures of the compare pane: painting and mouse and key events.
#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "painting/painter.h"
#include "painting/view_map.h"
#include "panes/compare/compare_painting.h"
#include "panes/compare/compare_view.h"
#include "panes/result/result_painting.h"
#include "scenario/step_sentence.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kReach = 6;  // pick distance of a divider, in points
// Delay before an outdated picture is veiled; during a drag it is replaced sooner.
constexpr int kVeilMs = 150;

}  // namespace

ComparePictures::ComparePictures(Workspace* workspace, QWidget* parent) : PictureView(workspace, parent) {
    setObjectName(QStringLiteral("compare-pictures"));
    setAccessibleName(tr("Compare: the pictures side by side"));
    veil_.setSingleShot(true);
    connect(&veil_, &QTimer::timeout, this, [this] {
        pending_.veil = true;
        relayout();
    });
}

relief::Scenario ComparePictures::currentScenario() const {
    relief::Scenario scenario = workspace()->scenario();
    if (dragged_) scenario.comparison.dividers = dividers_;
    return scenario;
}

bool ComparePictures::outdated() const {
    const std::size_t count = relief::comparedOf(workspace()->scenario()).size();
    for (std::size_t n = 0; n < count && view_; ++n) {
        if (!view_->current(workspace()->scenario(), n)) return true;
    }
    return false;
}

void ComparePictures::setProgress(double fraction) {
    const bool part = fraction > 0 && fraction < 1;
    constexpr double kHundred = 100;
    pending_.stopped = false;
    setPendingText(part ? relief::Message(relief::MessageId::DrawComparePendingPart,
                                          {{"percent", static_cast<int>(fraction * kHundred)}})
                        : relief::Message(relief::MessageId::DrawComparePending));
}

void ComparePictures::setStopped() {
    pending_.stopped = true;
    setPendingText(relief::Message(relief::MessageId::DrawCompareStopped));
}

void ComparePictures::setPendingText(relief::Message text) {
    pending_.text = std::move(text);
    relayout();
}

void ComparePictures::show(std::shared_ptr<const ComparedView> view, relief::MessageId why) {
    view_ = std::move(view);
    why_ = why;
    veil_.stop();
    pending_.veil = false;
    setProgress(0);
}

void ComparePictures::setShown(std::size_t number) {
    if (!view_ || view_->pictures.empty()) return;
    shown_ = number % view_->pictures.size();
    relayout();
}

void ComparePictures::relayout() {
    if (view_) {
        const Box page{0, 0, double(width()), double(height())};
        const bool late = outdated();
        if (!late) {
            veil_.stop();
            pending_.veil = false;
        } else if (!pending_.veil && !veil_.isActive()) {
            veil_.start(kVeilMs);
        }
        CompareSource source = compareSource(*view_, currentScenario(), shown_, pending_);
        // Reserves as many text lines as before: the numbers will return to the same place.
        if ((late || view_->coarse) && mode_ == source.mode) source.lines = lines_;
        ComparePage parts = comparePage(source, page, workspace()->style(), false);
        errors_ = std::move(source.errors);
        mode_ = source.mode;
        lines_ = parts.layout.lines;
        setMinimumHeight(static_cast<int>(std::ceil(parts.leastHeight)));
        layout_ = std::move(parts.layout);
        legend_ = std::move(parts.legend);
        room_ = parts.room;
    } else {
        layout_ = {};
        setMinimumHeight(0);
        legend_ = {};
        errors_.reset();
    }
    update();
    readAgain();
}

QRectF ComparePictures::onScreen(const Box& points) const {
    const Box b = ViewMap{unit(), room_.x0, room_.y0}.toScreen(points);
    return {b.x0, b.y0, b.width(), b.height()};
}

std::optional<std::size_t> ComparePictures::pictureAt(QPointF widget) const {
    for (std::size_t n = 0; n < layout_.clips.size(); ++n) {
        if (!layout_.clips[n].empty() && onScreen(layout_.clips[n]).contains(widget)) return n;
    }
    return std::nullopt;
}

QRectF ComparePictures::roomAt(QPointF widget) const {
    const auto number = pictureAt(widget);
    return number ? onScreen(layout_.rooms[*number]) : QRectF();
}

std::optional<QPointF> ComparePictures::pixelIn(std::size_t method, relief::PixelChoice pixel) const {
    if (method >= layout_.clips.size() || layout_.clips[method].empty()) return std::nullopt;
    const QPointF at = inRoom({pixel.x + 0.5, pixel.y + 0.5}, onScreen(layout_.rooms[method]));
    if (!onScreen(layout_.clips[method]).contains(at)) return std::nullopt;
    return at;
}

std::optional<std::size_t> ComparePictures::dividerAt(QPointF widget) const {
    if (layout_.dividers.empty() || layout_.rooms.empty()) return std::nullopt;
    const QRectF room = onScreen(layout_.rooms.front());
    if (!room.contains(widget)) return std::nullopt;
    std::optional<std::size_t> nearest;
    double distance = kReach * unit();
    for (std::size_t n = 0; n < layout_.dividers.size(); ++n) {
        const double x = room.x() + layout_.dividers[n] * room.width();
        if (std::abs(x - widget.x()) > distance) continue;
        distance = std::abs(x - widget.x());
        nearest = n;
    }
    return nearest;
}

void ComparePictures::paintEvent(QPaintEvent*) {
    const PauseLog::Part part("compare: pictures");
    QPainter painter(this);
    const Style& style = workspace()->style();
    painter.fillRect(rect(), toColor(style.background()));
    if (!view_) {
        painter.setPen(toColor(style.text()));
        const std::string text = relief::sentence(relief::Message(why_), style.language);
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         QString::fromStdString(text));
    } else {
        const Box page{0, 0, double(width()), double(height())};
        paintCompare(painter, *view_, currentScenario().comparison, {layout_, legend_, room_}, page, style,
                     workspace()->scenario().pixel, [this](const QRectF& room) { return pictureIn(room); });
    }
    if (!hasFocus()) return;
    painter.setPen(palette().color(QPalette::Highlight));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void ComparePictures::resizeEvent(QResizeEvent* event) {
    PictureView::resizeEvent(event);
    relayout();
}

std::optional<RangedValues> ComparePictures::errors() const {
    if (!errors_ || currentScenario().comparison.mode != relief::CompareMode::Difference) return std::nullopt;
    RangedValues values = *errors_;
    values.name =
        relief::sentence(compareErrorName(currentScenario().comparison.measure), workspace()->style().language);
    return values;
}

QRectF ComparePictures::legendBar() const {
    const Box page{0, 0, double(width()), double(height())};
    const ViewMap map = legendMap(legend_, page, workspace()->style());
    for (const Item& item : legend_.items) {
        const auto* const bar = std::get_if<Rectangle>(&item.primitive);
        if (bar == nullptr || item.id.kind != ItemKind::ColorBar) continue;
        const Box b = map.toScreen(bar->box);
        return {b.x0, b.y0, b.width(), b.height()};
    }
    return {};
}

void ComparePictures::mousePressEvent(QMouseEvent* event) {
    const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
    if (plain && legendBar().contains(event->localPos())) return Q_EMIT rangeRequested();
    const auto divider = plain ? dividerAt(event->localPos()) : std::nullopt;
    if (!divider) return PictureView::mousePressEvent(event);
    dividers_ = layout_.dividers;
    dragged_ = divider;
}

void ComparePictures::mouseMoveEvent(QMouseEvent* event) {
    if (!dragged_) {
        const bool over = (event->buttons() == Qt::NoButton) && dividerAt(event->localPos()).has_value();
        setCursor(over ? Qt::SplitHCursor : Qt::ArrowCursor);
        return PictureView::mouseMoveEvent(event);
    }
    // The dividers changed during the drag, by undo or another mode.
    if (!dragsFit()) return dragged_.reset();
    const QRectF room = onScreen(layout_.rooms.front());
    const std::size_t n = *dragged_;
    const double low = n == 0 ? 0 : dividers_[n - 1];
    const double high = n + 1 == dividers_.size() ? 1 : dividers_[n + 1];
    constexpr double kUnit = 1e-4;
    const double share = (event->localPos().x() - room.x()) / std::max(1.0, room.width());
    dividers_[n] = std::clamp(std::round(share / kUnit) * kUnit, low, high);
    relayout();
}

void ComparePictures::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragged_) return PictureView::mouseReleaseEvent(event);
    relief::Scenario scenario = workspace()->scenario();
    const bool fits = dragsFit();
    dragged_.reset();
    if (!fits) return;
    scenario.comparison.dividers = dividers_;
    workspace()->finishInteraction();
    workspace()->change(scenario, changeName([] { return tr("Move the divider"); }));
    relayout();
}

// Alt with left or right moves the divider, Alt with up or down selects another one; Shift: larger steps.
bool ComparePictures::moveDivider(QKeyEvent* event) {
    constexpr double kStep = 0.01;
    constexpr double kFarStep = 0.1;
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    const int key = event->key();
    if ((event->modifiers() & ~Qt::ShiftModifier) != Qt::AltModifier || layout_.dividers.empty() || dragged_)
        return false;
    const std::size_t count = layout_.dividers.size();
    held_ = std::min(held_, count - 1);
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
        if (count > 1) workspace()->finishInteraction();  // the moves of each are an undo step of their own
        held_ = (held_ + (key == Qt::Key_Down ? 1 : count - 1)) % count;
        Q_EMIT hovered(tr("divider %1 of %2").arg(held_ + 1).arg(count));
        return true;
    }
    if (key != Qt::Key_Left && key != Qt::Key_Right) return false;
    std::vector<double> dividers = layout_.dividers;
    const double low = held_ == 0 ? 0 : dividers[held_ - 1];
    const double high = held_ + 1 == count ? 1 : dividers[held_ + 1];
    const double by = (key == Qt::Key_Left ? -1 : 1) * (shift ? kFarStep : kStep);
    dividers[held_] = std::clamp(dividers[held_] + by, low, high);
    relief::Scenario scenario = workspace()->scenario();
    scenario.comparison.dividers = dividers;
    workspace()->change(scenario, changeName([] { return tr("Move the divider"); }), QStringLiteral("divider"));
    relayout();
    return true;
}

// In modes that show one picture at a time, a letter selects it.
void ComparePictures::keyPressEvent(QKeyEvent* event) {
    if (moveDivider(event)) return;
    const int number = event->key() - Qt::Key_A;
    const bool letter = event->modifiers() == Qt::NoModifier && number >= 0 && view_ &&
                        number < static_cast<int>(view_->pictures.size());
    if (!letter || currentScenario().comparison.mode != relief::CompareMode::Flicker)
        return PictureView::keyPressEvent(event);
    Q_EMIT flickerStopped();
    setShown(static_cast<std::size_t>(number));
}

QStringList ComparePictures::readouts(relief::PixelChoice pixel) const {
    if (!view_) return {};
    QStringList lines{tr("pixel (%1, %2)").arg(pixel.x).arg(pixel.y)};
    for (std::size_t n = 0; n < view_->pictures.size(); ++n) {
        lines << compareReadout(*view_, workspace()->scenario(), n, pixel);
    }
    lines.removeAll({});
    return lines;
}

void ComparePictures::readOutHover(QPointF at) {
    const auto pixel = pixelAt(at);
    Q_EMIT hovered(pixel ? readouts(*pixel).join(QStringLiteral(" · ")) : QString());
}

void ComparePictures::leaveEvent(QEvent* event) {
    PictureView::leaveEvent(event);
    Q_EMIT hovered({});
}

bool ComparePictures::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PictureView::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const auto pixel = pixelAt(help->pos());
    if (pixel && view_) {
        QToolTip::showText(help->globalPos(), readouts(*pixel).join('\n'), this);
    } else {
        QToolTip::hideText();
    }
    return true;
}

}  // namespace reliefui
