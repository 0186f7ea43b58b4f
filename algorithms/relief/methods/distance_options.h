// The options that the distance methods share: how their map is built.
#pragma once

#include <algorithm>
#include <vector>

#include "relief/describe.h"
#include "relief/maps/distance_map.h"
#include "relief/methods/distance_march.h"
#include "relief/methods/distance_walk.h"
#include "relief/methods/max_pyramid.h"

namespace relief {

// The options of a refined map, which a method that may trace with another map has in vain without it.
inline constexpr const char* kRefinedOptions[]{"flattest", "horizons", "sectors"};

// Describes the fields of those of these members that the struct of options has.
template <class Options>
std::vector<OptionField<Options>> distanceFields() {
    std::vector<OptionField<Options>> fields{
        {{"footprint", OptionKind::Integer, "texels", 1, 64, 1, {}, "side of a voxel's footprint"},
         &Options::footprint},
        {{"layers", OptionKind::Integer, "layers", 1, 1024, 1, {}, "number of voxel layers in the slab"},
         &Options::layers},
        {{"precision", OptionKind::Choice, "", 0, 0, 0, {"float", "u16", "u8"}, "storage format of the distances"},
         &Options::precision}};
    if constexpr (requires(Options o) { o.flattest; }) {
        fields.push_back({{"flattest",
                           OptionKind::Real,
                           "degrees",
                           0.5,
                           89,
                           0.5,
                           {},
                           "lowest elevation of the rays for which the map is valid"},
                          &Options::flattest});
    }
    if constexpr (requires(Options o) { o.horizons; }) {
        fields.push_back({{"horizons",
                           OptionKind::Integer,
                           "sectors",
                           4,
                           32,
                           4,
                           {},
                           "number of azimuth sectors in which the occluders of a voxel are searched"},
                          &Options::horizons});
        fields.push_back({{"sectors",
                           OptionKind::Integer,
                           "sectors",
                           1,
                           32,
                           1,
                           {},
                           "number of azimuth sectors with separate distances (a divisor of horizons)"},
                          &Options::sectors});
    }
    if constexpr (requires(Options o) { o.directions; }) {
        fields.push_back(
            {{"directions", OptionKind::Integer, "rays", 1, 16384, 1, {}, "number of rays sampled from each voxel"},
             &Options::directions});
    }
    if constexpr (requires(Options o) { o.rule; }) {
        fields.push_back({{"rule",
                           OptionKind::Choice,
                           "",
                           0,
                           0,
                           0,
                           {"exit", "classic"},
                           "start of a step by the stored distance. exit: where the ray leaves the voxel; classic: the "
                           "ray's current point"},
                          &Options::rule});
    }
    if constexpr (requires(Options o) { o.stop; }) {
        fields.push_back(
            {{"stop",
              OptionKind::Choice,
              "",
              0,
              0,
              0,
              {"surface", "distance", "never"},
              "end of the march: at the surface, where the distance is below `within`, or only after all iterations"},
             &Options::stop});
        fields.push_back({{"within",
                           OptionKind::Real,
                           "texels",
                           0,
                           4,
                           0.01,
                           {},
                           "distance below which stop=distance ends the march"},
                          &Options::within});
        fields.push_back({{"iterations",
                           OptionKind::Integer,
                           "steps",
                           1,
                           4096,
                           1,
                           {},
                           "largest number of steps (stop=never takes all of them)"},
                          &Options::iterations});
    }
    if constexpr (requires(Options o) { o.to; }) {
        fields.push_back({{"to",
                           OptionKind::Choice,
                           "",
                           0,
                           0,
                           0,
                           {"surface", "voxel"},
                           "target of the Euclidean distances: the surface, or the centre of the nearest solid voxel"},
                          &Options::to});
    }
    if constexpr (requires(Options o) { o.map; }) {
        fields.push_back(
            {{"map", OptionKind::Choice, "", 0, 0, 0, Options::maps(), "map used for tracing"}, &Options::map});
    }
    if constexpr (requires(Options o) { o.map, o.horizons; }) {
        for (OptionField<Options>& field : fields) {
            if (std::ranges::count(kRefinedOptions, field.description.name) > 0) {
                field.description.help += "; needs map=refined";
            }
        }
    }
    return fields;
}

template <class Options>
StepRule stepRule(const Options& options) {
    return options.rule == "classic" ? StepRule::Classic : StepRule::Exit;
}

// Checks the options that depend on each other. Throws InputError naming the subject.
template <class Options>
void checkTogether(const Options& options, const std::string& subject) {
    if constexpr (requires { options.map; }) {
        const Options standard;
        for (const OptionField<Options>& field : Options::fields()) {
            const std::string& name = field.description.name;
            if (options.map == "refined" || std::ranges::count(kRefinedOptions, name) == 0) continue;
            if (optionText(field, options) == optionText(field, standard)) continue;
            const Message why(MessageId::NeedsArgument, {{"other", "map=refined"}});
            throw InputError(subject, Message(MessageId::SubjectSays, {{"subject", name}, {"why", why}}));
        }
    }
    if (options.horizons % options.sectors != 0) {
        const Message range(MessageId::RangeDivisors, {{"horizons", options.horizons}});
        throw InputError(subject, Message(MessageId::OutOfRange,
                                          {{"what", "sectors"}, {"value", options.sectors}, {"range", range}}));
    }
}

// The parameters of a map of the given kind. Options that the kind does not use keep their defaults.
template <class Options>
DistanceParameters distanceParameters(DistanceKind kind, const Options& options) {
    const bool refined = kind == DistanceKind::Refined;
    const bool sampled = kind == DistanceKind::RefinedSampled;
    DistanceParameters parameters;
    parameters.footprint = options.footprint;
    parameters.layers = options.layers;
    parameters.precision = parsePrecision(options.precision);
    if constexpr (requires { options.flattest; }) {
        if (refined || sampled) parameters.flattest = options.flattest;
    }
    if constexpr (requires { options.horizons; }) {
        if (refined) parameters.horizons = options.horizons, parameters.sectors = options.sectors;
    }
    if constexpr (requires { options.directions; }) {
        if (sampled) parameters.directions = options.directions;
    }
    if constexpr (requires { options.to; }) {
        if (kind == DistanceKind::Euclidean) parameters.to = parseDistanceTo(options.to);
    }
    return parameters;
}

// Traces the rays from which sampled maps are built, by the max pyramid; keeps its maps alive.
inline ExactHits exactHits(const HeightField& field, Work& work) {
    MapCache own;
    return [tracer = std::make_shared<const MaxPyramidTracer>(MaxPyramidTracer::make(field, {}, own, work))](
               const RayBlock& rays, HitBlock& hits) {
        hits.resize(rays.size());
        tracer->traceSimd(rays, 0, rays.size(), hits);
    };
}

// Takes the map that the options describe from the cache, or builds it.
template <class Options>
std::shared_ptr<const DistanceMap> distanceMapOf(DistanceKind kind, const Options& options, const HeightField& field,
                                                 MapCache& cache, Work& work) {
    return distanceMap(kind, distanceParameters(kind, options), field, cache, work, &exactHits);
}

template <class Options>
MarchEnd marchEnd(const Options& options) {
    if (options.stop == "never") return {MarchStop::Never, 0};
    if (options.stop == "distance") return {MarchStop::Distance, options.within};
    return {MarchStop::Surface, 0};
}

}  // namespace relief
