#include "views/trace3d_view.h"

#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "drawings/vtk_text.h"
#include "scenario/step_sentence.h"
#include "views/trace3d_bodies.h"
#include "views/trace3d_marks.h"
#include "views/trace3d_samples.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

QToolButton* toolButton(const QString& text, const QString& help, QWidget* parent) {
    auto* const button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setAutoRaise(true);
    return button;
}

// From the upper left behind the eye: slopes are told apart, and nothing is black.
void addLight(vtkRenderer* renderer) {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToCameraLight();
    light->SetPosition(-0.6, 0.8, 0.9);
    light->SetFocalPoint(0, 0, 0);
    renderer->AddLight(light);
}

// The number of the step, and what it read.
QString stepWords(const relief::Step& step, const StepBody& body, const MapWalk& walk, std::size_t number) {
    const QString value = QString::fromStdString(relief::fixedText(step.value, 3));
    constexpr double kNone = 0.005;  // texels
    if (body.kind == StepBody::Kind::Sphere && body.radius < kNone) return QString::number(number + 1);
    if (body.kind == StepBody::Kind::Sphere) {
        return Trace3dView::tr("%1: empty for %2 texels")
            .arg(number + 1)
            .arg(QString::fromStdString(relief::fixedText(body.radius, 2)));
    }
    if (body.kind == StepBody::Kind::Cone) return Trace3dView::tr("%1: cone of slope %2").arg(number + 1).arg(value);
    const bool ends = step.decision == relief::Decision::Start || step.decision == relief::Decision::Miss;
    if (!valueIsHeight(walk, step)) return QString::number(number + 1);
    if (step.primitive == relief::Primitive::Texel) {
        return Trace3dView::tr("%1: level %2, %3").arg(number + 1).arg(step.level).arg(value);
    }
    return ends ? QString::number(number + 1) : Trace3dView::tr("%1: surface at %2").arg(number + 1).arg(value);
}

}  // namespace

