// Controls of the distance pane, and its reaction to the pointer.
#include <algorithm>
#include <cmath>

#include <QButtonGroup>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/annotation_layer.h"
#include "panes/core_texts.h"
#include "panes/distance/distance_figure.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/narrow_bar.h"
#include "panes/pane_controls.h"
#include "panes/range_button.h"
#include "relief/tracers/map_choice.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

constexpr int kBusyDelayMs = 250;

QString number(double value, int decimals) {
    return QString::fromStdString(relief::fixedText(value, decimals));
}

}  // namespace

DistanceView::DistanceView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Distance map"), QStringLiteral("distance"), tr("Export the distance map"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    annotations_ = new AnnotationLayer(workspace, canvas_, [this]() -> std::optional<AnnotationFrame> {
        if (!result_) return std::nullopt;
        AnnotationFrame frame = distanceAnnotations(result_->picture.frame);
        frame.seen = frame.seen.cut(canvas_->visible());
        return frame;
    });
    auto* const maps = new NarrowBar(this);
    auto* const slices = new NarrowBar(this);
    makeMapBar(maps->row());
    makeSliceBar(slices->row());
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(maps);
    column->addWidget(slices);
    column->addWidget(canvas_, 1);
    makeWaiting();
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) { fail(problem); };
    listener.progress = [this](const QString& what, double fraction) {
        what_->setText(coreText(what.toStdString()));
        bar_->setValue(static_cast<int>(fraction * 1000));
    };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    connect(canvas_, &DrawingCanvas::clicked, this, &DistanceView::choose);
    connect(canvas_, &DrawingCanvas::pointQueried, this, &DistanceView::askPoint);
    connect(canvas_, &DrawingCanvas::pointed, this, &DistanceView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &DistanceView::refresh);
    connect(workspace_, &Workspace::panesChanged, this, &DistanceView::adopt);
    connect(workspace_, &Workspace::stepChanged, this, &DistanceView::refreshStep);
    connect(workspace_, &Workspace::styleChanged, this, &DistanceView::refresh);
    adopt();
    refresh();
}

DistanceView::~DistanceView() {
    busyDelay_.stop();
}

void DistanceView::makeMapBar(QHBoxLayout* bar) {
    bar->setContentsMargins(4, 2, 6, 0);
    kind_ = addChooser(bar, "distance-kind", tr("Map to show"));
    minus_ = addChooser(bar, "distance-minus", tr("Map to subtract, which shows where the two differ"));
    sector_ = addChooser(bar, "distance-sector", tr("Azimuth sector of the rays for which the values are valid"));
    sector_->hide();
    kind_->addItem(tr("the method's map"), QString());
    minus_->addItem(tr("no difference"), QString());
    for (const std::string& kind : relief::mapKinds()) {
        const QString name = QString::fromStdString(kind);
        kind_->addItem(name, name);
        minus_->addItem(QStringLiteral("− ") + name, name);
    }
    iso_ = addToolButton(bar, tr("lines"), tr("Lines of equal value"), true);
    near_ = addToolButton(bar, tr("near the ray"), tr("Show only the surroundings of the ray"), true);
    range_ = new RangeButton(
        workspace_, [this] { return result_ ? std::optional(result_->picture.values) : std::nullopt; }, this);
    bar->addWidget(range_);
    auto* const fit = addToolButton(bar, tr("fit"),
                                    tr("Show all of the slice (R); wheel zooms, drag moves, click chooses a step, "
                                       "Ctrl+click shows the distances at a point"));
    connect(kind_, qOverload<int>(&QComboBox::activated), this, [this] {
        DistanceOptions next = options_;
        next.kind = kind_->currentData().toString().toStdString();
        next.sector.reset();
        change(next);
    });
    connect(minus_, qOverload<int>(&QComboBox::activated), this, [this] {
        DistanceOptions next = options_;
        next.minus = minus_->currentData().toString().toStdString();
        change(next);
    });
    connect(sector_, qOverload<int>(&QComboBox::activated), this, [this] {
        DistanceOptions next = options_;
        const int sector = sector_->currentData().toInt();
        next.sector = sector < 0 ? std::nullopt : std::optional<int>(sector);
        change(next);
    });
    connect(iso_, &QToolButton::clicked, this, [this](bool on) {
        DistanceOptions next = options_;
        next.isoLines = on;
        change(next);
    });
    connect(near_, &QToolButton::clicked, this, [this](bool on) {
        DistanceOptions next = options_;
        next.nearRay = on;
        change(next);
    });
    connect(fit, &QToolButton::clicked, canvas_, &DrawingCanvas::resetZoom);
}

