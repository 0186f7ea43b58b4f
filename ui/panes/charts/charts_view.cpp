#include "panes/charts/charts_view.h"

#include <QComboBox>
#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>

#include "panes/charts/charts_figure.h"
#include "panes/drawing_canvas.h"
#include "panes/figure_caption.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

QString number(double value) {
    return QString::fromStdString(relief::numberText(value, 3));
}

}  // namespace

bool ChartsView::isUpToDate() const {
    return !stale() && !job_->busy();
}

bool ChartsView::outdated() const {
    return snapshot_ && !(workspace_->snapshot() && workspace_->snapshot()->frame == snapshot_->frame);
}

void ChartsView::showSnapshot() {
    const PauseLog::Part part("charts");
    const std::shared_ptr<const Snapshot> snapshot = workspace_->snapshot();
    if (snapshot && snapshot->coarse) {
        // Nothing is measured during a drag, which needs all processors; the full picture at its end starts measuring
        // again.
        job_->drop();
        measuring_ = false;
        return showBusy();
    }
    snapshot_ = snapshot;
    if (!snapshot || !snapshot->request || !snapshot->frame) return showEmpty();
    uncounted_ = relief::Message(relief::MessageId::DrawComparePending);
    draw();
    if (counted()) return startMeasuring();
    measuring_ = false;
    auto made = std::make_shared<std::shared_ptr<const relief::FrameHistograms>>();
    const auto work = [made, snapshot](relief::Work& w) { *made = histogramsOf(*snapshot, w); };
    const auto done = [this, made, snapshot] {
        histograms_ = *made;
        counted_ = snapshot->frame;
        draw();
        startMeasuring();
    };
    job_->start({work, done});
    showBusy();
}

// Measurements took seconds and need little memory, so they are kept while they match the relief and view that are
// open.
void ChartsView::releaseContents() {
    job_->drop();
    measuring_ = false;
    measuredNow_.reset();
    snapshot_.reset();
    counted_.reset();
    histograms_.reset();
    const std::shared_ptr<const Snapshot> now = workspace_->snapshot();
    if (measured_ && !(now && now->request && measured_->of(*now))) measured_.reset();
    picture_ = {};
    canvas_->releaseContents();
    setReadout({});
}

// Starts measuring if it is enabled and the results are missing.
void ChartsView::startMeasuring() {
    const relief::MethodChoice& method = snapshot_->request->method;
    const bool tracer = relief::findTracer(method.name).kind == relief::MethodKind::Tracer;
    const bool all = !maps_->isChecked() || (measured_ && measured_->withMaps);
    const bool there = measured_ && all && measured_->of(*snapshot_) && (!tracer || measured_->has(method));
    // Choosing another pixel does not restart a measurement in progress.
    const bool underway = measuring_ && sameMeasurement(*measuredNow_, *snapshot_);
    if (there || underway || !live_->isChecked()) return showBusy();
    measure();
}

void ChartsView::measure() {
    if (!snapshot_ || !snapshot_->frame || !isOnScreen()) return;
    auto made = std::make_shared<MeasuredView>();
    const auto work = [made, snapshot = snapshot_, maps = maps_->isChecked()](relief::Work& w) {
        *made = measureView(*snapshot, maps, w);
    };
    const auto done = [this, made] {
        measured_ = made;
        measuring_ = false;
        if (!counted()) return refresh();  // the measurement has interrupted the counting
        draw();
        showBusy();
    };
    measuring_ = true;
    measuredNow_ = snapshot_;
    fraction_ = 0;
    job_->start({work, done});
    draw();
    showBusy();
}

bool ChartsView::cancel() {
    if (!job_->busy()) return false;
    setLive(false);  // otherwise it would start again at once
    return job_->cancel();
}

void ChartsView::change(const ChartsPane& pane) {
    workspace_->change(withState(workspace_->scenario(), pane), changeName([] { return tr("Charts: other view"); }));
    adopt();
}

