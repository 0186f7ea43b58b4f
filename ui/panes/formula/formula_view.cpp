#include "panes/formula/formula_view.h"

#include <algorithm>
#include <utility>

#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

#include "painting/painter.h"
#include "painting/paragraph.h"
#include "panes/formula/formula_figure.h"
#include "workspace/pause_log.h"

namespace reliefui {

FormulaFace::FormulaFace(QWidget* parent) : QAbstractScrollArea(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setMouseTracking(true);
    // An opaque viewport would hide the pane, which would then never get the paint event that marks it as visible.
    viewport()->setAutoFillBackground(false);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &FormulaFace::readAgain);
}

double FormulaFace::margin() const {
    return kFigureMargin * style_.pixelsPerPoint();
}

void FormulaFace::setGroups(std::vector<FormulaGroup> groups, relief::Message missing, const Style& style) {
    groups_ = std::move(groups);
    missing_ = std::move(missing);
    style_ = style;
    layOut();
    readAgain();
}

void FormulaFace::readAgain() {
    if (pointer_) Q_EMIT pointed(*pointer_);
}

// The width always allows for the scroll bar, because its appearance must not change the height that it depends on.
void FormulaFace::layOut() {
    const double unit = style_.pixelsPerPoint();
    const int bar = verticalScrollBar()->sizeHint().width();
    const double width = std::max((this->width() - bar - 2 * margin()) / unit, 1.0);
    sheet_ = groups_.empty() ? FormulaSheet() : formulaSheet(groups_, width);
    const auto high = static_cast<int>(std::ceil(sheet_.drawing.bounds.height() * unit + 2 * margin()));
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setSingleStep(static_cast<int>(14 * unit));
    verticalScrollBar()->setRange(0, groups_.empty() ? 0 : std::max(0, high - viewport()->height()));
    viewport()->update();
}

void FormulaFace::paintEvent(QPaintEvent*) {
    const DrawingTime time("pane");
    const double ratio = devicePixelRatioF();
    Style style = style_;
    style.screenPixelsPerPoint *= ratio;
    const reliefui::Box screen{0, 0, viewport()->width() * ratio, viewport()->height() * ratio};
    QPainter painter(viewport());
    painter.scale(1 / ratio, 1 / ratio);
    if (groups_.empty()) {
        Drawing words;
        words.bounds = {0, 0, std::max(1.0, viewport()->width() / style_.pixelsPerPoint() - 2 * kFigureMargin), 1};
        addParagraph(words, words.bounds.center(), missing_, words.bounds.width(), style_.language);
        return paintFigure(painter, {&words}, {}, screen, style);
    }
    painter.fillRect(QRectF(0, 0, screen.x1, screen.y1), toColor(style.background()));
    const ViewMap map{style.pixelsPerPoint(), margin() * ratio, (margin() - verticalScrollBar()->value()) * ratio};
    reliefui::paint(painter, sheet_.drawing, map, style, screen);
}

void FormulaFace::resizeEvent(QResizeEvent* event) {
    QAbstractScrollArea::resizeEvent(event);
    layOut();
}

void FormulaFace::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->localPos();
    Q_EMIT pointed(event->localPos());
}

bool FormulaFace::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        pointer_.reset();
        Q_EMIT left();
    }
    return QAbstractScrollArea::viewportEvent(event);
}

QString FormulaFace::rowAt(const QPointF& at) const {
    const double unit = style_.pixelsPerPoint();
    const Point point{(at.x() - margin()) / unit, (at.y() - margin() + verticalScrollBar()->value()) / unit};
    for (const FormulaSheet::Place& place : sheet_.places) {
        if (place.box.contains(point)) return QString::fromStdString(place.words);
    }
    return {};
}

FormulaView::FormulaView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Formulas"), QStringLiteral("formula"), tr("Export the formulas"), parent),
      face_(new FormulaFace(this)) {
    setFace(face_);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(face_);
    connect(face_, &FormulaFace::pointed, this, &FormulaView::readOut);
    connect(face_, &FormulaFace::left, this, [this] { setReadout({}); });
    connect(workspace_, &Workspace::stepChanged, this, &FormulaView::refresh);
    connect(workspace_, &Workspace::texelChanged, this, &FormulaView::refresh);
    connect(workspace_, &Workspace::styleChanged, this, &FormulaView::refresh);
    refresh();
}

void FormulaView::showSnapshot() {
    const PauseLog::Part part("formulas");
    const auto shown = workspace_->snapshot();
    // In a coarse picture the pixel differs; the numbers follow with the full picture.
    if (shown && shown->coarse) return;
    const Style& style = workspace_->style();
    if (!shown) return face_->setGroups({}, relief::MessageId::DrawNoPicture, style);
    face_->setGroups(formulas(*shown, workspace_->scenario().step, style.language, workspace_->texel()),
                     formulasMissing(*shown), style);
}

void FormulaView::releaseContents() {
    face_->setGroups({}, relief::MessageId::DrawNoPicture, workspace_->style());
    setReadout({});
}

void FormulaView::readOut(const QPointF& at) {
    setReadout(face_->rowAt(at));
}

std::shared_ptr<const Figure> FormulaView::figure() const {
    const auto shown = workspace_->snapshot();
    return shown && !shown->coarse && shown->trace.onRelief ? formulaFigure(shown, workspace_->scenario().step)
                                                            : nullptr;
}

}  // namespace reliefui
