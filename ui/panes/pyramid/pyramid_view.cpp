#include "panes/pyramid/pyramid_view.h"

#include <cmath>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QStackedLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/annotation_layer.h"
#include "panes/drawing_canvas.h"
#include "panes/pane_controls.h"
#include "panes/pyramid/pyramid_figure.h"
#include "panes/pyramid/pyramid_stack.h"
#include "panes/range_button.h"
#include "scenario/step_sentence.h"
#include "workspace/annotation_state.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

PyramidView::PyramidView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Pyramid"), QStringLiteral("pyramid"), tr("Export the pyramid"), parent),
      canvas_(new DrawingCanvas(this)),
      stack_(new PyramidStack(this)),
      faces_(new QStackedLayout) {
    setFace(canvas_);
    annotations_ = new AnnotationLayer(workspace, canvas_, [this]() -> std::optional<AnnotationFrame> {
        if (!levels_ || parts_.parts.empty()) return std::nullopt;
        AnnotationFrame frame = pyramidAnnotations(parts_);
        frame.seen = frame.seen.cut(canvas_->visible());
        return frame;
    });
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(makeBar());
    column->addLayout(faces_, 1);
    faces_->addWidget(canvas_);
    faces_->addWidget(stack_);
    stackLegend_ = new DrawingCanvas(this);
    stackLegend_->setFocusPolicy(Qt::NoFocus);
    stackLegend_->hide();
    column->addWidget(stackLegend_);

    connect(canvas_, &DrawingCanvas::clicked, this, &PyramidView::choose);
    connect(stackLegend_, &DrawingCanvas::clicked, this, &PyramidView::choose);
    connect(canvas_, &DrawingCanvas::pointed, this, &PyramidView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &PyramidView::refresh);
    connect(stack_, &PyramidStack::resized, this, [this] { deferredRefresh_.start(); });
    connect(stack_, &PyramidStack::clickedAt, this, &PyramidView::chooseAt);
    connect(stack_, &PyramidStack::hoveredAt, this, [this](const Point& at) { setReadout(reading(at)); });
    connect(workspace_, &Workspace::stepChanged, this, &PyramidView::refreshStep);
    connect(workspace_, &Workspace::styleChanged, this, &PyramidView::refresh);
    connect(workspace_, &Workspace::panesChanged, this, &PyramidView::adopt);
    adopt();
    refresh();
}

QHBoxLayout* PyramidView::makeBar() {
    auto* const bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 6, 2);
    maxima_ =
        addToolButton(bar, tr("max"), tr("The highest point under each texel, by which the ray skips texels"), true);
    means_ = addToolButton(bar, tr("mean"), tr("The mean under each texel, with which colours are filtered"), true);
    minima_ = addToolButton(bar, tr("min"), tr("The lowest point under each texel"), true);
    all_ = addToolButton(bar, tr("all"), tr("Show maxima, means and minima side by side"), true);
    stacked_ = addToolButton(
        bar, tr("3-D"), tr("The levels one above another, with a slab for each texel, and the path of the ray"), true);
    near_ = addToolButton(bar, tr("near the ray"), tr("Show only the surroundings of the ray, on every level"), true);
    follow_ = addToolButton(bar, tr("follow"), tr("Zoom to the level of the current step"), true);
    range_ = new RangeButton(
        workspace_, [this] { return levels_ ? std::optional(parts_.heights) : std::nullopt; }, this);
    bar->addWidget(range_);
    auto* const fit =
        addToolButton(bar, tr("fit"), tr("Show all levels (R); wheel zooms, drag moves, click chooses a step"));
    bar->addStretch(1);
    connect(maxima_, &QToolButton::clicked, this, [this] { showMeans(false); });
    connect(means_, &QToolButton::clicked, this, [this] { showMeans(true); });
    connect(minima_, &QToolButton::clicked, this, &PyramidView::showMinima);
    connect(all_, &QToolButton::clicked, this, &PyramidView::showAllKinds);
    connect(stacked_, &QToolButton::clicked, this, &PyramidView::setStacked);
    connect(near_, &QToolButton::clicked, this, &PyramidView::showNearRay);
    connect(follow_, &QToolButton::clicked, this, &PyramidView::setFollowing);
    connect(fit, &QToolButton::clicked, this, &PyramidView::resetZoom);
    return bar;
}

