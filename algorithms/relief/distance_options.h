// Options that the distance methods share: how their map is built.
#pragma once

#include <vector>

#include "relief/describe.h"
#include "relief/distance_walk.h"
#include "relief/maps/distance_map.h"

namespace relief {

// A struct of options that has these members gets the described fields for them.
template <class Options>
std::vector<OptionField<Options>> distanceFields() {
    std::vector<OptionField<Options>> fields{
        {{"footprint", OptionKind::Integer, "texels", 1, 64, 1, {}, "side of a voxel's footprint"},
         &Options::footprint},
        {{"layers", OptionKind::Integer, "layers", 1, 1024, 1, {}, "how many voxels the slab is high"},
         &Options::layers},
        {{"precision", OptionKind::Choice, "", 0, 0, 0, {"float", "u16", "u8"}, "how distances are stored"},
         &Options::precision}};
    if constexpr (requires(Options o) { o.flattest; }) {
        fields.push_back({{"flattest",
                           OptionKind::Real,
                           "degrees",
                           0.5,
                           89,
                           0.5,
                           {},
                           "elevation of the flattest ray that it serves"},
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
                           "azimuth sectors in which what hides a voxel is looked for"},
                          &Options::horizons});
        fields.push_back({{"sectors",
                           OptionKind::Integer,
                           "sectors",
                           1,
                           32,
                           1,
                           {},
                           "azimuth sectors that have distances of their own (a divisor of horizons)"},
                          &Options::sectors});
    }
    if constexpr (requires(Options o) { o.directions; }) {
        fields.push_back({{"directions", OptionKind::Integer, "rays", 1, 16384, 1, {}, "sampled from each voxel"},
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
                           "a step by the distance: from where the ray leaves the voxel, or from where it is"},
                          &Options::rule});
    }
    if constexpr (requires(Options o) { o.iterations; }) {
        fields.push_back(
            {{"iterations", OptionKind::Integer, "steps", 1, 4096, 1, {}, "always that many"}, &Options::iterations});
    }
    return fields;
}

template <class Options>
StepRule stepRule(const Options& options) {
    return options.rule == "classic" ? StepRule::Classic : StepRule::Exit;
}

template <class Options>
DistanceParameters distanceParameters(const Options& options) {
    DistanceParameters parameters;
    parameters.footprint = options.footprint;
    parameters.layers = options.layers;
    parameters.precision = parsePrecision(options.precision);
    if constexpr (requires { options.flattest; }) parameters.flattest = options.flattest;
    if constexpr (requires { options.horizons; }) {
        parameters.horizons = options.horizons;
        parameters.sectors = options.sectors;
        if (options.horizons % options.sectors != 0) {
            throw InputError(
                "--set", Message(MessageId::OutOfRange,
                                 {{"what", "sectors"}, {"value", options.sectors}, {"range", "divisors of horizons"}}));
        }
    }
    if constexpr (requires { options.directions; }) parameters.directions = options.directions;
    return parameters;
}

}  // namespace relief
