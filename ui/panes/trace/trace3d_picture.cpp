#include "panes/trace/trace3d_picture.h"

#include <algorithm>
#include <cmath>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <QPainter>

#include "painting/painter.h"
#include "painting/vtk_text.h"
#include "panes/trace/trace3d_bodies.h"
#include "panes/trace/trace3d_marks.h"
#include "panes/trace/trace3d_samples.h"
#include "panes/trace/trace3d_view.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// Light from the upper left behind the viewer, so that slopes are distinguishable and nothing is black.
void addLight(vtkRenderer* renderer) {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToCameraLight();
    light->SetPosition(-0.6, 0.8, 0.9);
    light->SetFocalPoint(0, 0, 0);
    renderer->AddLight(light);
}

}  // namespace

QString stepWords(const relief::Step& step, std::size_t number) {
    const StepBody body = stepBody(step);
    const QString value = QString::fromStdString(relief::fixedText(step.value, 3));
    constexpr double kNone = 0.005;  // in texels
    if (body.kind == StepBody::Kind::Sphere && body.radius < kNone) return QString::number(number + 1);
    if (body.refined) {
        return Trace3dView::tr("%1: refined distance %2 texels")
            .arg(number + 1)
            .arg(QString::fromStdString(relief::fixedText(body.radius, 2)));
    }
    if (body.kind == StepBody::Kind::Sphere) {
        return Trace3dView::tr("%1: %2 texels of free space")
            .arg(number + 1)
            .arg(QString::fromStdString(relief::fixedText(body.radius, 2)));
    }
    if (body.kind == StepBody::Kind::Cone) return Trace3dView::tr("%1: cone of slope %2").arg(number + 1).arg(value);
    const bool ends = step.decision == relief::Decision::Start || step.decision == relief::Decision::Miss;
    if (!valueIsHeight(step)) return QString::number(number + 1);
    if (!step.atPoint()) {
        return Trace3dView::tr("%1: level %2, %3").arg(number + 1).arg(step.level).arg(value);
    }
    return ends ? QString::number(number + 1) : Trace3dView::tr("%1: surface at %2").arg(number + 1).arg(value);
}

TracePicture::TracePicture()
    : renderer_(vtkSmartPointer<vtkRenderer>::New()),
      legendRenderer_(vtkSmartPointer<vtkRenderer>::New()),
      legendActor_(vtkSmartPointer<vtkActor2D>::New()),
      legend_(vtkSmartPointer<vtkImageData>::New()) {
    renderer_->UseFXAAOn();
    // VTK 9.1 tests other translucent surfaces against the depths of a picture that is shifted by the legend's height,
    // so that they shine through the relief.
    renderer_->SetUseDepthPeeling(true);
    renderer_->SetAutomaticLightCreation(false);
    addLight(renderer_);
    const vtkNew<vtkImageMapper> mapper;
    mapper->SetInputData(legend_);
    mapper->SetColorWindow(255);
    mapper->SetColorLevel(127.5);
    legendActor_->SetMapper(mapper);
    legendRenderer_->AddActor2D(legendActor_);
}

TracePicture::~TracePicture() = default;

void TracePicture::addTo(vtkRenderWindow* window) const {
    window->AddRenderer(renderer_);
    window->AddRenderer(legendRenderer_);
}

void TracePicture::takeFrom(vtkRenderWindow* window) const {
    window->RemoveRenderer(renderer_);
    window->RemoveRenderer(legendRenderer_);
}

vtkRenderer* TracePicture::renderer() const {
    return renderer_;
}

void TracePicture::addRelief() {
    const Style& style = style_;
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
    topLabel_ = marks.words({}, Trace3dView::tr("height 1").toStdString(), Role::Label, 0.85);
    topLabel_->GetTextProperty()->SetJustificationToRight();
    renderer_->AddActor2D(topLabel_);
}

void TracePicture::placeTopLabel() {
    if (!scene_ || topLabel_ == nullptr) return;
    Place at = scene_->topLabelPlace(camera);
    topLabel_->GetPositionCoordinate()->SetValue(at.data());
}

void TracePicture::addRay() {
    const TraceMarks marks(*scene_, shown_->request->field, style_);
    renderer_->AddActor(marks.shadow());
    renderer_->AddActor(marks.ray());
    renderer_->AddActor(marks.curtain());
    const PixelTrace& trace = shown_->trace;
    vtkCamera* const eye = renderer_->GetActiveCamera();
    if (trace.hit.outcome == relief::Outcome::Hit) {
        for (const auto& part : marks.hitRing(eye, scene_->end)) renderer_->AddActor(part);
    }
    // Only if the exact hit is at another place than the method's.
    if (trace.hidden || trace.exact.outcome != relief::Outcome::Hit || trace.exact.lambda > scene_->end) return;
    if (relief::answerError(trace.hit, trace.exact, trace.ray) <= relief::kSameAnswer) return;
    for (const auto& part : marks.hitRing(eye, trace.exact.lambda)) renderer_->AddActor(part);
    const relief::Message exact(relief::MessageId::DrawExact);
    const auto words =
        marks.words(scene_->onRay(trace.exact.lambda), relief::sentence(exact, style_.language), Role::Label, 0.85);
    // Placed below, because labels of steps are above.
    words->GetTextProperty()->SetVerticalJustificationToTop();
    renderer_->AddActor2D(words);
}

void TracePicture::addWords(const QString& words) {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput(words.toUtf8().constData());
    setText(text->GetTextProperty(), style_.text(), style_.textPixels());
    text->GetTextProperty()->SetJustificationToCentered();
    text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    text->SetPosition(0.5, 0.5);
    renderer_->AddActor2D(text);
}