void DistanceView::makeSliceBar(QHBoxLayout* bar) {
    bar->setContentsMargins(4, 0, 6, 2);
    const QString names[3] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    const QString helps[3] = {tr("Slices at constant x, seen along the rows"),
                              tr("Slices at constant y, seen along the columns"),
                              tr("Slices at constant height, seen from above")};
    for (std::size_t a = 0; a < 3; ++a) {
        axes_.push_back(addToolButton(bar, names[a], helps[a], true));
        axes_.back()->setObjectName(QStringLiteral("distance-axis-") + names[a]);
        connect(axes_.back(), &QToolButton::clicked, this, [this, a] {
            DistanceOptions next = options_;
            next.axis = static_cast<SliceAxis>(a);
            next.slice.reset();  // an index along the other axis is meaningless here
            change(next);
            showControls();
        });
    }
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("distance-slice"));
    slider_->setAccessibleName(tr("Slice"));
    slider_->setToolTip(tr("Slice to show"));
    slice_ = new QLabel(this);
    bar->addWidget(slider_, 1);
    bar->addWidget(slice_);
    follow_ = addToolButton(bar, tr("at the step"), tr("The slice goes through the current step of the ray"), true);
    follow_->setObjectName(QStringLiteral("distance-follow"));
    connect(slider_, &QSlider::valueChanged, this, [this](int slice) {
        DistanceOptions next = options_;
        if (!next.axis && result_) next.axis = result_->picture.frame.axis;
        next.slice = slice;
        change(next, "distance-slice");
    });
    connect(follow_, &QToolButton::clicked, this, [this](bool on) {
        DistanceOptions next = options_;
        if (on) {
            next.slice.reset();
        } else if (result_) {
            next.axis = result_->picture.frame.axis;
            next.slice = result_->picture.frame.slice;
        }
        change(next);
    });
}

// Placed over the canvas, because a row of its own would change the size of the drawing.
void DistanceView::makeWaiting() {
    waiting_ = new QFrame(this);
    waiting_->setObjectName(QStringLiteral("distance-waiting"));
    waiting_->setFrameShape(QFrame::StyledPanel);
    waiting_->setAutoFillBackground(true);
    what_ = new QLabel(waiting_);
    what_->setWordWrap(true);
    what_->setTextFormat(Qt::PlainText);
    bar_ = new QProgressBar(waiting_);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress of the map"));
    stop_ = new QToolButton(waiting_);
    stop_->setText(tr("Cancel"));
    stop_->setToolTip(tr("Stop building the map (Esc)"));
    retry_ = new QToolButton(waiting_);
    retry_->setText(tr("Build"));
    retry_->setToolTip(tr("Build the map"));
    auto* const row = new QHBoxLayout(waiting_);
    row->addWidget(what_, 1);
    row->addWidget(bar_, 1);
    row->addWidget(stop_);
    row->addWidget(retry_);
    waiting_->hide();
    busyDelay_.setSingleShot(true);
    busyDelay_.setInterval(kBusyDelayMs);
    connect(&busyDelay_, &QTimer::timeout, this, [this] {
        waiting_->show();
        placeWaiting();
    });
    connect(stop_, &QToolButton::clicked, this, &DistanceView::cancel);
    connect(retry_, &QToolButton::clicked, this, [this] {
        failed_ = {};
        problem_.clear();
        refresh();
    });
}

