#include "workspace/pixel_trace.h"

#include "measuring/compare/logged_ray.h"

namespace reliefui {

namespace {

// Copies what both have.
void take(PixelTrace& out, relief::LoggedRay ray) {
    out.onRelief = true;
    out.ray = ray.ray;
    out.hit = ray.hit;
    out.steps = std::move(ray.steps);
    out.reads = ray.reads;
    out.exact = ray.exact;
    out.judgement = ray.judgement;
    out.further = std::move(ray.further);
}

}  // namespace

std::shared_ptr<const OtherFiles> readOtherFiles(const relief::OtherTracer& other) {
    auto files = std::make_shared<OtherFiles>(OtherFiles{relief::readRayFiles(other), other, {}, {}});
    try {
        files->view = relief::readRaysView(other.rays, files->rays.size());
    } catch (const relief::InputError& error) {
        files->viewProblem = error;  // the rays and their steps can be shown without it
    }
    return files;
}

RayTraces traceRay(const relief::Scenario& scenario, const relief::FrameRequest& request, const relief::Tracer& tracer,
                   const OtherFiles* files, relief::MapCache& maps, relief::Work& work) {
    RayTraces out;
    PixelTrace own;
    if (scenario.pixel) own.pixel = *scenario.pixel;
    if (files != nullptr) {
        relief::LoggedRay logged = relief::rayOfFiles(scenario.other, *files, request.field);
        relief::judgeAgainstExact(logged, scenario.other.steps, request.field, maps, work);
        auto other = std::make_shared<PixelTrace>();
        take(*other, std::move(logged));
        other->pixel = own.pixel;
        other->fromFile = true;
        other->number = static_cast<std::size_t>(scenario.other.ray);
        own.ray = other->ray;
        own.number = other->number;
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
    relief::LoggedRay logged = relief::tracedRay(tracer, own.ray, work);
    relief::judgeAgainstExact(logged, scenario.method.name, request.field, maps, work);
    take(own, std::move(logged));
    own.baseLevel = tracer.baseLevel();
    out.shown = std::move(own);
    return out;
}

}  // namespace reliefui
