#include "measuring/compare/logged_ray.h"

#include "relief/files.h"
#include "scenario/ray_files.h"

namespace relief {

RayFiles readRayFiles(const OtherTracer& other) {
    RayFiles files;
    files.rays = parseRays(readTextFile(other.rays), other.rays);
    if (files.rays.size() == 0) throw InputError(other.rays, Message(MessageId::RaysNone));
    files.log = parseSteps(readTextFile(other.steps), other.steps, files.rays.size(), &files.further);
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
