#include "views/trace3d_view.h"

#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace reliefui {

namespace {

constexpr double kRayWidth = 2;
constexpr double kStretchWidth = 5;
constexpr double kCurrentWidth = 9;
constexpr double kViewElevation = 0.6;  // height of the eye over its horizontal distance

void setColor(vtkProperty* property, Rgba color) {
    property->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
}

QToolButton* toolButton(const QString& text, const QString& help, QWidget* parent) {
    auto* const button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setAutoRaise(true);
    return button;
}

}  // namespace

Trace3dView::Trace3dView(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      widget_(new QVTKOpenGLNativeWidget(this)),
      note_(new QLabel(this)),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    setAccessibleName(tr("Trace in 3-D"));
    setFocusPolicy(Qt::StrongFocus);
    window_->SetMultiSamples(0);
    renderer_->UseFXAAOn();
    window_->AddRenderer(renderer_);
    widget_->setRenderWindow(window_);
    widget_->interactor()->SetInteractorStyle(vtkSmartPointer<vtkInteractorStyleTrackballCamera>::New());
    widget_->setToolTip(tr("Drag turns, wheel zooms, Shift+drag moves, R fits"));

    auto* const bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 4, 2);
    auto* const fitButton = toolButton(tr("Fit"), tr("Show the whole patch (R)"), this);
    connect(fitButton, &QToolButton::clicked, this, &Trace3dView::fit);
    auto* const follow = toolButton(tr("Follow"), tr("Keep the current step in the middle"), this);
    follow->setCheckable(true);
    connect(follow, &QToolButton::toggled, this, &Trace3dView::setFollowing);
    auto* const heights = new QComboBox(this);
    for (const int n : {1, 2, 4}) heights->addItem(tr("heights × %1").arg(n), n);
    heights->setToolTip(tr("Exaggeration of heights"));
    heights->setAccessibleName(heights->toolTip());
    connect(heights, QOverload<int>::of(&QComboBox::activated), this,
            [this, heights](int row) { setExaggeration(heights->itemData(row).toInt()); });
    bar->addWidget(fitButton);
    bar->addWidget(follow);
    bar->addWidget(heights);
    bar->addWidget(note_, 1);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(widget_, 1);
    connect(workspace_, &Workspace::snapshotChanged, this, &Trace3dView::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &Trace3dView::showStep);
    connect(workspace_, &Workspace::styleChanged, this, [this] {
        shown_.reset();
        refresh();
    });
    refresh();
}

Trace3dView::~Trace3dView() = default;

vtkSmartPointer<vtkActor> Trace3dView::addLine(vtkSmartPointer<vtkPolyData> data, Rgba color, double width) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    // Lines on the surface are drawn before it.
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -20);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-40);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width * (workspace_->style().projector ? 2 : 1)));
    setColor(actor->GetProperty(), color);
    renderer_->AddActor(actor);
    return actor;
}

void Trace3dView::applyStyle() {
    const Rgba ground = workspace_->style().background();
    renderer_->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
}

void Trace3dView::addStretches() {
    const Style& style = workspace_->style();
    // A stretch of a million steps would be a million actors, and no eye could tell them apart.
    constexpr std::size_t kMost = 400;
    std::size_t drawn = 0;
    for (const relief::Step& step : shown_->trace.steps) {
        if (!coversStretch(step.decision) || ++drawn > kMost) continue;
        addLine(scene_->stretch(step), style.color(roleOf(step.decision)), kStretchWidth);
    }
}

void Trace3dView::refresh() {
    const auto snapshot = workspace_->snapshot();
    applyStyle();
    const bool same = shown_ && snapshot && shown_->version == snapshot->version && shown_->coarse == snapshot->coarse;
    if (same) return;
    shown_ = snapshot;
    renderer_->RemoveAllViewProps();
    stepActors_.clear();
    scene_.reset();
    if (!shown_ || !shown_->trace.onRelief) {
        note_->setText(shown_ ? tr("click on the relief: its ray is shown here") : QString());
        render();
        return;
    }
    scene_ = std::make_unique<TraceScene>(*shown_, exaggeration_);
    const Style& style = workspace_->style();
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(scene_->relief());
    auto relief = vtkSmartPointer<vtkActor>::New();
    relief->SetMapper(mapper);
    relief->GetProperty()->SetAmbient(0.35);
    relief->GetProperty()->SetDiffuse(0.75);
    renderer_->AddActor(relief);
    addLine(scene_->slabFrame(), style.color(Role::Frame), 1);
    addLine(scene_->ray(), style.color(Role::Ray), kRayWidth);
    addStretches();
    if (shown_->trace.hit.outcome == relief::Outcome::Hit) {
        const double outer = style.projector ? 26 : 15;
        for (const auto& [color, size] :
             {std::pair{Rgba{255, 255, 255}, outer}, std::pair{Rgba{0, 0, 0}, outer * 0.55}}) {
            auto mark = addLine(scene_->point(scene_->end), color, 1);
            mark->GetProperty()->SetPointSize(static_cast<float>(size));
            mark->GetProperty()->SetRenderPointsAsSpheres(true);
            mark->GetMapper()->SetRelativeCoincidentTopologyPointOffsetParameter(size == outer ? -60 : -90);
        }
    }
    if (!placed_) {
        fit();
    } else {
        lookAtPatch();
    }
    showStep(shown_->scenario.step);
}

