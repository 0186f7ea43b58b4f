#include "panes/profile/profile_view.h"

#include <limits>

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/annotation_layer.h"
#include "panes/drawing_canvas.h"
#include "panes/pane_controls.h"
#include "panes/profile/profile_figure.h"
#include "panes/ray_geometry.h"
#include "scenario/step_sentence.h"
#include "workspace/annotation_state.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

QString number(double value, int decimals) {
    return QString::fromStdString(relief::fixedText(value, decimals));
}

}  // namespace

ProfileView::ProfileView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Profile"), QStringLiteral("profile"), tr("Export the profile"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    annotations_ = new AnnotationLayer(workspace, canvas_, [this]() -> std::optional<AnnotationFrame> {
        return ready() && relief_ ? std::optional(profileAnnotations(frame_)) : std::nullopt;
    });
    makeBar();
    connect(canvas_, &DrawingCanvas::clicked, this, &ProfileView::choose);
    connect(canvas_, &DrawingCanvas::clickedAt, this, [this](const QPointF& at) {
        if (options_.guessing && ready()) guessAt(frame_.lambdaAt(canvas_->toDrawing(at).x));
    });
    connect(workspace_, &Workspace::guessingChanged, this, &ProfileView::showGuessing);
    connect(canvas_, &DrawingCanvas::pointQueried, this, &ProfileView::askPoint);
    connect(canvas_, &DrawingCanvas::pointed, this, &ProfileView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &ProfileView::refresh);
    connect(canvas_, &DrawingCanvas::moved, this, &ProfileView::redraw);
    connect(workspace_, &Workspace::panesChanged, this, &ProfileView::adopt);
    connect(workspace_, &Workspace::stepChanged, this, &ProfileView::refreshStep);
    connect(workspace_, &Workspace::styleChanged, this, &ProfileView::refresh);
    takeProfile(options_, pane_);
    options_.guessing = workspace_->guessing();
    adopt();
    refresh();
}

void ProfileView::makeBar() {
    auto* const bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 6, 2);
    allLevels_ = addToolButton(bar, tr("all levels"),
                               tr("Show the maxima of all levels, not only of those that the ray visited"), true);
    near_ = addToolButton(bar, tr("near the ray"), tr("Show only the heights that the ray passes"), true);
    aspect_ = addToolButton(bar, tr("true aspect"),
                            tr("Use one scale across and upwards, which shows the relief's true shape"), true);
    guess_ = addToolButton(bar, tr("guess"), tr("Hide the answer until a click guesses where the ray hits (G)"), true);
    guess_->setObjectName(QStringLiteral("guess"));
    guess_->setChecked(workspace_->guessing());
    auto* const fit = addToolButton(bar, tr("fit"),
                                    tr("Show all of the ray (R); wheel zooms, drag moves, click chooses a step, "
                                       "Ctrl+click shows the distances at a point"));
    bar->addStretch(1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(canvas_, 1);

    connect(guess_, &QToolButton::toggled, workspace_, &Workspace::setGuessing);
    connect(allLevels_, &QToolButton::clicked, this, &ProfileView::showAllLevels);
    connect(near_, &QToolButton::clicked, this, &ProfileView::showNearRay);
    connect(aspect_, &QToolButton::clicked, this, &ProfileView::setTrueAspect);
    connect(fit, &QToolButton::clicked, canvas_, &DrawingCanvas::resetZoom);
}

void ProfileView::change(const ProfilePane& pane) {
    workspace_->change(withState(workspace_->scenario(), pane), changeName([] { return tr("Profile: other view"); }));
    adopt();
}

void ProfileView::adopt() {
    const auto pane = stateOf<ProfilePane>(workspace_->scenario());
    allLevels_->setChecked(pane.allLevels);
    near_->setChecked(pane.nearRay);
    aspect_->setChecked(pane.trueAspect);
    const std::optional<QueryPoint> query = stateOf<PointState>(workspace_->scenario()).point;
    if (pane == pane_ && query == query_) return;
    pane_ = pane;
    query_ = query;
    takeProfile(options_, pane);
    refresh();
}

