// Controls of the charts pane: start or cancel measuring, measure automatically, which methods, which error, which
// charts.
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/charts/charts_view.h"
#include "panes/drawing_canvas.h"
#include "panes/narrow_bar.h"
#include "panes/pane_controls.h"

namespace reliefui {

ChartsView::ChartsView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Charts"), QStringLiteral("charts"), tr("Export the charts"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        measuring_ = false;
        uncounted_ = problem.isEmpty() ? relief::Message(relief::MessageId::DrawCompareStopped)
                                       : plainText(problem.toStdString());
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
        draw();
        showBusy();
    };
    listener.progress = [this](const QString&, double fraction) {
        fraction_ = fraction;
        showBusy();
    };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    auto* const bar = new NarrowBar(this);
    bar_ = bar->widget();
    makeBar();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(canvas_, 1);
    canvas_->installEventFilter(this);
    connect(canvas_, &DrawingCanvas::pointed, this, &ChartsView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &ChartsView::draw);
    connect(canvas_, &DrawingCanvas::clicked, this, [this] {
        const ChartsReading at = chartsReading(picture_, canvas_->toDrawing(released_));
        if (at.point) {
            choose(*at.point);
        } else if (at.bar) {
            chooseOf(*at.bar);
        }
    });
    connect(workspace_, &Workspace::panesChanged, this, &ChartsView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, &ChartsView::draw);
    adopt();
    refresh();
}

ChartsView::~ChartsView() = default;

void ChartsView::makeBar() {
    auto* const bar = qobject_cast<QHBoxLayout*>(bar_->layout());
    measureButton_ = addToolButton(
        bar, tr("measure"),
        tr("Measure run time and error of the methods on this view's rays, or cancel the measurement (Esc)"));
    measureButton_->setObjectName(QStringLiteral("charts-measure"));
    live_ = addToolButton(bar, tr("live"), tr("Measure again automatically when the view changes"), true);
    live_->setObjectName(QStringLiteral("charts-live"));
    live_->setChecked(true);
    maps_ = addToolButton(bar, tr("with maps"),
                          tr("Also measure methods with distance and cone maps, which take time to build"), true);
    maps_->setObjectName(QStringLiteral("charts-maps"));
    error_ = addChooser(bar, "charts-error", tr("Error on the vertical axis"));
    error_->addItem(tr("mean error"));
    error_->addItem(tr("95th percentile"));
    error_->addItem(tr("99.99th percentile"));
    error_->addItem(tr("largest error"));
    shown_ = addChooser(bar, "charts-shown", tr("Charts to show"));
    shown_->addItem(tr("all charts"));
    shown_->addItem(tr("time and error"));
    shown_->addItem(tr("histograms"));
    bar->addStretch(1);
    connect(measureButton_, &QToolButton::clicked, this, [this] {
        if (measuring_) {
            cancel();
        } else {
            measure();
        }
    });
    connect(live_, &QToolButton::clicked, this, &ChartsView::setLive);
    connect(maps_, &QToolButton::clicked, this, &ChartsView::setWithMaps);
    connect(error_, qOverload<int>(&QComboBox::activated), this,
            [this](int measure) { setMeasure(static_cast<relief::ErrorMeasure>(measure)); });
    connect(shown_, qOverload<int>(&QComboBox::activated), this,
            [this](int shown) { setShown(static_cast<ChartsShown>(shown)); });
}

void ChartsView::showBusy() {
    measureButton_->setText(measuring_ ? tr("cancel (%1%)").arg(static_cast<int>(100 * fraction_)) : tr("measure"));
}

}  // namespace reliefui
