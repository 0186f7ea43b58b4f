#include "panes/trace/trace_vectors.h"
#include "panes/space_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/trace/trace3d_bodies.h"
#include "panes/trace/trace3d_marks.h"
#include "panes/trace/trace3d_picture.h"
#include "panes/trace/trace3d_samples.h"
#include "panes/trace/trace3d_view.h"
#include "panes/trace/trace_painter.h"
#include "panes/trace/tubes.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// What TracePicture::addRay() and addStep() show, translucent surfaces first.
class TraceContents {
  public:
    TraceContents(TracePainter& out, const TraceScene& scene, const Snapshot& snapshot, const Style& style,
                  const StepPaint& paint, int step)
        : out_(out),
          scene_(scene),
          snapshot_(snapshot),
          style_(style),
          steps_(snapshot.trace.steps),
          marks_(scene, snapshot.request->field, style, paint),
          chosen_(steps_.empty() ? 0
                                 : static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps_.size()) - 1))) {
        if (!steps_.empty()) samples_ = sampleShapes(scene, steps_, chosen_, paint, style, marks_.radius());
    }

    void paint() {
        out_.relief();
        surfaces();
        lines();
        labels();
    }

  private:
    Rgba bodyColor(const relief::Step& step) const {
        return style_.color(bodyRole(step, snapshot_.trace.ray, snapshot_.trace.exact));
    }
    Rgba ray() const { return style_.color(Role::Ray); }

    void surfaces() const {
        out_.surface(
            [&](double u, double v) {
                return between(scene_.underRay(u * scene_.end), scene_.onRay(u * scene_.end), v);
            },
            faded(ray(), kCurtainOpacity));
        if (steps_.empty()) return;
        const relief::Step& step = steps_[chosen_];
        if (!step.atPoint()) {
            const TraceMarks::Prism prism = marks_.prism(step, *snapshot_.maxima);
            for (const auto& face : marks_.faces(prism)) out_.quad(face, faded(prism.color, kPrismOpacity));
        }
        if (const StepBody body = stepBody(step)) {
            const BodyShape shape(scene_, snapshot_, body);
            const Rgba color = faded(bodyColor(step), kBodyOpacity);
            if (body.kind == StepBody::Kind::Sphere) {
                for (const bool far : {true, false}) out_.ball(shape, color, far);
            } else {
                const double reach = shape.reach();
                out_.surface(
                    [&](double u, double v) { return shape.onCone(v * reach, body.from + u * (body.to - body.from)); },
                    color);
            }
        }
        const Rgba advanced = style_.color(Role::Advanced);
        for (const double lambda : samples_.sheets) sheet(lambda, faded(advanced, kSheetOpacity));
        if (samples_.chosen) sheet(*samples_.chosen, faded(samples_.color, kChosenSheetOpacity));
    }
    void sheet(double lambda, Rgba color) const {
        const std::vector<Place> c = sheetCorners(scene_, lambda);
        out_.quad({c[0], c[1], c[2], c[3]}, color);
    }

    void lines() const {
        const double point = style_.pixelsPerPoint();
        const double radius = marks_.radius();
        const Box& p = scene_.patch;
        const double top = scene_.scale;
        out_.line({{p.x0, -p.y0, top}, {p.x1, -p.y0, top}, {p.x1, -p.y1, top}, {p.x0, -p.y1, top}, {p.x0, -p.y0, top}},
                  style_.color(Role::Label), 0.75 * point);
        constexpr int kSamples = 256;
        std::vector<Place> shadow;
        for (int k = 0; k <= kSamples; ++k) {
            shadow.push_back(scene_.underRay(scene_.end * k / kSamples));
            shadow.back()[2] += radius;
        }
        out_.line(shadow, ray(), 1.5 * point);
        if (!steps_.empty()) earlierBodies(radius);
        out_.tube({scene_.rayTop(), scene_.onRay(scene_.end)}, radius, ray(), true);
        if (!steps_.empty()) stepLines(radius);
        const PixelTrace& trace = snapshot_.trace;
        if (trace.hit.outcome == relief::Outcome::Hit) out_.hit(scene_.onRay(scene_.end), radius);
        if (exactElsewhere()) out_.hit(scene_.onRay(trace.exact.lambda), radius);
    }
    // The exact hit is shown only if it is at another place than the method's.
    bool exactElsewhere() const {
        const PixelTrace& trace = snapshot_.trace;
        return !trace.hidden && trace.exact.outcome == relief::Outcome::Hit && trace.exact.lambda <= scene_.end &&
               relief::answerError(trace.hit, trace.exact, trace.ray) > relief::kSameAnswer;
    }
    void earlierBodies(double radius) const {
        for (std::size_t k = firstOutline(chosen_); k < chosen_; ++k) {
            const StepBody body = stepBody(steps_[k]);
            if (!body) continue;
            for (const auto& line : BodyShape(scene_, snapshot_, body).outline()) {
                out_.tube(line, kEarlierOutline * radius, faded(bodyColor(steps_[k]), kEarlierOpacity));
            }
        }
    }
    void stepLines(double radius) const {
        const relief::Step& step = steps_[chosen_];
        for (const bool later : {true, false}) {
            for (const TraceMarks::Sleeve& s : marks_.sleeves(steps_, chosen_, later)) {
                out_.tube({s.from, s.to}, s.radius, later ? faded(s.color, kLaterOpacity) : s.color);
            }
        }
        if (step.lambdaOut > step.lambdaIn) {
            const TraceMarks::Sleeve s = marks_.sleeve(step);
            out_.tube({s.from, s.to}, s.radius, s.color);
        }
        if (!step.atPoint()) {
            const TraceMarks::Prism prism = marks_.prism(step, *snapshot_.maxima);
            for (const auto& [from, to] : marks_.edges(prism)) out_.tube({from, to}, kEdge * radius, prism.color);
        }
        if (const StepBody body = stepBody(step)) {
            for (const auto& line : BodyShape(scene_, snapshot_, body).outline()) {
                out_.tube(line, kOutline * radius, bodyColor(step));
            }
        }
        for (const double lambda : samples_.sheets) rim(lambda, kRim * radius, style_.color(Role::Advanced));
        if (samples_.chosen) rim(*samples_.chosen, kChosenRim * radius, samples_.color);
        for (const SampleShapes::Stem& stem : samples_.stems) {
            out_.tube({stem.from, stem.to}, kStem * stem.radius, stem.color);
            out_.disk(stem.to, kStemBall * stem.radius, stem.color);
        }
        if (const auto& shift = samples_.shift) {
            out_.tube({shift->from, shift->to}, shift->radius, shift->color);
            out_.disk(shift->to, 2 * shift->radius, shift->color);
        }
    }
    void rim(double lambda, double radius, Rgba color) const {
        std::vector<Place> corners = sheetCorners(scene_, lambda);
        corners.push_back(corners.front());
        out_.tube(corners, radius, color);
    }

    void labels() {
        const TraceMesh& mesh = out_.mesh();
        const Box& p = scene_.patch;
        const QString patch =
            Trace3dView::tr("Relief: %1 × %2 texels around the ray").arg(qRound(p.width())).arg(qRound(p.height()));
        const QString thinned = Trace3dView::tr("%1; one height in %2 along each side").arg(patch).arg(mesh.stride());
        out_.note((mesh.stride() > 1 ? thinned : patch).toStdString());
        if (!steps_.empty()) {
            const relief::Step& step = steps_[chosen_];
            const StepBody body = stepBody(step);
            out_.words(body ? aboveBody(scene_, snapshot_, body) : marks_.labelPlace(step),
                       stepWords(step, chosen_).toStdString(), 1, Anchor::BottomLeft);
        }
        constexpr double kSmaller = 0.85;
        if (exactElsewhere()) {
            out_.words(scene_.onRay(snapshot_.trace.exact.lambda),
                       relief::sentence(relief::Message(relief::MessageId::DrawExact), style_.language), kSmaller,
                       Anchor::TopLeft);
        }
        out_.words(topLabelPlace_, Trace3dView::tr("height 1").toStdString(), kSmaller, Anchor::Right);
        out_.paintWords();
    }

  public:
    void setTopLabel(const Place& at) { topLabelPlace_ = at; }

  private:
    TracePainter& out_;
    const TraceScene& scene_;
    const Snapshot& snapshot_;
    const Style& style_;
    const std::vector<relief::Step>& steps_;
    TraceMarks marks_;
    std::size_t chosen_;
    SampleShapes samples_;
    Place topLabelPlace_{};
};

}  // namespace