void PyramidView::change(const PyramidPane& pane) {
    workspace_->change(withState(workspace_->scenario(), pane), changeName([] { return tr("Pyramid: other view"); }));
    adopt();
}

void PyramidView::adopt() {
    const relief::Scenario& now = workspace_->scenario();
    const PyramidPane before = std::exchange(pane_, stateOf<PyramidPane>(now));
    const ColorRange heights = std::exchange(options_, pyramidOptions(now)).heights;
    maxima_->setChecked(pane_.levels == "max");
    means_->setChecked(pane_.levels == "mean");
    minima_->setChecked(pane_.levels == "min");
    all_->setChecked(pane_.levels == "all");
    stacked_->setChecked(pane_.stacked);
    near_->setChecked(pane_.nearRay);
    follow_->setChecked(pane_.follow);
    if (pane_ == before && options_.heights == heights) return;
    faces_->setCurrentWidget(pane_.stacked ? static_cast<QWidget*>(stack_) : canvas_);
    if (pane_.levels != before.levels) workspace_->setLevels(options_.kind);
    if (pane_.nearRay != before.nearRay || pane_.levels != before.levels) canvas_->resetZoom();
    if (before.follow && !pane_.follow) canvas_->resetZoom();
    refresh();
}

void PyramidView::showMeans(bool means) {
    set(&PyramidPane::levels, means ? "mean" : "max");
}

void PyramidView::showMinima() {
    set(&PyramidPane::levels, "min");
}

void PyramidView::showAllKinds() {
    set(&PyramidPane::levels, "all");
}

void PyramidView::setStacked(bool on) {
    set(&PyramidPane::stacked, on);
}

void PyramidView::showNearRay(bool on) {
    set(&PyramidPane::nearRay, on);
}

void PyramidView::setFollowing(bool on) {
    set(&PyramidPane::follow, on);
}

void PyramidView::resetZoom() {
    pane_.stacked ? stack_->fit() : canvas_->resetZoom();
}

void PyramidView::addToMenu(QMenu& menu) {
    if (!pane_.stacked) annotations_->addToMenu(menu);
}

void PyramidView::readOut(const QPointF& widget) {
    setReadout(reading(canvas_->toDrawing(widget)));
}

void PyramidView::showSnapshot() {
    const PauseLog::Part part("pyramid");
    canvas_->setStyle(workspace_->style());
    shown_ = workspace_->snapshot();
    if (shown_ && shown_->assets.tiles) return showEmpty(relief::MessageId::DrawTiled);
    const bool ready = shown_ && shown_->request && (options_.all || shown_->has(options_.kind));
    if (!ready) {
        showEmpty(workspace_->whyEmpty());
        return;
    }
    // The legend is laid out first; the levels get the remaining room. A legend that would take too much is shortened
    // or left out; the table of steps names the decisions as well.
    const relief::Language language = workspace_->style().language;
    const auto showLegend = [&] {
        constexpr double kMostLegend = 0.25;
        const PyramidSource source = pyramidSource(*shown_, options_);
        legend_ =
            canvas_->showLegend(pyramidLegend(source, parts_.heights, canvas_->legendWidth(), language), kMostLegend);
        if (!legend_->bounds.empty()) return;
        legend_ = canvas_->showLegend(pyramidLegend(source, parts_.heights, canvas_->legendWidth(), language, true),
                                      kMostLegend);
    };
    const QSizeF all = canvas_->room();
    parts_ = pyramidParts(*shown_, options_, all.width(), all.height(), language);
    if (parts_.parts.empty()) return showEmpty(workspace_->whyEmpty());
    showLegend();
    const QSizeF room = canvas_->room();
    parts_ = pyramidParts(*shown_, options_, room.width(), room.height(), language);
    // If there is no room for all levels, only the level of the current step is shown.
    constexpr double kSmallest = 20;  // in points
    const std::vector<LevelBlock>& blocks = parts_.parts.front().picture.blocks;
    cramped_ = parts_.parts.size() == 1 && blocks.size() > 1 && blocks.back().box.height() < kSmallest;
    if (cramped_) parts_ = pyramidParts(*shown_, options_, 3 * room.width() + 300, 3 * room.height() + 200, language);
    showLegend();  // adapted to what is visible at this size
    levels_ = std::make_shared<const Drawing>(parts_.levels);
    range_->refresh();
    faces_->setCurrentWidget(pane_.stacked ? static_cast<QWidget*>(stack_) : canvas_);
    // The slabs hold references to the parts, so they are updated as well.
    pane_.stacked ? stack_->show(parts_, workspace_->style()) : stack_->releaseContents();
    showStackLegend();
    refreshStep();
}

