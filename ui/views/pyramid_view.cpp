#include "views/pyramid_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include "scenario/step_sentence.h"
#include "views/drawing_canvas.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

QToolButton* switchButton(const QString& text, const QString& help, QWidget* parent) {
    auto* const button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setCheckable(true);
    button->setAutoRaise(true);
    return button;
}

}  // namespace

PyramidView::PyramidView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Pyramid"), QStringLiteral("pyramid"), tr("Export the pyramid"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    maxima_ = switchButton(tr("max"), tr("The highest point under each texel: what lets the ray skip"), this);
    means_ = switchButton(tr("mean"), tr("The mean under each texel: what colours are filtered with"), this);
    minima_ = switchButton(tr("min"), tr("The lowest point under each texel"), this);
    near_ = switchButton(tr("near the ray"), tr("Show only the surroundings of the ray, on every level"), this);
    near_->setChecked(true);
    follow_ = switchButton(tr("follow"), tr("Zoom to the level of the current step"), this);
    auto* const all =
        switchButton(tr("fit"), tr("Show all levels (R); wheel zooms, drag moves, click chooses a step"), this);
    all->setCheckable(false);
    auto* const kinds = new QButtonGroup(this);
    kinds->addButton(maxima_);
    kinds->addButton(means_);
    kinds->addButton(minima_);
    maxima_->setChecked(true);

    auto* const bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 6, 2);
    bar->addWidget(maxima_);
    bar->addWidget(means_);
    bar->addWidget(minima_);
    bar->addWidget(near_);
    bar->addWidget(follow_);
    bar->addWidget(all);
    bar->addStretch(1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(canvas_, 1);

    connect(kinds, qOverload<QAbstractButton*, bool>(&QButtonGroup::buttonToggled), this,
            [this](QAbstractButton*, bool on) {
                if (!on) return;
                workspace_->setLevels(levels());
                refresh();
            });
    connect(near_, &QToolButton::toggled, this, [this] {
        canvas_->resetZoom();
        refresh();
    });
    connect(follow_, &QToolButton::toggled, this, &PyramidView::setFollowing);
    connect(all, &QToolButton::clicked, canvas_, &DrawingCanvas::resetZoom);
    connect(canvas_, &DrawingCanvas::clicked, this, &PyramidView::choose);
    connect(canvas_, &DrawingCanvas::hovered, this, &PyramidView::tellItem);
    connect(canvas_, &DrawingCanvas::resized, this, &PyramidView::refresh);
    connect(workspace_, &Workspace::snapshotChanged, this, &PyramidView::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &PyramidView::refreshStep);
    connect(workspace_, &Workspace::styleChanged, this, &PyramidView::refresh);
    refresh();
}

void PyramidView::showMeans(bool means) {
    (means ? means_ : maxima_)->setChecked(true);
}

void PyramidView::showMinima() {
    minima_->setChecked(true);
}

void PyramidView::showNearRay(bool on) {
    near_->setChecked(on);
}

void PyramidView::setFollowing(bool on) {
    follow_->setChecked(on);
    on ? follow() : canvas_->resetZoom();
}

void PyramidView::resetZoom() {
    canvas_->resetZoom();
}

relief::PyramidKind PyramidView::levels() const {
    return maxima_->isChecked()  ? relief::PyramidKind::Max
           : means_->isChecked() ? relief::PyramidKind::Mean
                                 : relief::PyramidKind::Min;
}

PyramidOptions PyramidView::options() const {
    return {levels(), near_->isChecked()};
}

PyramidSource PyramidView::source() const {
    return pyramidSource(*shown_, options());
}

void PyramidView::fillFigure(FigureRequest& request) const {
    request.pyramid = options();
}

void PyramidView::tell(const QPointF& widget) {
    tellItem(canvas_->itemAt(widget));
}

