#include "panes/distance/distance_view.h"

#include <algorithm>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "panes/annotation_layer.h"
#include "panes/core_texts.h"
#include "panes/distance/distance_figure.h"
#include "panes/drawing_canvas.h"
#include "panes/range_button.h"
#include "relief/tracers/map_choice.h"
#include "workspace/annotation_state.h"
#include "workspace/change_name.h"
#include "workspace/discard.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"
#include "workspace/range_json.h"

namespace reliefui {

void DistanceView::setOptions(const DistanceOptions& options) {
    change(options);
}

// drag: merge key of a drag, which is one step of undo; null: none.
void DistanceView::change(const DistanceOptions& options, const char* drag) {
    if (options == options_) return;
    workspace_->change(withState(workspace_->scenario(), paneOf(options)),
                       changeName([] { return tr("Distance map: other view"); }), QString::fromLatin1(drag));
    showControls();  // resets the controls if the change was refused
}

void DistanceView::adopt() {
    const relief::Scenario& now = workspace_->scenario();
    const DistanceOptions options = distanceOptions(stateOf<DistancePane>(now), rangesOf(now));
    const std::optional<QueryPoint> query = stateOf<PointState>(now).point;
    if (options == options_ && query == query_) return;
    query_ = query;
    const bool other = options.kind != options_.kind || options.minus != options_.minus ||
                       options.axis != options_.axis || options.nearRay != options_.nearRay;
    if (options != options_) failed_ = {};
    options_ = options;
    if (other) canvas_->resetZoom();
    refresh();
}

bool DistanceView::ready() const {
    return snapshot_ && snapshot_->request && snapshot_->maxima && snapshot_->maps;
}

bool DistanceView::isUpToDate() const {
    return !stale() && !job_->busy() && !point_.busy();
}

DistanceView::MapNames DistanceView::namesNow() const {
    const relief::HeightField& field = snapshot_->request->field;
    MapNames now;
    now.heights = field.sharedHeights();
    now.names = {std::string(relief::surfaceName(field.surface())), std::string(relief::addressName(field.address())),
                 relief::numberText(field.reliefDepth())};
    for (const MapOptions& map : mapOptions(options_, *snapshot_)) {
        now.names.push_back(map.kind);
        for (const auto& [name, text] : map.options) now.names.push_back(name + "=" + text);
    }
    return now;
}

void DistanceView::showSnapshot() {
    const PauseLog::Part part("distance");
    canvas_->setStyle(workspace_->style());
    snapshot_ = workspace_->snapshot();
    if (!ready()) {
        showEmpty(workspace_->whyEmpty());
        return;
    }
    if (snapshot_->assets.tiles) {
        job_->drop();
        building_ = {};
        return showEmpty(relief::MessageId::DrawTiled);
    }
    point_.ask(snapshot_, query_);
    const MapNames now = namesNow();
    if (now == built_) {
        building_ = {};
        draw();
    } else if (now == failed_) {
        showControls();
    } else if (!(now == building_) && !snapshot_->coarse) {
        // Not during a drag, in which the map would soon be outdated.
        build(now);
    }
}

// The maps themselves stay in the cache, within its memory budget.
void DistanceView::releaseContents() {
    job_->drop();
    point_.drop();
    snapshot_.reset();
    discard(std::exchange(maps_, {}));
    built_ = building_ = failed_ = {};
    problem_.clear();
    drawing_.reset();
    legend_.reset();
    result_.reset();
    canvas_->releaseContents();
    setReadout({});
    showWaiting();
}

void DistanceView::refreshStep() {
    if (markStaleIfHidden()) return;
    if (!options_.slice) {
        refresh();
    } else {
        showMarks();
    }
}

void DistanceView::build(const MapNames& names) {
    problem_.clear();
    failed_ = {};
    building_ = names;
    auto maps = std::make_shared<DistanceMaps>();
    const auto work = [snapshot = snapshot_, options = options_, before = maps_, maps](relief::Work& w) {
        *maps = distanceMaps(*snapshot, options, before, w);
    };
    const auto done = [this, maps, names] {
        discard(std::exchange(maps_, std::move(*maps)));
        built_ = names;
        building_ = {};
        refresh();
    };
    job_->start({work, done});
    showWaiting();
}

// Computes slice and legend in the background. Sizes are in points, without the canvas's margins.
void DistanceView::draw() {
    constexpr double kMargin = 6;
    constexpr double kOneRow = 14;
    constexpr double kMostLegend = 0.25;
    const double unit = workspace_->style().pixelsPerPoint();
    const QSizeF room(canvas_->width() / unit - 2 * kMargin, canvas_->height() / unit - 2 * kMargin);
    const int step = workspace_->scenario().step;
    const relief::Language language = workspace_->style().language;
    problem_.clear();
    auto result = makeFreedInBackground<Result>();
    result->snapshot = snapshot_;
    result->maps = maps_;
    result->point = point_.known();
    const auto work = [result, options = options_, room, step, language](relief::Work&) {
        const DistanceSource source = result->source();
        if (source.second != nullptr) result->secondSector = sectorOf(*source.second, source, options);
        // A second pass is needed if the legend turns out higher than one row.
        double legend = kOneRow + kMargin / 2;
        for (int n = 0; n < 2; ++n) {
            result->picture = distancePicture(source, options, step, room.width(), room.height() - legend, language);
            result->legend = distanceLegend(source, result->picture, room.width(), language);
            const auto high = [&] { return result->legend.bounds.height() > kMostLegend * room.height(); };
            if (high()) result->legend = distanceLegend(source, result->picture, room.width(), language, true);
            if (high()) result->legend = rangeLegend(result->picture.values, room.width(), true);
            if (high()) result->legend = {};
            const bool none = result->legend.bounds.empty();
            const double needed = none ? 0 : result->legend.bounds.height() + kMargin / 2;
            if (needed == legend) break;
            legend = needed;
        }
    };
    job_->start({work, [this, result] { take(result); }});
    showWaiting();
}

DistanceSource DistanceView::Result::source() const {
    DistanceSource source = distanceSource(*snapshot, maps);
    source.point = point;
    return source;
}

void DistanceView::take(std::shared_ptr<const Result> result) {
    result_ = std::move(result);
    drawing_ = {result_, &result_->picture.drawing};
    legend_ = {result_, &result_->legend};
    showMarks();
    showControls();
}

void DistanceView::showMarks() {
    const PauseLog::Part part("distance: marks");
    if (!result_) return;
    const DistanceSource source = result_->source();
    auto marks =
        std::make_shared<const Drawing>(distanceMarks(source, result_->picture.frame, workspace_->scenario().step));
    canvas_->setLayers({drawing_, std::move(marks)}, legend_);
}

void DistanceView::showEmpty(relief::MessageId why) {
    result_.reset();
    canvas_->showText(why);
    showControls();
}

void DistanceView::fail(const QString& problem) {
    problem_ = problem.isEmpty() ? tr("Building the map was cancelled.") : problem;
    // The snapshot may have gone in the meantime.
    failed_ = ready() ? namesNow() : MapNames{};
    building_ = {};
    // The drawing on the screen is not the requested one, so it is removed.
    result_.reset();
    canvas_->setLayers({}, nullptr);
    showControls();
}

void DistanceView::addToMenu(QMenu& menu) {
    annotations_->addToMenu(menu);
}

bool DistanceView::cancel() {
    return job_->cancel();
}

// Sets the controls to what is shown.
void DistanceView::showControls() {
    const QSignalBlocker quietSlider(slider_);
    const QSignalBlocker quietSector(sector_);
    follow_->setChecked(!options_.slice);
    iso_->setChecked(options_.isoLines);
    near_->setChecked(options_.nearRay);
    range_->refresh();
    kind_->setCurrentIndex(std::max(0, kind_->findData(QString::fromStdString(options_.kind))));
    minus_->setCurrentIndex(std::max(0, minus_->findData(QString::fromStdString(options_.minus))));
    const DistanceFrame frame = result_ ? result_->picture.frame : DistanceFrame{};
    for (std::size_t a = 0; a < axes_.size(); ++a) {
        axes_[a]->setChecked(result_ && static_cast<std::size_t>(frame.axis) == a);
        axes_[a]->setEnabled(!frame.slopes);
    }
    slider_->setRange(0, std::max(0, frame.slices - 1));
    slider_->setValue(frame.slice);
    slider_->setEnabled(frame.slices > 1);
    slice_->setText(result_ && frame.slices > 1 ? tr("%1 of %2").arg(frame.slice + 1).arg(frame.slices) : QString());
    sector_->setVisible(frame.sectors > 1);
    if (frame.sectors > 1 && sector_->count() != frame.sectors + 1) {
        sector_->clear();
        sector_->addItem(tr("the ray's sector"), -1);
        for (int q = 0; q < frame.sectors; ++q) sector_->addItem(tr("sector %1").arg(q + 1), q);
    }
    if (frame.sectors > 1) sector_->setCurrentIndex(options_.sector ? *options_.sector + 1 : 0);
    showWaiting();
}

void DistanceView::showWaiting() {
    const bool busy = job_ && job_->busy() && !building_.names.empty();
    if (busy && !busyDelay_.isActive() && !waiting_->isVisible()) busyDelay_.start();
    if (!busy) busyDelay_.stop();
    const bool problem = !problem_.isEmpty();
    if (!busy || problem) waiting_->setVisible(problem);
    if (problem) what_->setText(problem_);
    bar_->setVisible(!problem);
    stop_->setVisible(!problem);
    retry_->setVisible(problem);
    placeWaiting();
}

std::shared_ptr<const Figure> DistanceView::figure() const {
    if (!result_) return nullptr;
    return distanceFigure(result_->snapshot, workspace_->scenario().step, options_,
                          stateOf<PointState>(workspace_->scenario()).point,
                          stateOf<AnnotationState>(workspace_->scenario()).list);
}

}  // namespace reliefui
