#include "panes/shader/shader_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/drawing_canvas.h"
#include "panes/narrow_bar.h"
#include "panes/pane_controls.h"
#include "panes/range_button.h"
#include "panes/shader/shader_figure.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"
#include "workspace/range_json.h"

namespace reliefui {

ShaderView::ShaderView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Shader"), QStringLiteral("shader"), tr("Export the shader's picture"), parent),
      canvas_(new DrawingCanvas(this)),
      open_(openShaderGl) {
    setFace(canvas_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
        stopped_ = true;
        redraw();
        showBusy();
    };
    listener.progress = [this](const QString&, double fraction) {
        fraction_ = fraction;
        showBusy();
    };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    auto* const bar = new NarrowBar(this);
    makeBar(bar->row());
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(canvas_, 1);
    connect(canvas_, &DrawingCanvas::pointed, this, &ShaderView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &ShaderView::redraw);
    connect(canvas_, &DrawingCanvas::clicked, this, [this](const ItemId& id) {
        if (id.kind == ItemKind::ColorBar) range_->open();
    });
    connect(canvas_, &DrawingCanvas::clickedAt, this, [this](const QPointF& widget) {
        if (!preview_ || preview_->problem) return;
        const auto pixel = picture_.pixelAt(canvas_->toDrawing(widget));
        if (!pixel) return;
        workspace_->finishInteraction();  // each click is an undo step of its own
        workspace_->choosePixel(pixel->x, pixel->y);
    });
    connect(workspace_, &Workspace::panesChanged, this, &ShaderView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, &ShaderView::redraw);
    adopt();
    refresh();
}

ShaderView::~ShaderView() = default;

void ShaderView::makeBar(QHBoxLayout* bar) {
    draw_ = addToolButton(bar, tr("draw"), tr("Draw the shader again and measure its time, or cancel it (Esc)"));
    draw_->setObjectName(QStringLiteral("shader-draw"));
    worst_ = addToolButton(bar, tr("worst pixel"), tr("Choose the pixel with the largest difference"));
    worst_->setObjectName(QStringLiteral("shader-worst"));
    measure_ = addChooser(bar, "shader-measure", tr("Difference to show, by which the worst pixel is found"));
    measure_->addItem(tr("colours"));
    measure_->addItem(tr("hits"));
    range_ = new RangeButton(
        workspace_,
        [this]() -> std::optional<RangedValues> {
            if (!preview_ || preview_->problem) return std::nullopt;
            return shaderValues(source(), workspace_->style().language);
        },
        this);
    bar->addWidget(range_);
    summary_ = new QLabel(this);
    summary_->setObjectName(QStringLiteral("shader-summary"));
    bar->addWidget(summary_);
    bar->addStretch(1);
    connect(draw_, &QToolButton::clicked, this, [this] { job_->busy() ? void(cancel()) : draw(); });
    connect(worst_, &QToolButton::clicked, this, &ShaderView::chooseWorst);
    connect(measure_, qOverload<int>(&QComboBox::activated), this,
            [this](int measure) { setMeasure(static_cast<ShaderMeasure>(measure)); });
}

bool ShaderView::current() const {
    const auto now = workspace_->snapshot();
    return preview_ && now && preview_->snapshot->frame == now->frame;
}

bool ShaderView::outdated() const {
    return preview_ && !current();
}

void ShaderView::setGlSource(ShaderGlSource source) {
    open_ = std::move(source);
    preview_.reset();
    snapshot_.reset();
    refresh();
}

void ShaderView::showSnapshot() {
    const PauseLog::Part part("shader");
    const std::shared_ptr<const Snapshot> snapshot = workspace_->snapshot();
    if (!snapshot || !snapshot->request || !snapshot->frame) {
        job_->drop();
        preview_.reset();
        snapshot_.reset();
        redraw();
        return showBusy();
    }
    // While the view moves, all processors are needed for its picture.
    if (snapshot->coarse) {
        job_->drop();
        snapshot_.reset();
    } else if (!snapshot_ || snapshot_->frame != snapshot->frame) {
        snapshot_ = snapshot;
        stopped_ = false;
        if (!current()) return draw();
    }
    redraw();
    showBusy();
}

void ShaderView::draw() {
    if (!snapshot_ || !isOnScreen()) return;
    auto made = std::make_shared<std::shared_ptr<const ShaderPreview>>();
    const auto work = [made, snapshot = snapshot_, open = open_](relief::Work& w) {
        *made = shaderPreview(snapshot, open, w);
    };
    const auto done = [this, made] {
        preview_ = *made;
        redraw();
        showBusy();
    };
    stopped_ = false;
    fraction_ = 0;
    job_->start({work, done});
    redraw();
    showBusy();
}

bool ShaderView::cancel() {
    return job_->cancel();
}

void ShaderView::chooseWorst() {
    if (!preview_ || preview_->problem) return;
    const auto worst = preview_->worst(pane_.measure);
    if (!worst) return;
    workspace_->finishInteraction();
    workspace_->choosePixel(worst->x, worst->y);
}

void ShaderView::setMeasure(ShaderMeasure measure) {
    workspace_->change(withState(workspace_->scenario(), ShaderPane{measure}),
                       changeName([] { return tr("Shader: other difference"); }));
    adopt();
}

void ShaderView::adopt() {
    pane_ = stateOf<ShaderPane>(workspace_->scenario());
    measure_->setCurrentIndex(static_cast<int>(pane_.measure));
    redraw();
    showBusy();
}

void ShaderView::releaseContents() {
    job_->drop();
    preview_.reset();
    snapshot_.reset();
    picture_ = {};
    canvas_->releaseContents();
    setReadout({});
}

ShaderSource ShaderView::source() const {
    ShaderSource source;
    source.preview = preview_;
    source.measure = pane_.measure;
    source.range = rangesOf(workspace_->scenario()).of(shaderRangeOf(pane_.measure));
    source.before = !current();
    if (!source.before) source.pixel = workspace_->scenario().pixel;
    return source;
}

void ShaderView::redraw() {
    const PauseLog::Part part("shader: drawing");
    if (markStaleIfHidden()) return;
    const Style& style = workspace_->style();
    canvas_->setStyle(style);
    if (!preview_) {
        const bool press = stopped_ && snapshot_;
        const auto busy = press ? relief::MessageId::ShaderPress : relief::MessageId::ShaderDrawing;
        return canvas_->showText(snapshot_ ? busy : workspace_->whyEmpty());
    }
    if (preview_->problem) {
        picture_ = {};
        return canvas_->showText(*preview_->problem);
    }
    const ShaderSource now = source();
    constexpr double kMostLegend = 0.5;  // the numbers are what the pane is for
    const auto legend = canvas_->showLegend(shaderLegend(now, canvas_->legendWidth(), style.language), kMostLegend);
    const QSizeF room = canvas_->room();
    picture_ = shaderPicture(now, room.width(), room.height(), style.language);
    canvas_->setLayers({std::make_shared<const Drawing>(picture_.drawing)}, legend);
}

void ShaderView::showBusy() {
    const bool busy = job_ && job_->busy();
    constexpr int kHundred = 100;
    draw_->setText(busy ? tr("cancel (%1%)").arg(static_cast<int>(kHundred * fraction_)) : tr("draw"));
    worst_->setEnabled(current() && !preview_->problem && preview_->worst(pane_.measure));
    range_->refresh();
    showSummary();
}

// All lines are in the tool tip, because a low pane has no room for them.
void ShaderView::showSummary() {
    const bool shown = preview_ && !preview_->problem && current();
    const relief::Language language = workspace_->style().language;
    QStringList lines;
    if (shown) {
        for (const relief::Message& line : shaderLines(source())) {
            lines << QString::fromStdString(relief::sentence(line, language));
        }
    }
    summary_->setText(shown ? QString::fromStdString(relief::sentence(shaderSummary(*preview_), language)) : QString());
    summary_->setToolTip(lines.join(QLatin1Char('\n')));
    canvas_->setAccessibleDescription(summary_->toolTip());
}

void ShaderView::readOut(const QPointF& widget) {
    if (!preview_ || preview_->problem) return setReadout({});
    const auto pixel = picture_.pixelAt(canvas_->toDrawing(widget));
    if (!pixel) return setReadout({});
    const relief::Language language = workspace_->style().language;
    setReadout(QString::fromStdString(relief::sentence(shaderReadout(*preview_, *pixel), language)));
}

std::shared_ptr<const Figure> ShaderView::figure() const {
    return current() && !preview_->problem ? shaderFigure(source()) : nullptr;
}

}  // namespace reliefui
