#include "panes/rows/rows_view.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QWheelEvent>

#include "panes/coefficient_text.h"
#include "panes/drawing_canvas.h"
#include "panes/rows/rows_figure.h"
#include "scenario/step_sentence.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kClickReach = 4;  // largest movement of a click, in pixels
constexpr double kFewestPixels = 4;

QString number(double value, int decimals) {
    return QString::fromStdString(relief::fixedText(value, decimals));
}

}  // namespace

void RowsView::setOptions(const RowsOptions& options) {
    change(options);
}

void RowsView::change(const RowsOptions& options) {
    if (options == options_) return;
    workspace_->change(withState(workspace_->scenario(), paneOf(options)),
                       changeName([] { return tr("Rows: other variants"); }));
    showControls();  // resets the controls if the change was refused
}

void RowsView::adopt() {
    const RowsOptions options = rowsOptions(stateOf<RowsPane>(workspace_->scenario()));
    if (options == options_) return;
    const bool otherRow = options.pixels != options_.pixels;
    const bool sameData = options.methods == options_.methods && !otherRow && options.inDouble == options_.inDouble;
    options_ = options;
    if (otherRow) range_ = {};
    showControls();
    if (sameData) {
        draw();
    } else {
        refresh();
    }
}

bool RowsView::isUpToDate() const {
    return !stale() && !job_->busy();
}

void RowsView::showSnapshot() {
    const PauseLog::Part part("rows");
    canvas_->setStyle(workspace_->style());
    const std::shared_ptr<const Snapshot> snapshot = workspace_->snapshot();
    // Not during a drag, in which the row would soon be outdated.
    if (snapshot && snapshot->coarse) return;
    if (!snapshot || !snapshot->request) return showEmpty(workspace_->whyEmpty());
    if (!snapshot->scenario.pixel) return showEmpty(relief::MessageId::DrawNoRow);
    if (options_.methods.empty()) return showEmpty(relief::MessageId::DrawRowNoVariant);
    const std::optional<RowsPlace> place = rowsPlace(*snapshot);
    if (!place) return showEmpty(relief::MessageId::DrawNoRelief);
    auto data = std::make_shared<RowsData>();
    const auto work = [data, place = *place, options = options_](relief::Work&) {
        *data = rowsData(widened(place, options.pixels), rowMethods(options, "--variants"), options.inDouble);
    };
    const auto done = [this, data, snapshot] {
        const bool sameRow = data_ && data_->place.line == data->place.line && data_->place.span == data->place.span;
        if (!sameRow) range_ = {};
        data_ = data;
        snapshot_ = snapshot;
        draw();
    };
    job_->start({work, done});
}

void RowsView::releaseContents() {
    job_->drop();
    data_.reset();
    snapshot_.reset();
    axes_.reset();
    plots_.reset();
    legend_.reset();
    canvas_->releaseContents();
    setReadout({});
}

void RowsView::draw() {
    const PauseLog::Part part("rows: drawing");
    if (!data_) return;
    if (markStaleIfHidden()) return;
    const Style& style = workspace_->style();
    canvas_->setStyle(style);
    // The legend is laid out first; the plots get the remaining room. A legend that would take too much is shortened,
    // at last to the curves' names, which their numbers alone do not tell.
    constexpr double kMostLegend = 0.34;
    for (const RowsLegend kind : {RowsLegend::Whole, RowsLegend::Curves, RowsLegend::Names}) {
        legend_ = canvas_->showLegend(rowsLegend(*data_, canvas_->legendWidth(), style.language, kind), kMostLegend);
        if (!legend_->bounds.empty()) break;
    }
    const QSizeF room = canvas_->room();
    frame_ = rowsFrame(*data_, options_, range_, room.width(), room.height());
    axes_ = std::make_shared<const Drawing>(rowsAxes(*data_, frame_));
    plots_ = std::make_shared<const Drawing>(rowsPlots(*data_, frame_));
    canvas_->setLayers({axes_, plots_}, legend_);
}

void RowsView::showEmpty(relief::MessageId why) {
    job_->drop();
    data_.reset();
    canvas_->showText(why);
    setReadout({});
}

void RowsView::resetZoom() {
    setRange(0, 0);
}

// Sets the visible range, moved to lie within the row; an empty range or the whole row resets it.
void RowsView::setRange(double from, double to) {
    if (!data_) return;
    const auto first = static_cast<double>(data_->row.span.begin);
    const auto last = static_cast<double>(data_->row.span.end);
    const double size = std::max(to - from, kFewestPixels);
    range_ = {};
    if (to > from && size < last - first) {
        range_.from = std::clamp(from, first, last - size);
        range_.to = range_.from + size;
    }
    draw();
}

