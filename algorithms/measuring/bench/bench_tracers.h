// Benchmark of the tracers, run time against error: methods x maps x elevations, each cell measured against `exact` on
// the same rays.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measuring/bench/bench_columns.h"
#include "measuring/bench/measured_method.h"

namespace relief {

inline constexpr double kLowestElevation = 0.1;      // degrees
inline constexpr double kLowestRandomElevation = 1;  // default lower limit for random rays, degrees

struct BenchMap {
    std::string name;
    std::shared_ptr<const FloatImage> heights;
    std::shared_ptr<const TiledHeights> tiles = nullptr;  // in place of heights, for a map that is read by tiles
};

// The direction from which the relief is seen. A number: the pixels of a view, row by row, from that elevation in
// degrees above the plane, with an azimuth that depends on the seed. The distance of pixels is such that the view shows
// the picture once across; along the view it is 1 / sin(elevation) times that. Entries outside the picture are moved
// into it by whole periods. std::nullopt ("random"): entry, azimuth and elevation (from a lower limit to 90 degrees)
// are uniform.
using Elevation = std::optional<double>;
// Parses "80" or "random". Throws InputError naming the option.
Elevation parseElevation(const std::string& text, const std::string& option);
std::string elevationText(Elevation elevation);
// Returns the rays of a view. lowestRandom: lowest elevation of random rays, degrees. Throws MemoryError.
RayBlock benchRays(const HeightField& field, Elevation elevation, std::size_t count, std::uint64_t seed,
                   double lowestRandom = kLowestRandomElevation);

// Errors of one method's answers relative to those of `exact`, over one block of rays.
struct TracerErrors {
    // |lambda difference| x max(1, hypot(a, b)), texels, over rays where both hit; NaN if there are none. Percentiles
    // by the nearest rank.
    double mean = 0, p95 = 0, p9999 = 0, max = 0;
    std::int64_t wrongOutcome = 0;  // rays whose outcome differs
    std::int64_t overshoots = 0;    // hits behind the exact hit, and misses where exact hits
};
// Compares hits with the exact ones of the same rays.
TracerErrors tracerErrors(const RayBlock& rays, const HitBlock& truth, const HitBlock& hits);

// A row of the table; units as in the columns of files.
struct BenchRow {
    std::string height;
    int width = 0, heightTexels = 0;
    Surface surface{};
    Address address{};
    double reliefDepth = 0;
    MethodChoice method;
    Form form{};  // the implementation whose rate was measured
    Elevation elevation;
    std::uint64_t seed = 0;
    int threads = 0;
    double rate = 0;    // rays per second, median of the rounds
    double spread = 0;  // (p75 - p25) / median
    TracerErrors errors;
    double stepsMean = 0;
    std::int64_t stepsP95 = 0, stepsMax = 0;
    double readsMean = 0;
    std::int64_t memoryBytes = 0;  // of maps, without the heights
    double buildSeconds = 0;
    std::string compiler, cpu, commit;
};

using BenchColumn = BenchColumnOf<BenchRow>;
// The columns:
// height,size,surface,address,relief_depth,method,form,options,elevation,seed,threads,rate,spread,error_mean,error_p95,
// error_p9999,error_max,wrong_outcome,overshoots,steps_mean,steps_p95,steps_max,reads_mean,memory_bytes,build_seconds,
// compiler,cpu,commit
const std::vector<BenchColumn>& benchColumns();

std::string benchCsvHeader();                      // with "\n"
std::string benchCsvLine(const BenchRow& row);     // fields with commas or quotes are quoted; NaN: empty
std::string benchJson(std::span<const BenchRow>);  // an array of objects with the same values; NaN: null
// Text table with a block for each map and elevation and a line for each method.
std::string benchText(std::span<const BenchRow> rows);

// Tracers built over one map. Kept between calls that measure the same methods over it, so that its maps are built only
// once.
struct PreparedTracers;
// Returns an empty PreparedTracers for BenchOptions::prepared.
std::shared_ptr<PreparedTracers> noPreparedTracers();

struct BenchOptions {
    std::vector<BenchMap> maps;
    std::vector<MeasuredMethod> methods;  // methods that do not support the surface are left out, with a note
    std::vector<Elevation> elevations{80.0, 60.0, 25.0, 8.0, 2.0, std::nullopt};
    double lowestRandom = kLowestRandomElevation;  // lowest elevation of random rays, degrees
    std::size_t rays = 65536;
    int rounds = 5;  // each round runs all methods in turn, so that other load on the machine affects all alike
    BenchPass pass = BenchPass::Both;
    std::uint64_t seed = 1;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    double reliefDepth = 0.1;
    // Limit on the number of cells that `exact` visits for one block of rays; if it is exceeded, fewer rays are used,
    // with a note.
    double referenceCells = 4e8;
    std::function<void(const BenchRow&)> onRow;
    std::function<void(const Message&)> onNote;
    // used if it fits the map and methods, and replaced by the last map's tracers
    std::shared_ptr<PreparedTracers> prepared = nullptr;
};

// Measures rates with the null sink, after a warm-up round, and counts and errors in a separate pass. Throws Cancelled.
std::vector<BenchRow> benchTracers(const BenchOptions& options, Work& work);

}  // namespace relief
