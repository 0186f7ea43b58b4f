#include "panes/doctor/doctor_view.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/doctor/doctor_drawing.h"
#include "panes/drawing_canvas.h"
#include "panes/pane_controls.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

namespace reliefui {

using relief::Message;
using relief::MessageId;

namespace {

Message failure(const std::string& why) {
    return Message(MessageId::DoctorFailed, {{"why", why}});
}

}  // namespace

DoctorView::DoctorView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Doctor"), QStringLiteral("doctor"), tr("Export the diagnosis"), parent),
      canvas_(new DrawingCanvas(this)),
      list_(new QListWidget(this)) {
    setFace(canvas_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        problem_ = problem.isEmpty() ? Message(MessageId::DoctorStopped) : failure(problem.toStdString());
        redraw();
        showBusy();
    };
    listener.progress = [this](const QString&, double fraction) {
        fraction_ = fraction;
        showBusy();
    };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    auto* const bar = new QHBoxLayout;
    run_ = addToolButton(bar, tr("diagnose"), tr("Read the files again and diagnose them, or cancel it (Esc)"));
    run_->setObjectName(QStringLiteral("doctor-run"));
    bar->addStretch(1);
    list_->setObjectName(QStringLiteral("doctor-faults"));
    list_->setAccessibleName(tr("Faults of the tracer; a click chooses the worst ray"));
    list_->setWordWrap(true);
    list_->setResizeMode(QListView::Adjust);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* const split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(canvas_);
    split->addWidget(list_);
    split->setChildrenCollapsible(false);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(split, 1);
    connect(run_, &QToolButton::clicked, this, [this] { job_->busy() ? void(cancel()) : readAgain(); });
    const auto chooseRow = [this](const QListWidgetItem* item) {
        const auto row = static_cast<std::size_t>(list_->row(item));
        if (report_ && row < report_->worst.size() && report_->worst[row]) chooseRay(*report_->worst[row]);
    };
    connect(list_, &QListWidget::itemClicked, this, chooseRow);
    connect(list_, &QListWidget::itemActivated, this, chooseRow);  // Enter
    connect(canvas_, &DrawingCanvas::pointed, this, &DoctorView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &DoctorView::redraw);
    connect(canvas_, &DrawingCanvas::clickedAt, this, [this](const QPointF& widget) {
        const auto ray = report_ ? doctorRayAt(*report_, canvas_->toDrawing(widget)) : std::nullopt;
        if (ray) chooseRay(*ray);
    });
    connect(workspace_, &Workspace::busyChanged, this, &DoctorView::noteCancelled);
    connect(workspace_, &Workspace::styleChanged, this, [this] {
        fillList();
        redraw();
    });
    showBusy();
    refresh();
}

DoctorView::~DoctorView() = default;

bool DoctorView::outdated() const {
    const auto now = workspace_->snapshot();
    return report_ && !(now && now->request && report_->subject.of(*now));
}

void DoctorView::showSnapshot() {
    const PauseLog::Part part("doctor");
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || !snapshot->request || !snapshot->scenario.other || snapshot->otherProblem) {
        forget();
        if (snapshot && snapshot->otherProblem)
            problem_ = failure(snapshot->otherProblem->text(workspace_->style().language));
        redraw();
        return showBusy();
    }
    if (report_ && report_->subject.of(*snapshot)) return redraw();
    // Another ray of the same files needs no other diagnosis.
    if (asked_ && asked_->of(*snapshot)) return redraw();
    diagnose();
}

void DoctorView::diagnose() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || !snapshot->request || !snapshot->scenario.other || !isOnScreen()) return;
    asked_ = DoctorSubject(*snapshot);
    report_.reset();
    problem_.reset();
    fillList();
    auto made = std::make_shared<std::shared_ptr<const DoctorReport>>();
    const auto work = [made, snapshot](relief::Work& w) { *made = doctorReport(*snapshot, w); };
    const auto done = [this, made] {
        report_ = *made;
        fillList();
        redraw();
        showBusy();
    };
    fraction_ = 0;
    job_->start({work, done});
    redraw();
    showBusy();
}

// The snapshot with the files' new contents starts the diagnosis.
void DoctorView::readAgain() {
    forget();
    redraw();
    showBusy();
    workspace_->renew();
}

// The reading can be cancelled as well; no snapshot comes then.
void DoctorView::noteCancelled(bool busy) {
    if (busy || report_ || asked_ || problem_ || !workspace_->scenario().other) return;
    problem_ = Message(MessageId::DoctorStopped);
    redraw();
}

void DoctorView::forget() {
    job_->drop();
    report_.reset();
    asked_.reset();
    problem_.reset();
    fillList();
}

bool DoctorView::cancel() {
    return job_->cancel();
}

void DoctorView::chooseRay(std::size_t ray) {
    if (!report_ || ray >= report_->rays.size()) return;
    relief::Scenario changed = workspace_->scenario();
    if (report_->view) {
        const auto snapshot = workspace_->snapshot();
        changed = relief::sceneOfRay(changed, snapshot->request->field, report_->rays, report_->view, ray);
    }
    changed.other.ray = static_cast<int>(ray);
    changed.other.shown = true;
    workspace_->finishInteraction();  // each click is an undo step of its own
    workspace_->change(changed, changeName([] { return tr("Choose a wrong ray"); }));
}

void DoctorView::releaseContents() {
    forget();
    canvas_->releaseContents();
    setReadout({});
}

void DoctorView::fillList() {
    list_->clear();
    list_->setVisible(report_ != nullptr);
    if (!report_) return;
    for (const Message& line : report_->lines) {
        list_->addItem(QString::fromStdString(relief::sentence(line, workspace_->style().language)));
    }
}

void DoctorView::redraw() {
    const PauseLog::Part part("doctor: drawing");
    if (markStaleIfHidden()) return;
    const Style& style = workspace_->style();
    canvas_->setStyle(style);
    const relief::OtherTracer& other = workspace_->scenario().other;
    if (!report_) {
        return canvas_->showText(problem_.value_or(Message(other ? MessageId::DoctorBusy : MessageId::DoctorNone)));
    }
    constexpr double kMostLegend = 0.4;
    const auto legend =
        canvas_->showLegend(doctorLegend(*report_, false, canvas_->legendWidth(), style.language), kMostLegend);
    const auto ray = static_cast<std::size_t>(other.ray);
    canvas_->setLayers({std::make_shared<const Drawing>(doctorPicture(*report_, ray))}, legend);
}

void DoctorView::showBusy() {
    constexpr int kHundred = 100;
    const bool busy = job_->busy();
    run_->setText(busy ? tr("cancel (%1%)").arg(static_cast<int>(kHundred * fraction_)) : tr("diagnose"));
    run_->setEnabled(static_cast<bool>(workspace_->scenario().other));
}

void DoctorView::readOut(const QPointF& widget) {
    const auto ray = report_ ? doctorRayAt(*report_, canvas_->toDrawing(widget)) : std::nullopt;
    if (!ray) return setReadout({});
    setReadout(QString::fromStdString(relief::sentence(doctorReadout(*report_, *ray), workspace_->style().language)));
}

std::shared_ptr<const Figure> DoctorView::figure() const {
    return report_ && !outdated() ? doctorFigure(report_) : nullptr;
}

}  // namespace reliefui