Turntable traceCamera(const TraceScene& scene, double width, double reliefHeight) {
    Turntable camera;
    scene.faceRay(camera);
    scene.fit(camera, kTraceRoom * width / reliefHeight);
    return camera;
}

double traceLegendHeight(const Drawing& legend, const Box& page, const Style& style) {
    const double high = (legend.bounds.height() + kTraceLegendMargin) * style.pixelsPerPoint();
    return high < kMostTraceLegend * page.height() ? high : 0;
}

void paintTraceVectors(QPainter& painter, const Box& page, const Style& style, const Snapshot& snapshot, int step,
                       const TraceOptions& options) {
    painter.setRenderHint(QPainter::Antialiasing, true);
    const double unit = style.pixelsPerPoint();
    const TraceScene scene(snapshot, options.exaggeration);
    const StepPaint paint{options.colors, snapshot.maxima ? snapshot.maxima->top() + 1 : 1};
    const PixelTrace& trace = snapshot.trace;
    const Drawing legend = traceLegend(trace.steps, trace.ray, trace.hit, trace.exact, paint,
                                       page.width() / unit - 2 * kTraceLegendMargin, style.language);
    const double below = traceLegendHeight(legend, page, style);
    const Box room{page.x0, page.y0, page.x1, page.y1 - below};
    Turntable camera = options.camera ? *options.camera : traceCamera(scene, room.width(), room.height());
    if (options.turn && !options.camera) {
        turnForOrbit(camera, *options.turn, [&] { scene.fit(camera, kTraceRoom * room.width() / room.height()); });
    }
    const TraceEye eye(camera, room);
    const auto fill = [&](const Box& box) {
        painter.fillRect(QRectF(box.x0, box.y0, box.width(), box.height()), toColor(style.background()));
    };
    fill(page);
    painter.save();
    painter.setClipRect(QRectF(room.x0, room.y0, room.width(), room.height()), Qt::IntersectClip);
    TracePainter out(painter, scene, eye, room, style);
    TraceContents contents(out, scene, snapshot, style, paint, step);
    contents.setTopLabel(scene.topLabelPlace(camera));
    contents.paint();
    painter.restore();
    if (below <= 0) return;
    const Box under{page.x0, room.y1, page.x1, page.y1};
    fill(under);  // formats without clips
    reliefui::paint(painter, legend,
                    {unit, page.x0 + kTraceLegendMargin * unit, room.y1 + kTraceLegendMargin * unit / 2}, style, page);
}

}  // namespace reliefui
