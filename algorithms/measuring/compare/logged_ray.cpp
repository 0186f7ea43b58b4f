#include "measuring/compare/logged_ray.h"

#include <cmath>
#include <limits>

#include "relief/addressing.h"
#include "relief/files.h"
#include "scenario/ray_files.h"

namespace relief {

namespace {

// Index of the texel of a step that names none: the one below the ray, which only the heights' size tells.
constexpr std::int64_t kBelowRay = std::numeric_limits<std::int64_t>::min();

StepLog answersAsSteps(const HitBlock& hits) {
    StepLog log;
    for (std::size_t r = 0; r < hits.size(); ++r) {
        const Hit hit = hits[r];
        Step step;
        step.decision = hit.outcome == Outcome::Hit    ? Decision::Hit
                        : hit.outcome == Outcome::Miss ? Decision::Miss
                                                       : Decision::Limit;
        step.i = step.j = kBelowRay;
        const double lambda = hit.outcome == Outcome::Hit ? hit.lambda : 1;
        step.lambdaIn = step.lambdaOut = step.lambdaAfter = lambda;
        step.value = 1 - lambda;
        step.subject = subject::Point{step.value};
        log.steps.push_back(step);
        log.begin.push_back(log.steps.size());
        log.reads.push_back(0);
    }
    return log;
}

// Sets the texels of steps that name none.
void nameTexels(std::vector<Step>& steps, const ViewRay& ray, const HeightField& field) {
    const auto name = [&](double at, int size) {
        return addressIndex(static_cast<std::int64_t>(std::floor(std::fmod(at, size))), size, field.address());
    };
    for (Step& step : steps) {
        if (step.i != kBelowRay) continue;
        step.i = name(ray.s0 + step.lambdaOut * ray.a, field.width());
        step.j = name(ray.t0 + step.lambdaOut * ray.b, field.height());
    }
}

}  // namespace

RayFiles readRayFiles(const OtherTracer& other) {
    RayFiles files;
    files.rays = parseRays(readTextFile(other.rays), other.rays);
    if (files.rays.size() == 0) throw InputError(other.rays, Message(MessageId::RaysNone));
    const std::string text = readTextFile(other.steps);
    if (!isHitsText(text)) {
        files.log = parseSteps(text, other.steps, files.rays.size(), &files.further);
        return files;
    }
    files.hits = parseHits(text, other.steps);
    if (files.hits->size() != files.rays.size()) {
        throw InputError(other.steps,
                         Message(MessageId::HitsCount,
                                 {{"count", files.hits->size()}, {"file", other.rays}, {"rays", files.rays.size()}}));
    }
    files.log = answersAsSteps(*files.hits);
    return files;
}

LoggedRay tracedRay(const Tracer& tracer, const ViewRay& ray, Work& work) {
    RayBlock rays;
    rays.push(ray);
    HitBlock hits;
    StepLog log;
    tracer.trace(rays, hits, log, work);
    LoggedRay out;
    out.ray = ray;
    out.hit = hits[0];
    out.steps = std::move(log.steps);
    out.reads = log.reads.front();
    return out;
}

LoggedRay rayOfFiles(const OtherTracer& other, const RayFiles& files, const HeightField& field) {
    const RayBlock& rays = files.rays;
    const StepLog& log = files.log;
    const auto number = static_cast<std::size_t>(other.ray);
    if (number >= rays.size()) {
        throw InputError(other.rays,
                         Message(MessageId::OutOfRange, {{"what", MessageId::WordRay},
                                                         {"value", number},
                                                         {"range", rangeOf<std::size_t>(0, rays.size() - 1)}}));
    }
    LoggedRay out;
    out.ray = rays[number];
    const auto first = static_cast<std::ptrdiff_t>(log.begin[number]);
    const auto end = static_cast<std::ptrdiff_t>(log.begin[number + 1]);
    out.steps.assign(log.steps.begin() + first, log.steps.begin() + end);
    for (const FurtherColumn& column : files.further) {
        out.further.push_back({column.name, {column.cells.begin() + first, column.cells.begin() + end}});
    }
    nameTexels(out.steps, out.ray, field);
    placeSteps(out.steps, out.ray, field, other.steps, number);
    out.hit = answerOf(out.steps, out.ray);
    return out;
}

void judgeAgainstExact(LoggedRay& ray, const std::string& name, const HeightField& field, MapCache& maps, Work& work) {
    RayBlock rays;
    rays.push(ray.ray);
    HitBlock hits;
    NullSink sink;
    makeTracer({kExactTracer, {}}, field, maps, work)->trace(rays, hits, sink, work);
    ray.exact = hits[0];
    ray.judgement = judge({name, ray.hit, ray.steps}, ray.exact, ray.ray, field);
}

}  // namespace relief
