#include "panes/trace/trace3d_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/pane_controls.h"
#include "panes/screen_gl.h"
#include "panes/trace/trace_figure.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

Trace3dView::Trace3dView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Trace in 3-D"), QStringLiteral("trace"), tr("Export the trace"), parent),
      widget_(new QVTKOpenGLNativeWidget(glParent(this))),
      note_(new QLabel(this)),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
    // Qt also creates these gestures from mouse drags, and prints warnings if they end while the pane is hidden. Pinch
    // and pan gestures remain.
    for (const Qt::GestureType gesture : {Qt::TapGesture, Qt::TapAndHoldGesture}) widget_->ungrabGesture(gesture);
    setFace(widget_);
    widget_->setContextMenuPolicy(Qt::DefaultContextMenu);
    widget_->setAccessibleName(tr("Trace in 3-D"));
    // As in all panes, sizes are already in device pixels (deviceStyle()).
    widget_->setEnableHiDPI(false);
    widget_->setFocusPolicy(Qt::StrongFocus);
    window_->SetMultiSamples(0);
    picture_.addTo(window_);
    // VTK lays out no text in a window one pixel wide or high, and then complains that its texture is empty.
    widget_->setMinimumSize(2, 2);
    widget_->setRenderWindow(window_);
    widget_->interactor()->SetInteractorStyle(nullptr);
    widget_->installEventFilter(this);

    auto* const bar = new QHBoxLayout;
    makeBar(bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    addGlWidget(*widget_, *column, *this);
    connect(workspace_, &Workspace::stepChanged, this, &Trace3dView::showStep);
    connect(workspace_, &Workspace::panesChanged, this, &Trace3dView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, [this] {
        picture_.forget();
        refresh();
    });
    adopt();
    refresh();
}

Trace3dView::~Trace3dView() {
    deferredRender_.stop();
}

vtkRenderer* Trace3dView::renderer() const {
    return picture_.renderer();
}

void Trace3dView::makeBar(QHBoxLayout* bar) {
    bar->setContentsMargins(4, 2, 6, 2);
    colors_ = addChooser(bar, "trace-colors", tr("Meaning of the steps' colours"));
    const std::vector<std::string>& names = tracePaneColors();
    for (const QString& text : {tr("steps by decision"), tr("steps by level"), tr("steps by phase")}) {
        colors_->addItem(text, QString::fromStdString(names[static_cast<std::size_t>(colors_->count())]));
    }
    connect(colors_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int row) { setColors(colors_->itemData(row).toString()); });
    heights_ = addChooser(bar, "trace-heights", tr("Exaggeration of heights"));
    for (const double n : {0.25, 0.5, 1.0, 2.0, 4.0}) heights_->addItem(tr("heights × %1").arg(n), n);
    heights_->setCurrentIndex(heights_->findData(pane_.heights));
    connect(heights_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int row) { setExaggeration(heights_->itemData(row).toDouble()); });
    follow_ = addToolButton(bar, tr("follow"), tr("Keep the current step in the middle"), true);
    connect(follow_, &QToolButton::clicked, this, &Trace3dView::setFollowing);
    auto* const fitButton = addToolButton(
        bar, tr("fit"),
        tr("Show the whole patch (R); drag or arrows turn, right drag or Shift+arrows move, wheel or + − zoom"));
    connect(fitButton, &QToolButton::clicked, this, &Trace3dView::fit);
    bar->addWidget(note_, 1);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

Style Trace3dView::deviceStyle() const {
    Style style = workspace_->style();
    style.screenPixelsPerPoint *= widget_->devicePixelRatioF();
    return style;
}

// The note is hidden rather than cut off, because a truncated number is misleading. The tool tip always shows it.
void Trace3dView::fitNote() {
    const QString text = note_->toolTip();
    note_->setText(note_->fontMetrics().horizontalAdvance(text) <= note_->width() ? text : QString());
}

void Trace3dView::takeSize() {
    fitNote();
    picture_.setSize(widget_->size() * widget_->devicePixelRatioF());
}

bool Trace3dView::outdated() const {
    return picture_.shown() && picture_.shown() != workspace_->snapshot();
}

void Trace3dView::showSnapshot() {
    const PauseLog::Part part("trace 3-D: scene");
    const auto snapshot = workspace_->snapshot();
    const auto& shown = picture_.shown();
    const bool same = shown && snapshot && shown->version == snapshot->version && shown->coarse == snapshot->coarse &&
                      shown->otherFiles == snapshot->otherFiles && shown->trace.hidden == snapshot->trace.hidden;
    if (same && becameVisible()) showStep(workspace_->scenario().step);
    if (same) return;
    note_->setToolTip({});
    fitNote();
    takeSize();
    picture_.setColors(stepColors(pane_.colors));
    picture_.show(snapshot, deviceStyle(), pane_.heights, workspace_->whyEmpty());
    if (picture_.scene() == nullptr) return render();
    placed_ ? picture_.showAll() : picture_.fit();
    placed_ = true;
    showStep(workspace_->scenario().step);
}

void Trace3dView::releaseContents() {
    picture_.show(nullptr, deviceStyle(), pane_.heights);
    note_->setToolTip({});
    fitNote();
}