void DistanceView::placeWaiting() {
    constexpr double kPart = 0.8;
    constexpr int kMostWidth = 520;
    const int width = std::min(static_cast<int>(canvas_->width() * kPart), kMostWidth);
    const int height = std::max(waiting_->heightForWidth(width), waiting_->sizeHint().height());
    const QRect room = canvas_->geometry();
    waiting_->setGeometry(room.center().x() - width / 2, room.center().y() - height / 2, width, height);
    waiting_->raise();
}

void DistanceView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeWaiting();
}

void DistanceView::resetZoom() {
    canvas_->resetZoom();
}

void DistanceView::choose(const ItemId& id) {
    if (!result_) return;
    if (id.kind == ItemKind::ColorBar) return range_->open();
    const auto count = static_cast<std::int64_t>(result_->snapshot->trace.steps.size());
    if (id.kind == ItemKind::Step && id.i < count) workspace_->chooseStep(static_cast<int>(id.i));
    if (id.kind == ItemKind::Hit && count > 0) workspace_->chooseStep(static_cast<int>(count - 1));
}

void DistanceView::readOut(const QPointF& widget) {
    if (!result_) return setReadout({});
    const DistanceSource source = distanceSource(*result_->snapshot, result_->maps);
    const DistanceFrame& frame = result_->picture.frame;
    const DistanceReading at = distanceReading(source, frame, result_->secondSector, canvas_->toDrawing(widget));
    if (!at.inside) return setReadout({});
    if (!at.onMap) return setReadout(tr("beyond the edge"));
    const QString unit = frame.slopes ? tr("height per texel") : tr("texels");
    const auto value = [&](float v) {
        if (v == relief::StoredValues::kBuried) return tr("in the relief");
        if (v < 0) return tr("at the surface: the cell is tested");
        return QStringLiteral("%1 %2").arg(number(static_cast<double>(v), frame.slopes ? 4 : 2), unit);
    };
    QString text = frame.slopes ? tr("texel (%1, %2): ").arg(at.bx).arg(at.by)
                                : tr("voxel (%1, %2, %3): ").arg(at.bx).arg(at.by).arg(at.layer);
    text += value(at.first);
    if (source.second != nullptr) text += QStringLiteral(" − ") + value(at.second);
    text += tr(" · x %1, y %2").arg(number(at.place[0], 2), number(at.place[1], 2));
    if (!frame.slopes && frame.slab > 0) text += tr(" · height %1").arg(number(at.place[2] / frame.slab, 3));
    const ItemId id = canvas_->itemAt(widget);
    if (id.kind == ItemKind::Step) text += tr(" · step %1").arg(id.i + 1);
    setReadout(text);
}

std::optional<QueryPoint> DistanceView::pointAt(const QPointF& widget) const {
    if (!result_) return std::nullopt;
    const DistanceFrame& frame = result_->picture.frame;
    const Point at = canvas_->toDrawing(widget);
    // In a cone map, points under the pointer have no height.
    if (frame.slopes || frame.slab <= 0 || !frame.plot.contains(at)) return std::nullopt;
    const Place3 place = fromSlice(frame.axis, frame.slab, frame.plane, frame.uvAt(at));
    const QueryPoint point{place[0], place[1], std::clamp(place[2] / frame.slab, 0.0, 1.0)};
    return overPicture(result_->snapshot->request->field, point) ? std::optional(point) : std::nullopt;
}

std::optional<QPointF> DistanceView::pointPlace() const {
    if (!result_ || result_->point == nullptr) return std::nullopt;
    const PointQuery& point = *result_->point;
    const auto plane = pointPlane(point, result_->snapshot->request->field, result_->picture.frame);
    const auto at = pointMarkAt(plane, point);
    return at ? std::optional(canvas_->toWidget(*at)) : std::nullopt;
}

}  // namespace reliefui