void RowsView::zoom(double factor, double x) {
    if (!data_) return;
    const double at = std::clamp(frame_.pixelAt(x), frame_.from, frame_.to);
    setRange(at - (at - frame_.from) / factor, at + (frame_.to - at) / factor);
}

// The common mouse controls, but along the row only: its axes stay visible.
bool RowsView::eventFilter(QObject* object, QEvent* event) {
    if (object != canvas_) return QWidget::eventFilter(object, event);
    switch (event->type()) {
        case QEvent::Wheel: {
            const auto* const wheel = static_cast<QWheelEvent*>(event);
            zoom(std::pow(1.25, wheel->angleDelta().y() / 120.0), canvas_->toDrawing(wheel->position()).x);
            event->accept();
            return true;
        }
        case QEvent::KeyPress: {
            const auto* const key = static_cast<QKeyEvent*>(event);
            if (key->key() != Qt::Key_R || key->modifiers() != Qt::NoModifier) return false;
            resetZoom();
            return true;
        }
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            return mouse(static_cast<QMouseEvent*>(event));
        default:
            return false;
    }
}

// Returns true if the event is handled here and must not reach the canvas.
bool RowsView::mouse(QMouseEvent* event) {
    const QPointF at = event->localPos();
    if (event->type() == QEvent::MouseButtonPress) {
        pressed_ = last_ = at;
        dragging_ = false;
        return false;
    }
    if (event->type() == QEvent::MouseButtonRelease) {
        if (event->button() == Qt::LeftButton && !dragging_) choosePixel(at);
        dragging_ = false;
        return false;
    }
    if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) == 0) return false;
    const QPointF moved = at - pressed_;
    if (!dragging_ && std::hypot(moved.x(), moved.y()) <= kClickReach) return true;
    dragging_ = true;
    if (data_ && range_.to > range_.from) {
        const double by = frame_.pixelAt(canvas_->toDrawing(last_).x) - frame_.pixelAt(canvas_->toDrawing(at).x);
        setRange(range_.from + by, range_.to + by);
    }
    last_ = at;
    return true;
}

void RowsView::choosePixel(const QPointF& widget) {
    if (!data_) return;
    const RowsReading at = rowsReading(*data_, frame_, canvas_->toDrawing(widget));
    if (!at.inside) return;
    // A pixel of the widened row lies within one of the picture's.
    const double scale = static_cast<double>(snapshot_->scenario.width) / static_cast<double>(data_->place.width);
    const auto x = static_cast<int>((static_cast<double>(at.pixel) + 0.5) * scale);
    workspace_->finishInteraction();  // each click is an undo step of its own
    workspace_->choosePixel(x, data_->place.line);
}

void RowsView::readOut(const QPointF& widget) {
    if (!data_) return setReadout({});
    const RowsReading at = rowsReading(*data_, frame_, canvas_->toDrawing(widget));
    if (!at.inside) return setReadout({});
    const auto i = static_cast<std::size_t>(at.pixel - data_->row.span.begin);
    QString text = tr("pixel %1").arg(at.pixel);
    const QStringList behind = coefficientLines(
        relief::pixelCoefficients(data_->place.map, static_cast<double>(at.pixel) + 0.5, data_->place.y));
    canvas_->setToolTip(behind.join('\n'));
    const QString more = QStringLiteral(" · ") + behind.join(QStringLiteral(" · "));
    if (!at.curve) {
        canvas_->setToolTip({});
        return setReadout(text + tr(" · beyond the horizon"));
    }
    const relief::RowCurve& curve = data_->row.curves[*at.curve];
    if (std::isnan(curve.error[i])) return setReadout(text + tr(" · beyond the horizon"));
    text += QStringLiteral(" · %1 %2").arg(*at.curve + 1).arg(QString::fromStdString(data_->names[*at.curve]));
    text += tr(": u %1, v %2, error %3 texels")
                .arg(number(curve.u[i], 4), number(curve.v[i], 4),
                     QString::fromStdString(relief::numberText(curve.error[i], 3)));
    const int streams = streamsOf(curve);
    if (streams > 1) text += tr(" · stream %1 of %2").arg(curve.stream[i]).arg(streams);
    if (std::binary_search(curve.exact.begin(), curve.exact.end(), at.pixel)) text += tr(" · restart here");
    setReadout(text + more);
}

std::shared_ptr<const Figure> RowsView::figure() const {
    return data_ ? rowsFigure(snapshot_, options_, range_) : nullptr;
}

}  // namespace reliefui
