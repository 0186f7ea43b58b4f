#include "panes/footprint/footprint_view.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/annotation_layer.h"
#include "panes/coefficient_text.h"
#include "panes/drawing_canvas.h"
#include "panes/footprint/footprint_figure.h"
#include "panes/footprint/footprint_state.h"
#include "panes/footprint/weight_drawing.h"
#include "panes/pane_controls.h"
#include "scenario/step_sentence.h"
#include "workspace/annotation_state.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

// Largest share of the pane's height for the legend.
constexpr double kMostLegend = 0.4;
// Texture beyond the bounds, enough for zooming out by a factor of two and moving a little.
constexpr double kBeyond = 1.5;

QString number(double value, int decimals) {
    return QString::fromStdString(relief::fixedText(value, decimals));
}

}  // namespace

FootprintView::FootprintView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Footprint"), QStringLiteral("footprint"), tr("Export the footprint"), parent),
      canvas_(new DrawingCanvas(this)),
      weights_(new DrawingCanvas(this)) {
    setFace(canvas_);
    annotations_ = new AnnotationLayer(workspace, canvas_, [this]() -> std::optional<AnnotationFrame> {
        if (!footprint_ || !texture_) return std::nullopt;
        return footprintAnnotations(*footprint_, canvas_->visible(), canvas_->zoom());
    });
    weights_->setAccessibleName(tr("Weight function and map of weights"));
    weights_->hide();
    auto* const bar = new QHBoxLayout;
    makeBar(bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    both_ = new QBoxLayout(QBoxLayout::LeftToRight);
    both_->setSpacing(0);
    both_->addWidget(canvas_, 3);
    both_->addWidget(weights_, 2);
    column->addLayout(both_, 1);
    connect(weights_, &DrawingCanvas::resized, this, &FootprintView::drawWeights);
    connect(canvas_, &DrawingCanvas::pointed, this, &FootprintView::readOut);
    connect(weights_, &DrawingCanvas::hovered, this, [this](const ItemId& id) {
        const bool texel = footprint_ && id.kind == ItemKind::Texel;
        point(texel ? std::optional(static_cast<std::size_t>(id.i)) : std::nullopt);
        setReadout(texel ? describe(footprint_->log.texels[*chosen_]) : QString());
    });
    for (DrawingCanvas* const canvas : {canvas_, weights_}) {
        connect(canvas, &DrawingCanvas::left, this, [this] {
            setReadout({});
            point({});
        });
    }
    connect(canvas_, &DrawingCanvas::resized, this, &FootprintView::refresh);
    connect(canvas_, &DrawingCanvas::moved, this, &FootprintView::redraw);
    connect(workspace_, &Workspace::panesChanged, this, &FootprintView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, &FootprintView::refresh);
    adopt();
    refresh();
}

void FootprintView::makeBar(QHBoxLayout* bar) {
    bar->setContentsMargins(4, 2, 6, 2);
    neighbours_ =
        addChooser(bar, "footprint-neighbours", tr("Show the ellipses of neighbouring pixels and how they overlap"));
    neighbours_->setAccessibleName(tr("Neighbours"));
    neighbours_->addItem(tr("this pixel alone"), 0);
    neighbours_->addItem(tr("and 4 neighbours"), 4);
    neighbours_->addItem(tr("and 8 neighbours"), 8);
    weigh_ = addToolButton(bar, tr("weights"),
                           tr("Show the weight function and the weight map, if the pane has room for them"), true);
    weigh_->setObjectName(QStringLiteral("footprint-weights"));
    connect(weigh_, &QToolButton::clicked, this, [this](bool on) {
        FootprintOptions next = options_;
        next.weights = on;
        setOptions(next);
    });
    bar->addStretch(1);
    auto* const fit = addToolButton(bar, tr("fit"), tr("Show all of the footprint (R); wheel zooms, drag moves"));
    connect(fit, &QToolButton::clicked, canvas_, &DrawingCanvas::resetZoom);
    connect(neighbours_, qOverload<int>(&QComboBox::activated), this, [this] {
        FootprintOptions next = options_;
        next.neighbours = neighbours_->currentData().toInt();
        setOptions(next);
    });
}

void FootprintView::setOptions(const FootprintOptions& options) {
    if (options == options_) return;
    const bool neighbours = options.neighbours != options_.neighbours;
    workspace_->change(
        withState(workspace_->scenario(), FootprintPane{options.neighbours, options.weights}),
        changeName([neighbours] { return neighbours ? tr("Footprint: neighbours") : tr("Footprint: weights"); }));
}

void FootprintView::adopt() {
    const FootprintPane state = stateOf<FootprintPane>(workspace_->scenario());
    FootprintOptions options = options_;
    options.neighbours = state.neighbours;
    options.weights = state.weights;
    weigh_->setChecked(options.weights);
    if (options == options_) return;
    options_ = options;
    neighbours_->setCurrentIndex(neighbours_->findData(options.neighbours));
    refresh();
}

void FootprintView::resetZoom() {
    canvas_->resetZoom();
}

void FootprintView::showSnapshot() {
    const PauseLog::Part part("footprint");
    canvas_->setStyle(workspace_->style());
    shown_ = workspace_->snapshot();
    const std::shared_ptr<const PixelFootprint> before = footprint_;
    footprint_ = shown_ ? shown_->footprint : nullptr;
    if (footprint_ != before) {
        chosen_.reset();
        workspace_->pointAtTexel({});
    }
    makeRoom();
    if (!footprint_) {
        using relief::MessageId;
        const bool hit = shown_ && shown_->trace.onRelief;
        if (hit && shown_->trace.hidden) return showEmpty(MessageId::DrawHidden);
        if (hit && shown_->request && FilteredPicture::tooLarge(*shown_->request)) {
            showEmpty(MessageId::DrawFootprintTooLarge);
            return;
        }
        showEmpty(!shown_                   ? workspace_->whyEmpty()
                  : !shown_->scenario.pixel ? MessageId::DrawFootprintNoPixel
                                            : (hit ? MessageId::DrawFootprintNoHit : MessageId::DrawNoRelief));
        return;
    }
    // The legend is laid out first; the texture gets the remaining room.
    legend_ = canvas_->showLegend(
        footprintLegend(*footprint_, options_, true, canvas_->legendWidth(), workspace_->style().language),
        kMostLegend);
    const QSizeF room = canvas_->room();
    const double aspect = room.height() > 0 ? room.width() / room.height() : 1;
    texture_ = std::make_shared<const Drawing>(footprintTexture(*footprint_, aspect, kBeyond));
    canvas_->setLayers({texture_}, legend_);
    // The footprint lies elsewhere in the texture, so the zoom is reset.
    const bool elsewhere =
        !before || before->level() != footprint_->level() || before->centre() != footprint_->centre();
    if (elsewhere && !canvas_->atHome()) canvas_->resetZoom();
    redraw();
}

void FootprintView::makeRoom() {
    constexpr double kWide = 470, kHigh = 150;        // smallest size of the pane, in points, for both side by side
    constexpr double kNarrow = 230, kVeryHigh = 420;  // smallest size for one below the other
    const double unit = workspace_->style().pixelsPerPoint();
    const double wide = width() / unit, high = height() / unit;
    const bool beside = wide >= kWide && high >= kHigh;
    const bool below = !beside && wide >= kNarrow && high >= kVeryHigh;
    weights_->setStyle(workspace_->style());
    both_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    weights_->setVisible(options_.weights && (beside || below) && footprint_ && hasWeights(*footprint_));
    drawWeights();
}

void FootprintView::drawWeights() {
    if (!footprint_ || !hasWeights(*footprint_) || weights_->isHidden()) {
        plots_.reset();
        return weights_->releaseContents();
    }
    const double unit = workspace_->style().pixelsPerPoint();
    const Drawing legend =
        weightLegend(*footprint_, weights_->width() / unit - kFigureMargins, workspace_->style().language);
    weights_->setLayers({}, std::make_shared<const Drawing>(legend));
    plotsLegend_ = std::make_shared<const Drawing>(legend);
    const QSizeF room = weights_->room();
    plots_ = std::make_shared<const Drawing>(weightDrawing(*footprint_, {0, 0, room.width(), room.height()}));
    showWeights();
}

void FootprintView::showWeights() {
    if (!plots_ || weights_->isHidden()) return;
    std::vector<std::shared_ptr<const Drawing>> layers{plots_};
    if (chosen_) {
        layers.push_back(std::make_shared<const Drawing>(weightHighlight(*footprint_, plots_->bounds, *chosen_)));
    }
    weights_->setLayers(std::move(layers), plotsLegend_);
}

void FootprintView::point(std::optional<std::size_t> texel) {
    if (texel == chosen_) return;
    chosen_ = texel;
    redraw();
    showWeights();
    workspace_->pointAtTexel(texel);
}

void FootprintView::releaseContents() {
    point({});
    weights_->releaseContents();
    plots_.reset();
    plotsLegend_.reset();
    shown_.reset();
    footprint_.reset();
    texture_.reset();
    marks_.reset();
    legend_.reset();
    canvas_->releaseContents();
    setReadout({});
}

void FootprintView::redraw() {
    const PauseLog::Part part("footprint: marks");
    if (!footprint_ || !texture_ || !isOnScreen()) return;
    FootprintMarks marks = footprintMarks(*footprint_, options_, canvas_->visible(), canvas_->zoom(), chosen_);
    marks_ = std::make_shared<const Drawing>(std::move(marks.drawing));
    const bool legend = legend_ && !legend_->bounds.empty();
    if (legend && !marks.weights) {
        // Has one mark less and one hint more, so the height is the same.
        Drawing other =
            footprintLegend(*footprint_, options_, false, canvas_->legendWidth(), workspace_->style().language);
        canvas_->setLayers({texture_, marks_}, std::make_shared<const Drawing>(std::move(other)));
    } else {
        canvas_->setLayers({texture_, marks_}, legend_);
    }
}

void FootprintView::showEmpty(relief::MessageId why) {
    texture_.reset();
    marks_.reset();
    canvas_->showText(why);
}

void FootprintView::addToMenu(QMenu& menu) {
    annotations_->addToMenu(menu);
}

void FootprintView::readOut(const QPointF& widget) {
    if (!footprint_) return setReadout({});
    const PixelFootprint& f = *footprint_;
    const QStringList behind = coefficientLines(f.behind);
    const QString more = QStringLiteral(" · ") + behind.join(QStringLiteral(" · "));
    point(footprintTexelAt(f, canvas_->toDrawing(widget)));
    // Not over the footprint, which the tip would cover.
    canvas_->setToolTip(chosen_ ? QString() : behind.join('\n'));
    const ItemId id = canvas_->itemAt(widget);
    if (!chosen_) {
        setReadout(id.kind == ItemKind::Texel
                       ? tr("level %1, texel (%2, %3): is not counted").arg(id.level).arg(id.i).arg(id.j) + more
                       : QString());
        return;
    }
    QString text = describe(f.log.texels[*chosen_]);
    constexpr double kNear = 4;  // in points
    const RayHit* const ray = footprintRayAt(f, canvas_->toDrawing(widget), kNear / canvas_->zoom());
    if (ray != nullptr) text += tr(" · ray: %1% of the pixel").arg(number(100 * ray->share, 2));
    setReadout(text + more);
}

QString FootprintView::describe(const relief::FootprintTexel& texel) const {
    const PixelFootprint& f = *footprint_;
    QString text = tr("level %1, texel (%2, %3)").arg(texel.level).arg(texel.i).arg(texel.j);
    const double weight = PixelFootprint::weightOf(texel);
    const auto share = [&](double w) { return f.weightSum > 0 ? number(100 * w / f.weightSum, 2) : number(0, 2); };
    if (texel.hidden) {
        const glm::dvec2 by = texel.blocker;
        text += tr(": hidden by the relief at (%1, %2), weight %3 left out")
                    .arg(number(by.x, 1), number(by.y, 1), number(weight, 3));
    } else {
        text += tr(": weight %1, %2%").arg(number(weight, 3), share(weight));
        if (texel.weight.r != texel.weight.g || texel.weight.g != texel.weight.b) {
            const auto channel = [](float w) { return number(static_cast<double>(w), 2); };
            text += tr(" (%1, %2, %3)").arg(channel(texel.weight.r), channel(texel.weight.g), channel(texel.weight.b));
        }
        if (texel.tested) text += tr(" · seen");
        // A texel's hidden part is listed separately with the same indices.
        const auto same = [&](const relief::FootprintTexel& t) {
            return t.hidden && t.level == texel.level && t.u == texel.u && t.v == texel.v;
        };
        const auto part = std::find_if(f.log.texels.begin(), f.log.texels.end(), same);
        if (part != f.log.texels.end()) {
            text += tr(", partly hidden: weight %1 left out").arg(number(PixelFootprint::weightOf(*part), 3));
        }
    }
    const relief::LevelFootprint& footprint = f.log.footprint;
    if (footprint.kind == relief::FootprintKind::Ellipse) {
        const double square =
            relief::squaredRadius(footprint.ellipse, texel.u - footprint.centre.x, texel.v - footprint.centre.y);
        text += tr(" · r² %1").arg(number(square, 3));
    }
    return text;
}

std::shared_ptr<const Figure> FootprintView::figure() const {
    if (!footprint_) return nullptr;
    return footprintFigure(shown_, options_, stateOf<AnnotationState>(workspace_->scenario()).list);
}

}  // namespace reliefui