void ChartsView::adopt() {
    const ChartsPane before = std::exchange(pane_, stateOf<ChartsPane>(workspace_->scenario()));
    const std::vector<std::string>& names = chartsPaneShown();
    const auto shown = std::find(names.begin(), names.end(), pane_.shown) - names.begin();
    shown_->setCurrentIndex(static_cast<int>(shown));
    error_->setCurrentIndex(static_cast<int>(relief::parseErrorMeasure(pane_.error, "error")));
    live_->setChecked(pane_.live);
    maps_->setChecked(pane_.maps);
    if (pane_.shown != before.shown) canvas_->resetZoom();
    if (pane_.shown != before.shown || pane_.error != before.error) draw();
    if (pane_.maps != before.maps) measuring_ = false;  // the measurement in progress is no longer the one needed
    if (pane_.maps != before.maps || (pane_.live && !before.live)) refresh();
}

void ChartsView::setLive(bool on) {
    set(&ChartsPane::live, on);
}

void ChartsView::setWithMaps(bool on) {
    set(&ChartsPane::maps, on);
}

void ChartsView::setShown(ChartsShown shown) {
    set(&ChartsPane::shown, chartsPaneShown()[static_cast<std::size_t>(shown)]);
}

void ChartsView::setMeasure(relief::ErrorMeasure measure) {
    set(&ChartsPane::error, std::string(relief::kErrorMeasureNames[static_cast<std::size_t>(measure)]));
}

ChartsSource ChartsView::source() const {
    ChartsSource source;
    source.shown = static_cast<ChartsShown>(std::max(shown_->currentIndex(), 0));
    source.uncounted = uncounted_;
    if (!snapshot_) return source;
    if (counted()) source.histograms = histograms_;
    source.chosenSteps = chosenSteps(*snapshot_);
    const auto measure = static_cast<relief::ErrorMeasure>(std::max(error_->currentIndex(), 0));
    if (measured_) source.pareto = paretoSource(*snapshot_, *measured_, measure);
    source.missing = measuring_ ? relief::MessageId::DrawChartMeasuring : relief::MessageId::DrawChartPress;
    return source;
}

void ChartsView::draw() {
    const PauseLog::Part part("charts: drawing");
    if (!snapshot_ || !snapshot_->request) return;
    if (markStaleIfHidden()) return;
    const Style& style = workspace_->style();
    canvas_->setStyle(style);
    const ChartsSource now = source();
    // The legend is laid out first and the charts get the remaining room. A legend that would take too much is left
    // out.
    constexpr double kMostLegend = 0.3;
    const auto legend = canvas_->showLegend(chartsLegend(now, canvas_->legendWidth(), style.language), kMostLegend);
    const QSizeF room = canvas_->room();
    picture_ = chartsPicture(now, room.width(), room.height(), style.language);
    canvas_->setLayers({std::make_shared<const Drawing>(picture_.drawing)}, legend);
}

void ChartsView::showEmpty() {
    job_->drop();
    measuring_ = false;
    picture_ = {};
    canvas_->showText(workspace_->whyEmpty());
    setReadout({});
    showBusy();
}

bool ChartsView::eventFilter(QObject* object, QEvent* event) {
    if (object == canvas_ && event->type() == QEvent::MouseButtonRelease) {
        released_ = static_cast<QMouseEvent*>(event)->localPos();
    }
    return QWidget::eventFilter(object, event);
}

void ChartsView::choose(std::size_t point) {
    if (!snapshot_ || !measured_ || point >= measured_->table.points.size()) return;
    const relief::MethodChoice method = measured_->table.points[point].method;
    auto worst = std::make_shared<std::optional<relief::PixelPlace>>();
    const auto work = [worst, method, snapshot = snapshot_](relief::Work& w) {
        *worst = relief::worstPixel(*snapshot->frame, *snapshot->request, method, *snapshot->maps, w);
    };
    const auto done = [this, worst, method] {
        relief::Scenario changed = workspace_->scenario();
        changed.method = method;
        if (*worst) changed.pixel = relief::PixelChoice{(*worst)->x, (*worst)->y};
        workspace_->change(changed, changeName([] { return tr("Choose method and its worst pixel"); }));
        refresh();  // restarts the measurement that was interrupted for this
    };
    measuring_ = false;
    job_->start({work, done});
    showBusy();
}