Trace3dView::Trace3dView(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      widget_(new QVTKOpenGLNativeWidget(this)),
      note_(new QLabel(this)),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    // Made of mouse drags, too; Qt complains of those that end when the pane is hidden. Fingers pinch and pan.
    for (const Qt::GestureType gesture : {Qt::TapGesture, Qt::TapAndHoldGesture}) widget_->ungrabGesture(gesture);
    setAccessibleName(tr("Trace in 3-D"));
    setFocusProxy(widget_);
    widget_->setFocusPolicy(Qt::StrongFocus);
    window_->SetMultiSamples(0);
    renderer_->UseFXAAOn();
    window_->AddRenderer(renderer_);
    renderer_->SetAutomaticLightCreation(false);
    addLight(renderer_);
    widget_->setRenderWindow(window_);
    widget_->interactor()->SetInteractorStyle(nullptr);
    widget_->installEventFilter(this);

    auto* const bar = new QHBoxLayout;
    makeBar(bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(widget_, 1);
    connect(workspace_, &Workspace::snapshotChanged, this, &Trace3dView::refresh);
    connect(workspace_, &Workspace::stepChanged, this, &Trace3dView::showStep);
    connect(workspace_, &Workspace::panesChanged, this, &Trace3dView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, [this] {
        shown_.reset();
        refresh();
    });
    adopt();
    refresh();
}

Trace3dView::~Trace3dView() {
    renderSoon_.stop();
}

vtkRenderer* Trace3dView::renderer() const {
    return renderer_;
}

void Trace3dView::makeBar(QHBoxLayout* bar) {
    bar->setContentsMargins(4, 2, 6, 2);
    auto* const fitButton =
        toolButton(tr("fit"), tr("Show the whole patch (R); drag turns, right drag moves, wheel zooms"), this);
    connect(fitButton, &QToolButton::clicked, this, &Trace3dView::fit);
    follow_ = toolButton(tr("follow"), tr("Keep the current step in the middle"), this);
    follow_->setCheckable(true);
    connect(follow_, &QToolButton::clicked, this, &Trace3dView::setFollowing);
    heights_ = new QComboBox(this);
    for (const double n : {0.25, 0.5, 1.0, 2.0, 4.0}) heights_->addItem(tr("heights × %1").arg(n), n);
    heights_->setCurrentIndex(heights_->findData(pane_.heights));
    heights_->setToolTip(tr("Exaggeration of heights"));
    heights_->setAccessibleName(heights_->toolTip());
    connect(heights_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int row) { setExaggeration(heights_->itemData(row).toDouble()); });
    bar->addWidget(heights_);
    bar->addWidget(follow_);
    bar->addWidget(fitButton);
    bar->addWidget(note_, 1);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void Trace3dView::addRelief() {
    const Style& style = workspace_->style();
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(scene_->relief());
    auto foot = vtkSmartPointer<vtkPlane>::New();
    foot->SetOrigin(0, 0, scene_->bottom);
    foot->SetNormal(0, 0, 1);
    mapper->AddClippingPlane(foot);
    auto relief = vtkSmartPointer<vtkActor>::New();
    relief->SetMapper(mapper);
    relief->GetProperty()->SetAmbient(0.3);
    relief->GetProperty()->SetDiffuse(0.85);
    renderer_->AddActor(relief);
    auto sides = vtkSmartPointer<vtkActor>::New();
    auto sideMapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    sideMapper->SetInputData(scene_->skirt());
    sides->SetMapper(sideMapper);
    sides->GetProperty()->SetAmbient(0.6);
    sides->GetProperty()->SetDiffuse(0.4);
    const double grey = style.theme == Theme::Dark ? 0.32 : 0.72;
    sides->GetProperty()->SetColor(grey, grey, grey * 1.04);
    renderer_->AddActor(sides);
    const TraceMarks marks(*scene_, shown_->request->field, style);
    renderer_->AddActor(marks.line(scene_->slabFrame(), Role::Label, 1));
    topLabel_ = marks.words({}, tr("height 1").toStdString(), Role::Label, 0.85);
    topLabel_->GetTextProperty()->SetJustificationToRight();
    renderer_->AddActor2D(topLabel_);
}

// At the corner that is leftmost now: out of the way of the ray and its words.
void Trace3dView::placeTopLabel() {
    if (!scene_ || topLabel_ == nullptr) return;
    const Place right = camera_.right();
    const Box& p = scene_->patch;
    double least = 0;
    bool first = true;
    for (const double s : {p.x0, p.x1}) {
        for (const double t : {p.y0, p.y1}) {
            const double along = s * right[0] - t * right[1];
            if (!first && along >= least) continue;
            first = false;
            least = along;
            topLabel_->GetPositionCoordinate()->SetValue(s, -t, scene_->scale);
        }
    }
}

void Trace3dView::addRay() {
    const TraceMarks marks(*scene_, shown_->request->field, workspace_->style());
    renderer_->AddActor(marks.shadow());
    renderer_->AddActor(marks.ray());
    renderer_->AddActor(marks.curtain());
    if (shown_->trace.hit.outcome != relief::Outcome::Hit) return;
    for (const auto& part : marks.hitRing(renderer_->GetActiveCamera())) renderer_->AddActor(part);
}

void Trace3dView::addWords(const QString& words) {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput(words.toUtf8().constData());
    setText(text->GetTextProperty(), workspace_->style().text(), workspace_->style().textPixels());
    text->GetTextProperty()->SetJustificationToCentered();
    text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    text->SetPosition(0.5, 0.5);
    renderer_->AddActor2D(text);
}

void Trace3dView::refresh() {
    const PauseLog::Part part("trace 3-D: scene");
    const auto snapshot = workspace_->snapshot();
    const Rgba ground = workspace_->style().background();
    renderer_->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    const bool same = shown_ && snapshot && shown_->version == snapshot->version &&
                      shown_->coarse == snapshot->coarse && shown_->trace.hidden == snapshot->trace.hidden;
    if (same) return;
    shown_ = snapshot;
    renderer_->RemoveAllViewProps();
    stepProps_.clear();
    scene_.reset();
    topLabel_ = nullptr;
    note_->clear();
    if (!shown_ || !shown_->request || !shown_->trace.onRelief) {
        const auto why = !shown_ || !shown_->request ? relief::MessageId::DrawNoPicture
                         : shown_->scenario.pixel    ? relief::MessageId::DrawNoRelief
                                                     : relief::MessageId::DrawNoRay;
        addWords(QString::fromStdString(relief::sentence(relief::Message(why), workspace_->style().language)));
        render();
        return;
    }
    scene_ = std::make_unique<TraceScene>(*shown_, pane_.heights);
    addRelief();
    addRay();
    placed_ ? showAll() : fit();
    showStep(workspace_->scenario().step);
}

void Trace3dView::addStep(const relief::Step& step, std::size_t number) {
    const Style& style = workspace_->style();
    const TraceMarks marks(*scene_, shown_->request->field, style);
    for (const bool later : {false, true}) {
        stepProps_.push_back(marks.stretches(shown_->trace.steps, number, later));
    }
    if (step.lambdaOut > step.lambdaIn) stepProps_.push_back(marks.stretch(step));
    const MapWalk walk = walkedMap(shown_->scenario.method);
    const relief::HeightField& field = shown_->request->field;
    if (step.primitive == relief::Primitive::Texel) {
        const TraceMarks::Prism prism = marks.prism(step, walk, *shown_->maxima);
        stepProps_.push_back(marks.box(prism));
        stepProps_.push_back(marks.boxEdges(prism));
    }
    for (const auto& mark : bodyMarks(*scene_, *shown_, walk, number, style, marks.radius())) {
        stepProps_.push_back(mark);
    }
    const StepBody body = stepBody(walk, field, *shown_->maxima, shown_->trace.ray, step);
    const QString words = stepWords(step, body, walk, number);
    // Samples of layers are shown as sheets; those of a map have their spheres or cones.
    const std::vector<relief::Step> none;
    for (const auto& mark :
         sampleMarks(*scene_, walk.interpolated ? none : shown_->trace.steps, number, style, marks.radius())) {
        stepProps_.push_back(mark);
    }
    stepProps_.push_back(marks.words(body ? aboveBody(*scene_, *shown_, body) : marks.labelPlace(step),
                                     words.toStdString(), Role::Label, 1));
    for (const auto& prop : stepProps_) renderer_->AddViewProp(prop);
}

void Trace3dView::showStep(int step) {
    const PauseLog::Part part("trace 3-D: step");
    for (const auto& prop : stepProps_) renderer_->RemoveViewProp(prop);
    stepProps_.clear();
    if (scene_ && !shown_->trace.steps.empty()) {
        const auto& steps = shown_->trace.steps;
        const auto at = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
        addStep(steps[at], at);
        const auto number = [](double v) { return QString::fromStdString(relief::numberText(v, 3)); };
        note_->setText(tr("%1 × %2, slab %3 texels")
                           .arg(number(scene_->patch.width()), number(scene_->patch.height()),
                                number(shown_->request->field.slabTexels())));
        if (pane_.follow) camera_.setFocus(scene_->onRay(std::min(steps[at].lambdaAfter, scene_->end)));
    }
    render();
}

// Keeps the direction of the view, at the distance that shows the patch.
void Trace3dView::showAll() {
    const Box& p = scene_->patch;
    std::vector<Place> places;
    for (const double z : {scene_->bottom, scene_->scale}) {
        for (const double s : {p.x0, p.x1}) {
            for (const double t : {p.y0, p.y1}) places.push_back({s, -t, z});
        }
    }
    camera_.fit(places, static_cast<double>(std::max(1, widget_->width())) / std::max(1, widget_->height()));
    placed_ = true;
}

void Trace3dView::fit() {
    if (!scene_) return;
    const double length = std::hypot(scene_->path.run.x, scene_->path.run.y);
    // Across the ray, a little from behind it, so that it runs through the picture from left to right.
    constexpr double kBehind = 0.45;
    const double dx = length > 0 ? scene_->path.run.x / length : 1;
    const double dy = length > 0 ? -scene_->path.run.y / length : 0;
    camera_.lookAlong(-dy + kBehind * dx, dx + kBehind * dy);
    showAll();
    render();
}

void Trace3dView::change(const relief::TracePane& pane) {
    relief::PaneStates panes = workspace_->scenario().panes;
    panes.trace = pane;
    workspace_->setPanes(panes, tr("Trace 3-D: other view"));
    adopt();
}

void Trace3dView::adopt() {
    const relief::TracePane before = std::exchange(pane_, workspace_->scenario().panes.trace);
    follow_->setChecked(pane_.follow);
    heights_->setCurrentIndex(heights_->findData(pane_.heights));
    if (pane_.heights != before.heights) {
        shown_.reset();
        refresh();
    }
    if (pane_.follow == before.follow) return;
    if (!pane_.follow && scene_) showAll();
    showStep(workspace_->scenario().step);
}

void Trace3dView::setFollowing(bool on) {
    change({pane_.heights, on});
}

void Trace3dView::setExaggeration(double n) {
    change({n, pane_.follow});
}

bool Trace3dView::handleMouse(QMouseEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        widget_->setFocus(Qt::MouseFocusReason);
        last_ = event->localPos();
        return true;
    }
    if (event->buttons() == Qt::NoButton) return false;
    const QPointF by = event->localPos() - last_;
    last_ = event->localPos();
    const bool turns = (event->buttons() & Qt::LeftButton) != 0 && (event->modifiers() & Qt::ShiftModifier) == 0;
    turns ? camera_.turn(by.x(), by.y(), widget_->height()) : camera_.move(by.x(), by.y(), widget_->height());
    render();
    return true;
}

bool Trace3dView::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
            return handleMouse(static_cast<QMouseEvent*>(event));
        case QEvent::Wheel: {
            const auto* const wheel = static_cast<QWheelEvent*>(event);
            const double half = widget_->height() / 2.0;
            camera_.zoom(std::pow(1.2, wheel->angleDelta().y() / 120.0),
                         (wheel->position().x() - widget_->width() / 2.0) / half,
                         (half - wheel->position().y()) / half);
            render();
            return true;
        }
        case QEvent::KeyPress: {
            const auto* const key = static_cast<QKeyEvent*>(event);
            if (key->key() != Qt::Key_R || key->modifiers() != Qt::NoModifier) return false;
            fit();
            return true;
        }
        case QEvent::Resize:
            if (scene_ && !pane_.follow) showAll();
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
    camera_.apply(renderer_->GetActiveCamera());
    placeTopLabel();
    renderer_->ResetCameraClippingRange();
    renderSoon_.start();
}

}  // namespace reliefui