void PyramidView::refresh() {
    const PauseLog::Part part("pyramid");
    canvas_->setStyle(workspace_->style());
    shown_ = workspace_->snapshot();
    const bool ready = shown_ && shown_->request && shown_->has(levels());
    if (!ready) {
        showEmpty(relief::MessageId::DrawNoPicture);
        return;
    }
    const PyramidSource from = source();
    // The legend first: what it needs is not left to the levels. Where it would take too much it is left
    // out: the table of steps tells the decisions, too.
    constexpr double kMostLegend = 0.25;
    const double unit = workspace_->style().pixelsPerPoint();
    Drawing legend = pyramidLegend(from, canvas_->width() / unit - 12, workspace_->style().language);
    if (legend.bounds.height() * unit > kMostLegend * canvas_->height()) legend = {};
    legend_ = std::make_shared<const Drawing>(std::move(legend));
    canvas_->setLayers({}, legend_);
    const QSizeF room = canvas_->room();
    picture_ = pyramidPicture(from, room.width(), room.height());
    // Where there is no room for all levels, the one of the current step is shown.
    constexpr double kSmallest = 20;  // points
    cramped_ = picture_.blocks.size() > 1 && picture_.blocks.back().box.height() < kSmallest;
    if (cramped_) picture_ = pyramidPicture(from, 3 * room.width() + 300, 3 * room.height() + 200);
    levels_ = std::make_shared<const Drawing>(std::move(picture_.levels));
    refreshStep();
}

void PyramidView::refreshStep() {
    const PauseLog::Part part("pyramid: marks");
    if (!shown_ || !levels_) return;
    // A step of a newer ray than the one shown: its snapshot is on the way.
    auto marks = std::make_shared<const Drawing>(pyramidMarks(source(), picture_, workspace_->scenario().step));
    canvas_->setLayers({levels_, std::move(marks)}, legend_);
    if (follow_->isChecked() || cramped_) {
        follow();
    } else if (wasCramped_) {
        canvas_->resetZoom();
    }
    wasCramped_ = cramped_;
}

void PyramidView::showEmpty(relief::MessageId why) {
    levels_.reset();
    picture_ = {};
    canvas_->showText(why);
}

void PyramidView::follow() {
    if (!shown_ || shown_->trace.steps.empty()) return;
    const auto& steps = shown_->trace.steps;
    const int last = static_cast<int>(steps.size()) - 1;
    const relief::Step& step = steps[static_cast<std::size_t>(std::clamp(workspace_->scenario().step, 0, last))];
    if (step.level < 0 || step.level >= static_cast<int>(picture_.blocks.size())) return;
    const Box box = picture_.blocks[static_cast<std::size_t>(step.level)].box;
    canvas_->zoomTo({box.x0, box.y0 - kTitleHeight, box.x1, box.y1});
}

void PyramidView::choose(const ItemId& id) {
    if (!shown_ || id.kind != ItemKind::Step) return;
    const auto& steps = shown_->trace.steps;
    const auto count = static_cast<std::int64_t>(steps.size());
    if (id.i >= count) return;
    const relief::Step& at = steps[static_cast<std::size_t>(id.i)];
    // Of all steps on this texel, the next one after the current, round and round.
    const std::int64_t current = std::clamp<std::int64_t>(workspace_->scenario().step, 0, count - 1);
    for (std::int64_t n = 1; n <= count; ++n) {
        const std::int64_t k = (current + n) % count;
        const relief::Step& step = steps[static_cast<std::size_t>(k)];
        if (step.level == at.level && step.i == at.i && step.j == at.j) {
            workspace_->chooseStep(static_cast<int>(k));
            return;
        }
    }
}

void PyramidView::tellItem(const ItemId& id) {
    ItemId texel = id;
    if (shown_ && id.kind == ItemKind::Step && id.i < static_cast<std::int64_t>(shown_->trace.steps.size())) {
        const relief::Step& step = shown_->trace.steps[static_cast<std::size_t>(id.i)];
        texel = {ItemKind::Texel, step.level, step.i, step.j};
    }
    if (!shown_ || texel.kind != ItemKind::Texel) {
        setReadout({});
        return;
    }
    const PyramidSource from = source();
    const relief::FloatImage& level = from.pyramid->level(texel.level);
    const relief::CellGrid grid(*from.field);
    const bool named = from.overCells && texel.level == 0;
    const auto i = static_cast<int>(texel.i - (named ? grid.x.firstName : 0));
    const auto j = static_cast<int>(texel.j - (named ? grid.y.firstName : 0));
    if (i < 0 || j < 0 || i >= level.width() || j >= level.height()) return;
    const double value = static_cast<double>(level(i, j));
    const auto number = [](double v, int decimals) { return QString::fromStdString(relief::fixedText(v, decimals)); };
    QString text = tr("level %1 (%2, %3): %4 · %5 texels")
                       .arg(texel.level)
                       .arg(texel.i)
                       .arg(texel.j)
                       .arg(number(value, 3), number(value * from.field->slabTexels(), 1));
    if (id.kind == ItemKind::Step) text = tr("step %1 · %2").arg(id.i + 1).arg(text);
    setReadout(text);
}

}  // namespace reliefui