// A legend that would take too much of the pane is shortened or left out.
void PyramidView::showStackLegend() {
    constexpr double kMost = 0.25;
    constexpr double kLeastTower = 150;  // points; in a lower pane the slabs would be hardly recognisable
    const Style& style = workspace_->style();
    const double unit = style.pixelsPerPoint();
    bool shown = false;
    for (const bool brief : {false, true}) {
        if (shown || !pane_.stacked) break;
        const Drawing legend = pyramidLegend(pyramidSource(*shown_, options_), parts_.heights,
                                             width() / unit - 2 * kFigureMargin, style.language, brief);
        const double high = (legend.bounds.height() + kFigureMargin) * unit;
        if (high > kMost * height() || height() - high < kLeastTower * unit) continue;
        stackLegend_->setStyle(style);
        stackLegend_->setFixedHeight(static_cast<int>(std::ceil(high)));
        stackLegend_->setLayers({}, std::make_shared<const Drawing>(legend));
        shown = true;
    }
    stackLegend_->setVisible(shown);
}

void PyramidView::releaseContents() {
    shown_.reset();
    parts_ = {};
    levels_.reset();
    legend_.reset();
    canvas_->releaseContents();
    stack_->releaseContents();
    stackLegend_->releaseContents();
    setReadout({});
}

void PyramidView::refreshStep() {
    const PauseLog::Part part("pyramid: marks");
    if (markStaleIfHidden()) return;
    if (!shown_ || !levels_) return;
    if (pane_.stacked) return stack_->showStep(workspace_->scenario().step);
    // The step may belong to a newer ray whose snapshot is still to come.
    auto marks = std::make_shared<const Drawing>(partsMarks(parts_, workspace_->scenario().step));
    canvas_->setLayers({levels_, std::move(marks)}, legend_);
    if (pane_.follow || cramped_) {
        follow();
    } else if (wasCramped_) {
        canvas_->resetZoom();
    }
    wasCramped_ = cramped_;
}

void PyramidView::showEmpty(relief::MessageId why) {
    levels_.reset();
    stack_->releaseContents();
    parts_ = {};
    range_->refresh();
    canvas_->showText(why);
    faces_->setCurrentWidget(canvas_);
    stackLegend_->hide();
}

void PyramidView::follow() {
    if (!shown_ || shown_->trace.steps.empty() || parts_.parts.empty()) return;
    const auto& steps = shown_->trace.steps;
    const int last = static_cast<int>(steps.size()) - 1;
    const relief::Step& step = steps[static_cast<std::size_t>(std::clamp(workspace_->scenario().step, 0, last))];
    if (step.level < 0 || step.level >= static_cast<int>(blocks().size())) return;
    const Box box = blocks()[static_cast<std::size_t>(step.level)].box;
    canvas_->zoomTo({box.x0, box.y0 - kTitleHeight, box.x1, box.y1});
}

const relief::Step* PyramidView::stepOf(const ItemId& id) const {
    const bool step = shown_ && id.kind == ItemKind::Step;
    if (!step || id.i < 0 || id.i >= static_cast<std::int64_t>(shown_->trace.steps.size())) return nullptr;
    return &shown_->trace.steps[static_cast<std::size_t>(id.i)];
}

void PyramidView::choose(const ItemId& id) {
    if (id.kind == ItemKind::ColorBar) return range_->open();
    const relief::Step* const at = stepOf(id);
    if (at == nullptr) return;
    const auto& steps = shown_->trace.steps;
    const auto count = static_cast<std::int64_t>(steps.size());
    // If several steps concern this texel, choose the one after the current step, cyclically.
    const std::int64_t current = std::clamp<std::int64_t>(workspace_->scenario().step, 0, count - 1);
    for (std::int64_t n = 1; n <= count; ++n) {
        const std::int64_t k = (current + n) % count;
        const relief::Step& step = steps[static_cast<std::size_t>(k)];
        if (step.level == at->level && step.i == at->i && step.j == at->j && liesInVoxel(step) == liesInVoxel(*at)) {
            workspace_->chooseStep(static_cast<int>(k));
            return;
        }
    }
}

