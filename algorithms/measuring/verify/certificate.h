// Checks whether a map is safe under the interpolation and the stepping rule of the tracer that traverses it. There are
// two kinds of evidence:
// - values: for maps whose values are not interpolated, every value is compared with an independently computed bound
//   (certificate_bounds.h); the interpolated cones of `cone-robust`, cell by cell (engine_bounds.h). If all keep their
//   bounds, safety is proven for every ray that the map serves.
// - rays: seeded rays designed to find errors are compared with `exact`. A ray that ends past the first hit is a
//   counter-example; finding none is evidence but no proof. For other interpolated maps, and methods without a map,
//   there is no other evidence.
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

// A ray, and where it ended. answered: infinite if the ray ended as a miss.
struct CounterExample {
    ViewRay ray;
    double surface = 0;   // lambda of the first hit
    double answered = 0;  // lambda of the answer
    double texels = 0;    // distance past the first hit, slab metric; infinite for a miss
    std::string where;    // the step that went past it, with the texel or voxel and its value
};

// Returns the distance of the answer past the first hit, texels; 0 or less: not past; infinite for a miss. A step limit
// is not a wrong answer.
double texelsPast(const HeightField& field, const ViewRay& ray, const Hit& truth, const Hit& found);
// Returns the example of a ray that ended past the first hit. where: see there.
CounterExample counterExample(const HeightField& field, const ViewRay& ray, const Hit& truth, const Hit& found,
                              std::string where);
// Returns "3.5 texels", or "a miss" for infinity.
std::string texelsPastText(double texels);
// Returns two lines: the ray, then the first hit and the answer, which `answered` names.
std::string exampleText(const CounterExample& example, const char* answered);
// Rays that certificates keep in memory at a time.
inline constexpr std::uint64_t kCertificateBlock = std::uint64_t{1} << 16;

struct Certificate {
    std::string method;
    std::string map;                   // kind of the map; empty: no storable map
    std::optional<BoundCheck> bounds;  // std::nullopt: the map's values have no bound
    std::uint64_t rays = 0;
    std::uint64_t seed = 0;
    double longest = 0;  // largest run of the rays, texels
    double allowed = 0;  // tolerance past the first hit, texels
    std::uint64_t overshoots = 0;
    double worst = 0;                     // largest distance past the first hit, texels
    std::optional<CounterExample> first;  // the first of the seeded rays, or else a ray through a broken value
    // Set if no ray was found that the tracer leads past the surface: the ray, of those tried, that the broken value
    // alone would lead farthest past it (`answered`: the lambda that it leads to).
    std::optional<CounterExample> byValue;

    bool safe() const { return !first && (!bounds || bounds->broken == 0); }
    bool proven() const { return bounds && safe(); }
};

// Tolerances past the first hit, texels: 0 for exact methods, rounding for conservative ones, and half a texel for
// methods without a guarantee, so that a coarse last step does not count as an error of the map.
inline constexpr double kRoundingTexels = 1e-6;
inline constexpr double kCoarseTexels = 0.5;
// Lowest elevation of the rays, degrees, if the map serves all rays.
inline constexpr double kFlattestCertified = 2;

// Certifies the method over the field. Maps are taken from the cache if they are there, so that a stored map is
// certified as it is, and are built otherwise. The result depends only on the seed. Throws Cancelled, and InputError
// for unknown names and options.
Certificate certify(const MethodChoice& choice, const HeightField& field, const CertificateOptions& options,
                    MapCache& cache, Work& work);

// Returns what was checked, how, and the result; one fact per line.
std::string certificateText(const Certificate& certificate, const HeightField& field);

}  // namespace relief