void ProfileView::showAllLevels(bool all) {
    set(&ProfilePane::allLevels, all);
}

void ProfileView::showNearRay(bool on) {
    set(&ProfilePane::nearRay, on);
}

void ProfileView::setTrueAspect(bool on) {
    set(&ProfilePane::trueAspect, on);
}

void ProfileView::resetZoom() {
    canvas_->resetZoom();
}

bool ProfileView::ready() const {
    return shown_ && shown_->request && shown_->maxima && shown_->trace.onRelief;
}

ProfileSource ProfileView::source() const {
    ProfileSource source = profileSource(*shown_);
    source.point = point_.known();
    return source;
}

void ProfileView::showSnapshot() {
    const PauseLog::Part part("profile");
    canvas_->setStyle(workspace_->style());
    shown_ = workspace_->snapshot();
    // A guess applies to one ray only.
    if (options_.guess && shown_ && shown_->version != guessed_) options_.guess.reset();
    if (!ready()) {
        showEmpty(!shown_ ? workspace_->whyEmpty()
                          : (shown_->scenario.pixel ? relief::MessageId::DrawNoRelief : relief::MessageId::DrawNoRay));
        return;
    }
    point_.ask(shown_, query_);
    const ProfileSource from = source();
    // The legend is laid out first; the plot gets the remaining room. If the legend would take too much, it is
    // shortened.
    constexpr double kMostLegend = 0.25;
    const relief::Language language = workspace_->style().language;
    for (const bool brief : {false, true}) {
        legend_ =
            canvas_->showLegend(profileLegend(from, options_, canvas_->legendWidth(), language, brief), kMostLegend);
        if (!legend_->bounds.empty()) break;
    }
    const QSizeF room = canvas_->room();
    frame_ = profileFrame(from, options_, room.width(), room.height());
    // An empty layer that tells the canvas the drawing's bounds.
    auto bounds = std::make_shared<Drawing>();
    bounds->bounds = frame_.whole;
    canvas_->setLayers({std::move(bounds)}, legend_);
    redraw();
}

void ProfileView::releaseContents() {
    point_.drop();
    shown_.reset();
    relief_.reset();
    axes_.reset();
    legend_.reset();
    canvas_->releaseContents();
    setReadout({});
}

void ProfileView::redraw() {
    const PauseLog::Part part("profile: relief");
    if (!ready() || !isOnScreen()) return;
    frame_.visible = canvas_->atHome() ? frame_.whole : canvas_->visible();
    frame_.zoom = canvas_->atHome() ? 1 : canvas_->zoom();
    const ProfileSource from = source();
    relief_ = std::make_shared<const Drawing>(profileRelief(from, options_, frame_));
    axes_ = std::make_shared<const Drawing>(profileAxes(from, frame_));
    refreshStep();
}

void ProfileView::refreshStep() {
    const PauseLog::Part part("profile: marks");
    if (markStaleIfHidden()) return;
    if (!ready() || !relief_) return;
    auto marks = std::make_shared<const Drawing>(profileMarks(source(), options_, frame_, workspace_->scenario().step));
    canvas_->setLayers({relief_, axes_, std::move(marks)}, legend_);
}

void ProfileView::showGuessing(bool on) {
    guess_->setChecked(on);
    options_.guessing = on;
    if (on) options_.guess.reset();
    canvas_->resetZoom();
    refresh();
}

void ProfileView::guessAt(double lambda) {
    options_.guess = std::clamp(lambda, 0.0, frame_.lambdaEnd);
    guessed_ = workspace_->version();
    workspace_->setGuessing(false);
    // Show the answer: the last step. A pane that is hidden has dropped its snapshot, and with it the number of steps.
    workspace_->chooseStep(std::numeric_limits<int>::max());
}

