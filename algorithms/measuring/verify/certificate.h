// Is a map safe under the interpolation and the stepping rule of the tracer that walks it? Two kinds of answer beside
// each other:
//   values: for the conservative maps, whose values are never interpolated, every value is held against a bound
//     computed anew (certificate_bounds.h). All kept: proven, for every ray that the map serves.
//   rays: seeded rays that look for weak places, against `exact`. One that ends past the first hit is a
//   counter-example;
//     none found is evidence only. For maps that are interpolated, and methods without a map, that is all there is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "measuring/verify/certificate_bounds.h"
#include "relief/tracers.h"

namespace relief {

struct CertificateOptions {
    std::uint64_t rays = 1'000'000;
    std::uint64_t seed = 1;
};

// A ray, and where it ended. answered: infinite where the ray went on to a miss.
struct CounterExample {
    ViewRay ray;
    double surface = 0;   // lambda of the first hit
    double answered = 0;  // lambda of the answer
    double texels = 0;    // how far past, slab metric; infinite for a miss
    std::string where;    // the step that led past, with the texel or voxel and its value
};

struct Certificate {
    std::string method;
    std::string map;                   // its kind; empty: no map of the kinds that can be stored
    std::optional<BoundCheck> bounds;  // nothing: the map has no bound to be held to
    std::uint64_t rays = 0;
    std::uint64_t seed = 0;
    double longest = 0;  // the flattest of them, texels of run
    double allowed = 0;  // texels past the first hit that are not counted
    std::uint64_t overshoots = 0;
    double worst = 0;                     // texels, the largest; of rays
    std::optional<CounterExample> first;  // of the rays in their order; else one through a broken value
    // Where no ray was found that the tracer leads past the surface: one that the broken value would, were it asked
    // there (`answered`: where that leads to), the farthest of those tried.
    std::optional<CounterExample> byValue;

    bool safe() const { return !first && (!bounds || bounds->broken == 0); }
    bool proven() const { return bounds && safe(); }
};

// How far past the first hit an answer may be: exact methods not at all, conservative ones by rounding, those that
// promise nothing by half a texel, so that a coarse last step is not taken for a hole in the map.
inline constexpr double kRoundingTexels = 1e-6;
inline constexpr double kCoarseTexels = 0.5;
// Degrees below which no ray is tried if the map serves all.
inline constexpr double kFlattestCertified = 2;

// Builds the maps (from the cache if they are there: a stored one is certified as it is). The result hangs on the
// seed alone. Throws Cancelled, InputError for unknown names and options.
Certificate certify(const MethodChoice& choice, const HeightField& field, const CertificateOptions& options,
                    MapCache& cache, Work& work);

// What was checked, how, and what came out; one fact a line.
std::string certificateText(const Certificate& certificate, const HeightField& field);

}  // namespace relief
