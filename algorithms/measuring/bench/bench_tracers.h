// Run time against error: methods x maps x elevations, each cell measured against `exact` on the same rays.
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
inline constexpr double kLowestRandomElevation = 1;  // of random rays, unless told otherwise

struct BenchMap {
    std::string name;
    std::shared_ptr<const FloatImage> heights;
};

// From which direction the relief is seen. Degrees above the plane: the pixels of a view, row after row, from that
// elevation and an azimuth of the seed; pixels are as far apart as shows the picture once across, along the view
// 1 / sin(elevation) times that; entries outside the picture are moved in by whole pictures. Random (no number): entry,
// azimuth and elevation (from the lowest given to 90 degrees) uniform.
using Elevation = std::optional<double>;
// "80", "random"; InputError naming the option.
Elevation parseElevation(const std::string& text, const std::string& option);
std::string elevationText(Elevation elevation);
RayBlock benchRays(const HeightField& field, Elevation elevation, std::size_t count, std::uint64_t seed,
                   double lowestRandom = kLowestRandomElevation);

// Of one method's answers beside those of `exact`, over one block of rays.
struct TracerErrors {
    // |lambda difference| x max(1, hypot(a, b)), texels, where both hit; NaN where that is nowhere. Percentiles by the
    // nearest rank.
    double mean = 0, p95 = 0, p9999 = 0, max = 0;
    std::int64_t wrongOutcome = 0;  // rays whose outcome differs
    std::int64_t overshoots = 0;    // hits later than exact's, and misses where exact hits
};
TracerErrors tracerErrors(const RayBlock& rays, const HitBlock& truth, const HitBlock& hits);

// One line of the table; units as the columns of files have them.
struct BenchRow {
    std::string height;
    int width = 0, heightTexels = 0;
    Surface surface{};
    Address address{};
    double reliefDepth = 0;
    MethodChoice method;
    Form form{};  // what the rate is of
    Elevation elevation;
    std::uint64_t seed = 0;
    int threads = 0;
    double rate = 0;    // rays a second, median of the rounds
    double spread = 0;  // (p75 - p25) / median
    TracerErrors errors;
    double stepsMean = 0;
    std::int64_t stepsP95 = 0, stepsMax = 0;
    double readsMean = 0;
    std::int64_t memoryBytes = 0;  // maps beside the heights
    double buildSeconds = 0;
    std::string compiler, cpu, commit;
};

using BenchColumn = BenchColumnOf<BenchRow>;
// height,size,surface,address,relief_depth,method,form,options,elevation,seed,threads,rate,spread,error_mean,error_p95,
// error_p9999,error_max,wrong_outcome,overshoots,steps_mean,steps_p95,steps_max,reads_mean,memory_bytes,build_seconds,
// compiler,cpu,commit
const std::vector<BenchColumn>& benchColumns();

std::string benchCsvHeader();                      // with "\n"
std::string benchCsvLine(const BenchRow& row);     // fields with commas or quotes are quoted; no number: empty
std::string benchJson(std::span<const BenchRow>);  // an array of objects with the same numbers; no number: null
// For people: a block for each map and elevation, a line for each method.
std::string benchText(std::span<const BenchRow> rows);

// Tracers over one map, made; kept between calls that measure the same methods over it, so that its maps are built
// once.
struct PreparedTracers;
std::shared_ptr<PreparedTracers> nothingPrepared();

struct BenchOptions {
    std::vector<BenchMap> maps;
    std::vector<MeasuredMethod> methods;  // those that do not know the surface are left out, with a note
    std::vector<Elevation> elevations{80.0, 60.0, 25.0, 8.0, 2.0, std::nullopt};
    double lowestRandom = kLowestRandomElevation;  // degrees
    std::size_t rays = 65536;
    int rounds = 5;  // over all methods in turn, so that what else the machine does hits all alike
    BenchPass pass = BenchPass::Both;
    std::uint64_t seed = 1;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    double reliefDepth = 0.1;
    // Cells that `exact` may visit for one block of rays; where it would be more there are fewer rays, with a note.
    double referenceCells = 4e8;
    std::function<void(const BenchRow&)> onRow;
    std::function<void(const Message&)> onNote;
    std::shared_ptr<PreparedTracers> prepared = nullptr;  // taken where it fits, and left as the last map needed it
};

// Rates with the null sink, after a round to warm up; counts and errors in a pass of their own. Throws Cancelled.
std::vector<BenchRow> benchTracers(const BenchOptions& options, Work& work);

}  // namespace relief