void TracePicture::clear(const Style& style) {
    style_ = style;
    const Rgba ground = style.background();
    for (vtkRenderer* const part : {renderer_.Get(), legendRenderer_.Get()}) {
        part->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    }
    renderer_->RemoveAllViewProps();
    stepProps_.clear();
    scene_.reset();
    topLabel_ = nullptr;
    layLegend();
}

void TracePicture::setSize(const QSize& pixels) {
    size_ = pixels;
    layLegend();
}

StepPaint TracePicture::paint() const {
    return {colors_, shown_ && shown_->maxima ? shown_->maxima->top() + 1 : 1};
}

void TracePicture::paintLegend(const Drawing& drawing, int height) {
    const double unit = style_.pixelsPerPoint();
    QImage page(size_.width(), height, QImage::Format_RGB888);
    page.fill(toColor(style_.background()));
    QPainter painter(&page);
    const Box all{0, 0, static_cast<double>(page.width()), static_cast<double>(height)};
    reliefui::paint(painter, drawing, {unit, kTraceLegendMargin * unit, kTraceLegendMargin * unit / 2}, style_, all);
    painter.end();
    legend_->SetDimensions(page.width(), height, 1);
    legend_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < height; ++y) {
        const uchar* const row = page.constScanLine(height - 1 - y);
        std::copy(row, row + 3 * page.width(), static_cast<uchar*>(legend_->GetScalarPointer(0, y, 0)));
    }
    legend_->Modified();
}

// Places the legend below the relief; it is left out if it would take too much.
void TracePicture::layLegend() {
    relief_ = 1;
    if (scene_ && !size_.isEmpty()) {
        const double unit = style_.pixelsPerPoint();
        const PixelTrace& trace = shown_->trace;
        const Drawing drawing = traceLegend(trace.steps, trace.ray, trace.hit, trace.exact, paint(),
                                            size_.width() / unit - 2 * kTraceLegendMargin, style_.language);
        const auto high = static_cast<int>(std::ceil((drawing.bounds.height() + kTraceLegendMargin) * unit));
        if (high < kMostTraceLegend * size_.height()) {
            relief_ = 1 - static_cast<double>(high) / size_.height();
            paintLegend(drawing, high);
        }
    }
    legendRenderer_->SetDraw(relief_ < 1);
    legendRenderer_->SetViewport(0, 0, 1, relief_ < 1 ? 1 - relief_ : 1);
    renderer_->SetViewport(0, 1 - relief_, 1, 1);
}

void TracePicture::forget() {
    clear(style_);
    shown_.reset();
}

void TracePicture::show(std::shared_ptr<const Snapshot> snapshot, const Style& style, double exaggeration,
                        relief::MessageId why) {
    clear(style);
    shown_ = std::move(snapshot);
    if (!shown_ || !shown_->request || !shown_->trace.onRelief) {
        if (shown_ && shown_->request) {
            why = shown_->scenario.pixel ? relief::MessageId::DrawNoRelief : relief::MessageId::DrawNoRay;
        }
        addWords(QString::fromStdString(relief::sentence(relief::Message(why), style_.language)));
        return;
    }
    scene_ = std::make_unique<TraceScene>(*shown_, exaggeration);
    layLegend();
    addRelief();
    addRay();
}

void TracePicture::addStep(const relief::Step& step, std::size_t number) {
    const Style& style = style_;
    const TraceMarks marks(*scene_, shown_->request->field, style, paint());
    for (const bool later : {false, true}) {
        stepProps_.push_back(marks.stretches(shown_->trace.steps, number, later));
    }
    if (step.lambdaOut > step.lambdaIn) stepProps_.push_back(marks.stretch(step));
    if (!step.atPoint()) {
        const TraceMarks::Prism prism = marks.prism(step, *shown_->maxima);
        stepProps_.push_back(marks.box(prism));
        stepProps_.push_back(marks.boxEdges(prism));
    }
    for (const auto& mark : bodyMarks(*scene_, *shown_, number, style, marks.radius())) {
        stepProps_.push_back(mark);
    }
    const StepBody body = stepBody(step);
    const QString words = stepWords(step, number);
    for (const auto& mark : sampleMarks(*scene_, shown_->trace.steps, number, paint(), style, marks.radius())) {
        stepProps_.push_back(mark);
    }
    stepProps_.push_back(marks.words(body ? aboveBody(*scene_, *shown_, body) : marks.labelPlace(step),
                                     words.toStdString(), Role::Label, 1));
    for (const auto& prop : stepProps_) renderer_->AddViewProp(prop);
}

void TracePicture::showStep(int step) {
    for (const auto& prop : stepProps_) renderer_->RemoveViewProp(prop);
    stepProps_.clear();
    layLegend();
    if (!scene_ || shown_->trace.steps.empty()) return;
    const auto& steps = shown_->trace.steps;
    const auto at = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
    addStep(steps[at], at);
}

void TracePicture::follow(int step) {
    if (!scene_ || shown_->trace.steps.empty()) return;
    const auto& steps = shown_->trace.steps;
    const auto at = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
    camera.setFocus(scene_->onRay(std::min(steps[at].lambdaAfter, scene_->end)));
}

void TracePicture::showAll(double room) {
    if (!scene_) return;
    const double aspect = size_.isEmpty() ? 1 : size_.width() / (relief_ * size_.height());
    scene_->fit(camera, room * aspect);
}

void TracePicture::fit(double room) {
    if (!scene_) return;
    scene_->faceRay(camera);
    showAll(room);
}

void TracePicture::place() {
    camera.apply(renderer_->GetActiveCamera());
    placeTopLabel();
    renderer_->ResetCameraClippingRange();
}

}  // namespace reliefui