void ProfileView::showEmpty(relief::MessageId why) {
    relief_.reset();
    axes_.reset();
    canvas_->showText(why);
}

void ProfileView::addToMenu(QMenu& menu) {
    annotations_->addToMenu(menu);
}

void ProfileView::choose(const ItemId& id) {
    if (!ready()) return;
    const auto& steps = shown_->trace.steps;
    const auto count = static_cast<std::int64_t>(steps.size());
    if (id.kind == ItemKind::Step && id.i < count) workspace_->chooseStep(static_cast<int>(id.i));
    if (id.kind == ItemKind::Hit && count > 0) workspace_->chooseStep(static_cast<int>(count - 1));
    if (id.kind != ItemKind::Texel) return;
    // If several steps concern this texel, choose the one after the current step, cyclically.
    const std::int64_t current =
        std::clamp<std::int64_t>(workspace_->scenario().step, 0, std::max<std::int64_t>(count - 1, 0));
    for (std::int64_t n = 1; n <= count; ++n) {
        const std::int64_t k = (current + n) % count;
        const relief::Step& step = steps[static_cast<std::size_t>(k)];
        if (step.level == id.level && step.i == id.i && step.j == id.j) {
            workspace_->chooseStep(static_cast<int>(k));
            return;
        }
    }
}

void ProfileView::readOut(const QPointF& widget) {
    if (!ready() || !relief_) return setReadout({});
    const ProfileReading at = profileReading(source(), frame_, canvas_->toDrawing(widget));
    if (!at.inside) return setReadout({});
    QString text = frame_.vertical ? tr("λ %1").arg(number(at.lambda, 3))
                                   : tr("%1 texels, λ %2").arg(number(at.across, 2), number(at.lambda, 3));
    text += at.onRelief ? tr(" · surface %1").arg(number(at.surface, 3)) : tr(" · beyond the edge");
    text += tr(" · ray %1 · texel (%2, %3)").arg(number(at.rayHeight, 3)).arg(at.i).arg(at.j);
    ItemId id = canvas_->itemAt(widget);
    const int step = id.kind == ItemKind::Step ? static_cast<int>(id.i) : at.step;
    if (step >= 0) {
        text += tr(" · step %1").arg(step + 1);
        // Columns of another program's file, as they stand there.
        for (const relief::FurtherColumn& column : shown_->trace.further) {
            const std::string& cell = column.cells[static_cast<std::size_t>(step)];
            if (!cell.empty()) text += QString::fromStdString(" · " + column.name + " " + cell);
        }
    }
    setReadout(text);
}

std::optional<QueryPoint> ProfileView::pointAt(const QPointF& widget) const {
    if (!ready() || frame_.vertical) return std::nullopt;
    const relief::HeightField& field = shown_->request->field;
    const Point at = canvas_->toDrawing(widget);
    const double height = frame_.heightAt(at.y);
    // The plot includes some room above the slab, where there are no points.
    if (!frame_.plot.contains(at) || height > 1 || field.slabTexels() <= 0) return std::nullopt;
    const Point texel = RayPath(field, shown_->trace.ray).at(frame_.lambdaAt(at.x));
    const QueryPoint point{texel.x, texel.y, std::max(height, 0.0)};
    return overPicture(field, point) ? std::optional(point) : std::nullopt;
}

std::optional<QPointF> ProfileView::pointPlace() const {
    if (!ready() || point() == nullptr) return std::nullopt;
    const ProfileSource shown = source();
    const auto plane = pointPlane(*point(), shown, frame_);
    const auto at = plane ? pointMarkAt(*plane, *point()) : std::nullopt;
    return at ? std::optional(canvas_->toWidget(*at)) : std::nullopt;
}

std::shared_ptr<const Figure> ProfileView::figure() const {
    if (!ready()) return nullptr;
    const relief::Scenario& now = workspace_->scenario();
    return profileFigure(shown_, now.step, options_, stateOf<PointState>(now).point,
                         stateOf<AnnotationState>(now).list);
}

}  // namespace reliefui