void ChartsView::chooseOf(const HistogramBar& bar) {
    if (!counted() || bar.rays == 0) return;
    auto pixels = std::make_shared<std::vector<relief::PixelPlace>>();
    const relief::HistogramBin bin{static_cast<relief::HistogramPart>(bar.kind), bar.bin};
    const auto work = [pixels, bin, data = histograms_, snapshot = snapshot_](relief::Work& w) {
        *pixels = relief::pixelsOfBin(*snapshot->frame, *snapshot->request, *snapshot->tracer, *data, bin,
                                      *snapshot->maps, w);
    };
    const auto done = [this, pixels] {
        const std::optional<relief::PixelChoice> now = workspace_->scenario().pixel;
        const auto at = std::find_if(pixels->begin(), pixels->end(),
                                     [&](const auto& p) { return now && p.x == now->x && p.y == now->y; });
        // The next pixel of this bar, if one of its pixels is already chosen.
        const auto next = at == pixels->end() || at + 1 == pixels->end() ? pixels->begin() : at + 1;
        if (next != pixels->end()) {
            workspace_->finishInteraction();  // each click is an undo step of its own
            workspace_->choosePixel(next->x, next->y);
        }
        refresh();  // restarts the measurement that was interrupted for this
    };
    measuring_ = false;
    job_->start({work, done});
    showBusy();
}

// Always states the speed together with the error.
QString ChartsView::textOf(const relief::ParetoPoint& point) const {
    QString text =
        tr("%1: %2 ns per ray ± %3%, error %4 mean, %5 at most, %6 steps")
            .arg(QString::fromStdString(point.label(true)), number(point.nanoseconds), number(50 * point.spread),
                 number(point.error[0]), number(point.error[3]), number(point.steps));
    if (point.wrongOutcome > 0) text += tr(" · wrong outcome: %n rays", nullptr, static_cast<int>(point.wrongOutcome));
    return text;
}

// The bar's range and count, and the hint that it can be clicked.
QString ChartsView::textOf(const HistogramBar& bar) const {
    return bar.rays > 0 ? tr("%1 · click to choose such a pixel").arg(rangeOf(bar)) : rangeOf(bar);
}

QString ChartsView::rangeOf(const HistogramBar& bar) {
    const auto rays = static_cast<int>(bar.rays);
    switch (bar.kind) {
        case BarKind::Exact:
            return tr("exact: %n rays", nullptr, rays);
        case BarKind::Wrong:
            return tr("wrong outcome: %n rays", nullptr, rays);
        case BarKind::Steps:
            if (bar.high - bar.low <= 1) {
                return tr("%1: %n rays", nullptr, rays).arg(tr("%n steps", nullptr, static_cast<int>(bar.low)));
            }
            return tr("%1 to %2 steps: %n rays", nullptr, rays).arg(number(bar.low), number(bar.high - 1));
        case BarKind::Before:
            return tr("%1 to %2 texels before the surface: %n rays", nullptr, rays)
                .arg(number(bar.low), number(bar.high));
        case BarKind::Behind:
            return tr("%1 to %2 texels behind it: %n rays", nullptr, rays).arg(number(bar.low), number(bar.high));
    }
    return {};
}

void ChartsView::readOut(const QPointF& widget) {
    const ChartsReading at = chartsReading(picture_, canvas_->toDrawing(widget));
    if (at.point && measured_ && *at.point < measured_->table.points.size()) {
        return setReadout(textOf(measured_->table.points[*at.point]));
    }
    setReadout(at.bar ? textOf(*at.bar) : QString());
}

std::shared_ptr<const Figure> ChartsView::figure() const {
    const ChartsShown shown = source().shown;
    if (!snapshot_ || (shown == ChartsShown::Pareto && !measured_)) return nullptr;
    if (shown != ChartsShown::Pareto && !counted()) return nullptr;
    return chartsFigure(std::make_shared<const ChartsSource>(source()), figureCaption(snapshot_));
}

}  // namespace reliefui