// A click on the slabs, handled like one at the corresponding place of the flat drawing.
void PyramidView::chooseAt(Point drawing) {
    if (!levels_) return;
    choose(pick(partsMarks(parts_, workspace_->scenario().step), ViewMap{}, drawing, 1, 0));
}

QString PyramidView::reading(Point drawing) const {
    const PyramidPart* const part = levels_ ? parts_.at(drawing) : nullptr;
    if (part == nullptr) return {};
    ItemId id = pick(pyramidMarks(part->source, part->picture, workspace_->scenario().step), ViewMap{}, drawing, 1, 0);
    if (stepOf(id) == nullptr) id = pick(part->picture.levels, ViewMap{}, drawing, 1, 0);
    // Tool tips of steps contain the sentence that describes them.
    QString tip;
    if (stepOf(id) != nullptr) {
        const PixelTrace& trace = shown_->trace;
        tip = QString::fromStdString(
            relief::sentence(relief::stepSentence(trace.steps, static_cast<std::size_t>(id.i), trace.ray, trace.exact),
                             workspace_->style().language));
    }
    canvas_->setToolTip(tip);
    return textOf(*part, id);
}

QString PyramidView::textOf(const PyramidPart& part, const ItemId& id) const {
    ItemId texel = id;
    if (const relief::Step* const step = stepOf(id)) {
        if (liesInVoxel(*step)) {
            return tr("step %1 · voxel (%2, %3, %4)").arg(id.i + 1).arg(step->i).arg(step->j).arg(step->k);
        }
        texel = {ItemKind::Texel, step->level, step->i, step->j};
    }
    if (texel.kind != ItemKind::Texel) return {};
    const PyramidSource& from = part.source;
    if (texel.level < 0 || texel.level >= from.pyramid->levels()) return {};
    const relief::FloatImage& level = from.pyramid->level(texel.level);
    const relief::CellGrid grid(*from.field);
    const bool named = from.overCells && texel.level == 0;
    const auto i = static_cast<int>(texel.i - (named ? grid.x.firstName : 0));
    const auto j = static_cast<int>(texel.j - (named ? grid.y.firstName : 0));
    if (i < 0 || j < 0 || i >= level.width() || j >= level.height()) return {};
    const double value = static_cast<double>(level(i, j));
    const auto number = [](double v, int decimals) { return QString::fromStdString(relief::fixedText(v, decimals)); };
    QString text = tr("level %1 (%2, %3): %4 · %5 texels")
                       .arg(texel.level)
                       .arg(texel.i)
                       .arg(texel.j)
                       .arg(number(value, 3), number(value * from.field->slabTexels(), 1));
    if (parts_.parts.size() > 1) {
        const relief::PyramidKind kind = from.pyramid->kind();
        const QString name = kind == relief::PyramidKind::Max    ? tr("max")
                             : kind == relief::PyramidKind::Mean ? tr("mean")
                                                                 : tr("min");
        text = name + QStringLiteral(" · ") + text;
    }
    if (const relief::Step* const step = stepOf(id)) {
        const auto* const descent = step->as<relief::subject::Texel>();
        if (descent != nullptr && descent->ray) {
            const relief::subject::LevelPoint at = *descent->ray;
            text += QStringLiteral(" · V(i+1) = 2 V(i) = 2 × (%1, %2) = (%3, %4)")
                        .arg(number(at.x, 3), number(at.y, 3), number(2 * at.x, 2), number(2 * at.y, 2));
        }
    }
    return id.kind == ItemKind::Step ? tr("step %1 · %2").arg(id.i + 1).arg(text) : text;
}

std::shared_ptr<const Figure> PyramidView::figure() const {
    if (!levels_) return nullptr;
    return pane_.stacked ? slabsFigure(shown_, workspace_->scenario().step, options_, stack_->camera())
                         : pyramidFigure(shown_, workspace_->scenario().step, options_,
                                         stateOf<AnnotationState>(workspace_->scenario()).list);
}

}  // namespace reliefui