void Trace3dView::showStep(int step) {
    const PauseLog::Part part("trace 3-D: step");
    if (markStaleIfHidden()) return;
    picture_.showStep(step);
    if (const TraceScene* const scene = picture_.scene()) {
        const auto number = [](double v) { return QString::fromStdString(relief::numberText(v, 3)); };
        note_->setToolTip(tr("%1 × %2 × %3 texels")
                              .arg(number(scene->patch.width()), number(scene->patch.height()),
                                   number(picture_.shown()->request->field.slabTexels())));
        fitNote();
        if (pane_.follow) picture_.follow(step);
    }
    render();
}

void Trace3dView::fit() {
    picture_.fit();
    render();
}

void Trace3dView::change(const TracePane& pane) {
    workspace_->change(withState(workspace_->scenario(), pane), changeName([] { return tr("Trace 3-D: other view"); }));
    adopt();
}

void Trace3dView::adopt() {
    const TracePane before = std::exchange(pane_, stateOf<TracePane>(workspace_->scenario()));
    follow_->setChecked(pane_.follow);
    heights_->setCurrentIndex(heights_->findData(pane_.heights));
    colors_->setCurrentIndex(colors_->findData(QString::fromStdString(pane_.colors)));
    picture_.setColors(stepColors(pane_.colors));
    if (pane_.heights != before.heights) {
        picture_.forget();
        refresh();
    }
    if (pane_.follow == before.follow && pane_.colors == before.colors) return;
    if (before.follow && !pane_.follow) picture_.showAll();
    showStep(workspace_->scenario().step);
}

void Trace3dView::setFollowing(bool on) {
    set(&TracePane::follow, on);
}

void Trace3dView::setExaggeration(double n) {
    set(&TracePane::heights, n);
}

void Trace3dView::setColors(const QString& by) {
    set(&TracePane::colors, by.toStdString());
}

bool Trace3dView::handleMouse(QMouseEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        widget_->setFocus(Qt::MouseFocusReason);
        pressed_ = last_ = event->localPos();
        dragged_ = false;
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease) {
        if (event->button() == Qt::RightButton && !dragged_) openMenu(event->pos());
        return true;
    }
    if (event->buttons() == Qt::NoButton) return false;
    constexpr double kClickReach = 3;  // in pixels
    dragged_ = dragged_ || (event->localPos() - pressed_).manhattanLength() > kClickReach;
    const QPointF by = event->localPos() - last_;
    last_ = event->localPos();
    const bool turns = (event->buttons() & Qt::LeftButton) != 0 && (event->modifiers() & Qt::ShiftModifier) == 0;
    const double height = picture_.relief() * widget_->height();
    turns ? picture_.camera.turn(by.x(), by.y(), height) : picture_.camera.move(by.x(), by.y(), height);
    render();
    return true;
}

// R shows the whole patch; arrow keys rotate, with Shift they move; plus and minus zoom.
bool Trace3dView::handleKey(QKeyEvent* event) {
    constexpr double kTurn = 24;  // as for a drag of this many pixels
    constexpr double kNearer = 1.2;
    const bool shift = event->modifiers() == Qt::ShiftModifier;
    double dx = 0;
    double dy = 0;
    switch (event->key()) {
        case Qt::Key_R:
            if (event->modifiers() != Qt::NoModifier) return false;
            fit();
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            picture_.camera.zoom(kNearer, 0, 0);
            break;
        case Qt::Key_Minus:
            picture_.camera.zoom(1 / kNearer, 0, 0);
            break;
        case Qt::Key_Left:
            dx = -kTurn;
            break;
        case Qt::Key_Right:
            dx = kTurn;
            break;
        case Qt::Key_Up:
            dy = -kTurn;
            break;
        case Qt::Key_Down:
            dy = kTurn;
            break;
        default:
            return false;
    }
    if (dx != 0 || dy != 0) {
        const double height = picture_.relief() * widget_->height();
        shift ? picture_.camera.move(dx, dy, height) : picture_.camera.turn(dx, dy, height);
    }
    render();
    return true;
}

bool Trace3dView::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseMove:
            return handleMouse(static_cast<QMouseEvent*>(event));
        case QEvent::Wheel: {
            const auto* const wheel = static_cast<QWheelEvent*>(event);
            const double half = picture_.relief() * widget_->height() / 2.0;
            picture_.camera.zoom(std::pow(1.2, wheel->angleDelta().y() / 120.0),
                                 (wheel->position().x() - widget_->width() / 2.0) / half,
                                 (half - wheel->position().y()) / half);
            render();
            return true;
        }
        case QEvent::KeyPress:
            return handleKey(static_cast<QKeyEvent*>(event));
        case QEvent::ContextMenu:
            // Opens the menu by its key; with the mouse it opens on a click without a drag.
            if (static_cast<QContextMenuEvent*>(event)->reason() != QContextMenuEvent::Keyboard) return true;
            openMenu(widget_->rect().center());
            return true;
        case QEvent::Resize:
            takeSize();
            if (!pane_.follow) picture_.showAll();
            render();
            return false;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

void Trace3dView::renderNow() {
    if (!widget_->isVisible() || !widget_->isValid()) return;
    const DrawingTime time("trace 3-D");
    window_->Render();
}

void Trace3dView::render() {
    picture_.place();
    deferredRender_.start();
}

std::shared_ptr<const Figure> Trace3dView::figure() const {
    const auto& shown = picture_.shown();
    if (!shown || !shown->request || !shown->trace.onRelief) return nullptr;
    return traceFigure(shown, workspace_->scenario().step, {pane_.heights, stepColors(pane_.colors), picture_.camera});
}

}  // namespace reliefui
