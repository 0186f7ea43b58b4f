#include "workspace/pixel_trace.h"

#include "relief/files.h"
#include "scenario/ray_files.h"

namespace reliefui {

namespace {

// Gives bit for bit the results of `exact`, but is faster.
constexpr const char* kExactTracer = "max-pyramid";

void trace(PixelTrace& out, const relief::Tracer& tracer, relief::Work& work) {
    relief::RayBlock rays;
    rays.push(out.ray);
    relief::HitBlock hits;
    relief::StepLog log;
    tracer.trace(rays, hits, log, work);
    out.onRelief = true;
    out.hit = hits[0];
    out.steps = std::move(log.steps);
    out.reads = log.reads.front();
    out.baseLevel = tracer.baseLevel();
}

relief::Hit exactHit(const relief::ViewRay& ray, const relief::HeightField& field, relief::MapCache& maps,
                     relief::Work& work) {
    relief::RayBlock rays;
    rays.push(ray);
    relief::HitBlock hits;
    relief::NullSink sink;
    relief::makeTracer({kExactTracer, {}}, field, maps, work)->trace(rays, hits, sink, work);
    return hits[0];
}

void judgeIt(PixelTrace& out, const std::string& name, const relief::HeightField& field) {
    const relief::DuelRun run{name, out.hit, out.steps};
    out.judgement = relief::judge(run, out.exact, out.ray, field);
}

// The chosen ray of the files, with its steps.
std::shared_ptr<const PixelTrace> fileTrace(const relief::OtherTracer& other, const OtherFiles& files,
                                            const relief::HeightField& field) {
    const auto ray = static_cast<std::size_t>(other.ray);
    if (ray >= files.rays.size()) {
        throw relief::InputError(other.rays,
                                 relief::Message(relief::MessageId::OutOfRange,
                                                 {{"what", relief::MessageId::WordRay},
                                                  {"value", ray},
                                                  {"range", relief::rangeOf<std::size_t>(0, files.rays.size() - 1)}}));
    }
    auto out = std::make_shared<PixelTrace>();
    out->onRelief = true;
    out->fromFile = true;
    out->ray = files.rays[ray];
    const auto first = files.log.steps.begin() + static_cast<std::ptrdiff_t>(files.log.begin[ray]);
    const auto last = files.log.steps.begin() + static_cast<std::ptrdiff_t>(files.log.begin[ray + 1]);
    out->steps.assign(first, last);
    relief::placeSteps(out->steps, out->ray, field, other.steps, ray);
    out->hit = relief::answerOf(out->steps, out->ray);
    return out;
}

}  // namespace

std::shared_ptr<const OtherFiles> readOtherFiles(const relief::OtherTracer& other) {
    auto files = std::make_shared<OtherFiles>();
    files->from = other;
    files->rays = relief::parseRays(relief::readTextFile(other.rays), other.rays);
    if (files->rays.size() == 0) {
        throw relief::InputError(other.rays, relief::Message(relief::MessageId::RaysNone));
    }
    files->log = relief::parseSteps(relief::readTextFile(other.steps), other.steps, files->rays.size());
    return files;
}

RayTraces traceRay(const relief::Scenario& scenario, const relief::FrameRequest& request, const relief::Tracer& tracer,
                   const OtherFiles* files, relief::MapCache& maps, relief::Work& work) {
    RayTraces out;
    PixelTrace own;
    if (scenario.pixel) own.pixel = *scenario.pixel;
    if (files != nullptr) {
        auto other = std::make_shared<PixelTrace>(*fileTrace(scenario.other, *files, request.field));
        other->pixel = own.pixel;
        other->exact = exactHit(other->ray, request.field, maps, work);
        judgeIt(*other, scenario.other.steps, request.field);
        own.ray = other->ray;
        out.other = other;
        out.otherRays = files->rays.size();
        if (scenario.other.shown) {
            out.shown = *other;
            return out;
        }
    } else {
        if (!scenario.pixel) return out;
        const auto ray = relief::pixelRay(request, own.pixel.x, own.pixel.y);
        if (!ray) {
            out.shown = own;
            return out;
        }
        own.ray = *ray;
    }
    trace(own, tracer, work);
    own.exact = exactHit(own.ray, request.field, maps, work);
    judgeIt(own, scenario.method.name, request.field);
    out.shown = std::move(own);
    return out;
}

}  // namespace reliefui