void Trace3dView::showStep(int step) {
    for (const auto& actor : stepActors_) renderer_->RemoveActor(actor);
    stepActors_.clear();
    if (scene_ && !shown_->trace.steps.empty()) {
        const auto& steps = shown_->trace.steps;
        const auto at = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
        const relief::Step& now = steps[at];
        const Rgba color = workspace_->style().color(roleOf(now.decision));
        stepActors_.push_back(addLine(scene_->stretch(now), color, kCurrentWidth));
        auto faces = addLine(scene_->box(now), color, 1);
        faces->GetProperty()->SetOpacity(0.22);
        auto edges = addLine(scene_->box(now), color, 2);
        edges->GetProperty()->SetRepresentationToWireframe();
        stepActors_.push_back(faces);
        stepActors_.push_back(edges);
        note_->setText(tr("step %1 of %2: level %3, texel (%4, %5)")
                           .arg(at + 1)
                           .arg(steps.size())
                           .arg(now.level)
                           .arg(now.i)
                           .arg(now.j));
        if (following_) {
            double eye[3];
            scene_->position(now.lambdaAfter, eye);
            vtkCamera* const camera = renderer_->GetActiveCamera();
            double focus[3];
            double place[3];
            camera->GetFocalPoint(focus);
            camera->GetPosition(place);
            camera->SetFocalPoint(eye);
            camera->SetPosition(place[0] + eye[0] - focus[0], place[1] + eye[1] - focus[1],
                                place[2] + eye[2] - focus[2]);
        }
    }
    renderer_->ResetCameraClippingRange();
    render();
}

// Keeps the direction of the view, at the distance that shows the patch.
void Trace3dView::lookAtPatch() {
    const Box& p = scene_->patch;
    const double bounds[6] = {p.x0, p.x1, -p.y1, -p.y0, scene_->bottom, scene_->scale};
    renderer_->ResetCamera(bounds);
    renderer_->GetActiveCamera()->Zoom(1.35);
}

void Trace3dView::fit() {
    if (!scene_) return;
    const Point center = scene_->patch.center();
    const double length = std::hypot(scene_->path.run.x, scene_->path.run.y);
    // From the side of the ray, a little from behind it, so that it runs across the picture.
    const double dx = length > 0 ? scene_->path.run.x / length : 1;
    const double dy = length > 0 ? -scene_->path.run.y / length : 0;
    const double sideX = dy - 0.35 * dx;
    const double sideY = -dx - 0.35 * dy;
    const double middle = 0.5 * (scene_->bottom + scene_->scale);
    vtkCamera* const camera = renderer_->GetActiveCamera();
    camera->SetFocalPoint(center.x, -center.y, middle);
    camera->SetPosition(center.x + sideX, -center.y + sideY, middle + kViewElevation);
    camera->SetViewUp(0, 0, 1);
    placed_ = true;
    lookAtPatch();
    renderer_->ResetCameraClippingRange();
    render();
}

void Trace3dView::setFollowing(bool on) {
    following_ = on;
    showStep(workspace_->scenario().step);
}

void Trace3dView::setExaggeration(int n) {
    exaggeration_ = n;
    shown_.reset();
    refresh();
}

void Trace3dView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_R) {
        fit();
        return;
    }
    QWidget::keyPressEvent(event);
}

void Trace3dView::render() {
    // Before the first exposure there is no context to draw in; Qt paints the widget then by itself.
    if (widget_->isVisible()) window_->Render();
    widget_->update();
}

}  // namespace reliefui
