#include "panes/why/why_view.h"

#include <QVBoxLayout>

#include "panes/formula/formula_view.h"
#include "panes/why/why_figure.h"
#include "workspace/pause_log.h"

namespace reliefui {

WhyView::WhyView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Why this colour"), QStringLiteral("why"), tr("Export the pixel's history"), parent),
      face_(new FormulaFace(this)) {
    setFace(face_);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(face_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (problem.isEmpty()) return showEmpty(relief::MessageId::DrawCompareStopped);
        showEmpty(plainText(problem.toStdString()));
        Q_EMIT workspace_->problem(problem);
    };
    listener.progress = [](const QString&, double) {};
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    connect(face_, &FormulaFace::pointed, this, &WhyView::readOut);
    connect(face_, &FormulaFace::left, this, [this] { setReadout({}); });
    connect(workspace_, &Workspace::styleChanged, this, &WhyView::refresh);
    refresh();
}

WhyView::~WhyView() = default;

void WhyView::showSnapshot() {
    const PauseLog::Part part("why");
    const auto snapshot = workspace_->snapshot();
    // Not during a drag, in which the picture is soon another one.
    if (snapshot && snapshot->coarse) return;
    if (!snapshot || !snapshot->request) return showEmpty(workspace_->whyEmpty());
    if (!snapshot->scenario.pixel) return showEmpty(relief::MessageId::DrawNoRay);
    // The history tells where the ray hits.
    if (workspace_->guessing()) return showEmpty(relief::MessageId::DrawHidden);
    if (snapshot == shown_ && history_) return draw();
    if (!history_) face_->setGroups({}, relief::MessageId::WhyComputing, workspace_->style());
    auto history = std::make_shared<relief::PixelHistory>();
    const auto work = [history, snapshot](relief::Work& own) {
        const relief::PixelChoice pixel = *snapshot->scenario.pixel;
        *history = relief::pixelHistory(*snapshot->request, pixel.x, pixel.y, snapshot->maps, own);
    };
    const auto done = [this, history, snapshot] {
        shown_ = snapshot;
        history_ = history;
        draw();
    };
    job_->start({work, done});
}

void WhyView::draw() {
    if (markStaleIfHidden()) return;
    const Style& style = workspace_->style();
    face_->setGroups(whyGroups(*history_, *shown_->request, style.language), relief::MessageId::WhyComputing, style);
}

void WhyView::showEmpty(relief::Message why) {
    job_->drop();
    history_.reset();
    shown_.reset();
    face_->setGroups({}, std::move(why), workspace_->style());
    setReadout({});
}

void WhyView::releaseContents() {
    showEmpty(relief::MessageId::DrawNoPicture);
}

void WhyView::readOut(const QPointF& at) {
    setReadout(face_->rowAt(at));
}

std::shared_ptr<const Figure> WhyView::figure() const {
    return history_ ? whyFigure(shown_, history_) : nullptr;
}

}  // namespace reliefui
