#include "measuring/bench/bench_tracers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "measuring/bench/machine.h"
#include "measuring/overshoot.h"
#include "measuring/quantiles.h"
#include "measuring/random_rays.h"
#include "relief/memory.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// The time of the reference is estimated from every kSampleEvery-th ray; no block is made smaller than kFewestRays.
constexpr std::size_t kSampleEvery = 64;
constexpr std::size_t kFewestRays = 256;

constexpr std::uint64_t kAzimuth = 1;
constexpr std::uint64_t kRandomRays = 2;

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Returns the quantile by nearest rank: the value that this share of all values does not exceed; NaN if there are no
// values. Sorts its copy.
template <class T>
double nearestRank(std::vector<T>& values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    const std::size_t at = std::max<std::size_t>(rank, 1) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return static_cast<double>(values[at]);
}

template <class T>
double mean(const std::vector<T>& values) {
    double sum = 0;
    for (const T value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

RayBlock viewRays(const HeightField& field, double degrees, std::size_t count, std::uint64_t seed) {
    const double azimuth = Random(seedFor(seed, kAzimuth)).between(0, 2 * std::numbers::pi);
    const double elevation = degrees * std::numbers::pi / 180;
    const double run = degrees >= 90 ? 0 : field.slabTexels() / std::tan(elevation);
    const double forwardS = std::cos(azimuth);
    const double forwardT = std::sin(azimuth);
    // The picture has the aspect 4 : 3.
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count) * 4 / 3)));
    const double across = static_cast<double>(field.width()) / static_cast<double>(columns);
    const double along = across / std::sin(elevation);
    const auto inside = [](double x, int size) {
        const double rest = x - std::floor(x / size) * size;
        return rest < size ? rest : 0.0;
    };
    RayBlock rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = (static_cast<double>(i % columns) + 0.5) * across;
        const double y = (static_cast<double>(i / columns) + 0.5) * along;
        rays.set(i, {inside(y * forwardS - x * forwardT, field.width()),
                     inside(y * forwardT + x * forwardS, field.height()), run * forwardS, run * forwardT});
    }
    return rays;
}

// A method built over one map.
struct Ready {
    MethodChoice choice;
    Form form{};  // as requested in the MeasuredMethod
    std::unique_ptr<MapCache> maps;
    std::unique_ptr<Tracer> tracer;
    double buildSeconds = 0;
};

using ReadyTracers = std::shared_ptr<const std::vector<Ready>>;

}  // namespace

struct PreparedTracers {
    std::shared_ptr<const void> heights;  // HeightField::identity()
    Surface surface{};
    Address address{};
    double reliefDepth = 0;
    int threads = 0;
    ReadyTracers tracers;

    bool fits(const HeightField& field, int workers, const std::vector<const MeasuredMethod*>& methods) const {
        if (heights != field.identity() || surface != field.surface() || address != field.address() ||
            reliefDepth != field.reliefDepth() || threads != workers || tracers->size() != methods.size()) {
            return false;
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
            if ((*tracers)[m].choice != methods[m]->choice || (*tracers)[m].form != methods[m]->form) return false;
        }
        return true;
    }
};

namespace {

class Bench {
  public:
    Bench(const BenchOptions& options, Work& work) : options_(options), work_(work) {
        for (const MeasuredMethod& method : options.methods) {
            if (method.supports(options.surface, options.address)) {
                methods_.push_back(&method);
            } else {
                note(Message(MessageId::BenchWithout,
                             {{"method", method.choice.name}, {"surface", std::string(surfaceName(options.surface))}}));
            }
        }
    }

    std::vector<BenchRow> run() {
        const std::size_t cells = options_.maps.size() * options_.elevations.size() * methods_.size();
        work_.progress().begin("bench", static_cast<std::int64_t>(cells) * (options_.rounds + 2));
        for (const BenchMap& map : options_.maps) {
            const HeightField field = fieldOf(map);
            const ReadyTracers ready = prepared(field);
            for (const Elevation& elevation : options_.elevations) measure(map, field, elevation, *ready);
        }
        return std::move(rows_);
    }

  private:
    void note(const Message& message) const {
        if (options_.onNote) options_.onNote(message);
    }

    HeightField fieldOf(const BenchMap& map) const {
        if (map.tiles) return {map.tiles, options_.surface, options_.address, options_.reliefDepth};
        return {map.heights, options_.surface, options_.address, options_.reliefDepth};
    }

    ReadyTracers prepared(const HeightField& field) {
        const int threads = work_.threads().size();
        PreparedTracers* kept = options_.prepared.get();
        if (kept != nullptr && kept->fits(field, threads, methods_)) return kept->tracers;
        // The maps of two height maps may not fit into memory together.
        if (kept != nullptr) *kept = {};
        auto made = std::make_shared<const std::vector<Ready>>(make(field));
        if (kept != nullptr) {
            *kept = {field.identity(), field.surface(), field.address(), field.reliefDepth(), threads, made};
        }
        return made;
    }

    // Every method gets maps of its own, so that its building time is complete.
    std::vector<Ready> make(const HeightField& field) {
        std::vector<Ready> all;
        for (const MeasuredMethod* method : methods_) {
            Ready ready{method->choice, method->form, std::make_unique<MapCache>(), nullptr, 0};
            const auto begun = Clock::now();
            ready.tracer = method->make(field, *ready.maps, work_);
            ready.buildSeconds = secondsSince(begun);
            all.push_back(std::move(ready));
        }
        return all;
    }

    // Returns the rays of a cell of the benchmark; fewer than requested if `exact` would visit too many cells of the
    // relief.
    RayBlock chosenRays(const BenchMap& map, const HeightField& field, Elevation elevation, const Tracer& exact) {
        RayBlock rays = benchRays(field, elevation, options_.rays, options_.seed, options_.lowestRandom);
        RayBlock sample;
        for (std::size_t i = 0; i < rays.size(); i += kSampleEvery) sample.push(rays[i]);
        HitBlock hits;
        BlockCounts counts;
        exact.trace(sample, hits, counts, work_);
        const double each = static_cast<double>(counts.steps) / static_cast<double>(sample.size());
        const auto affordable =
            static_cast<std::size_t>(std::clamp(options_.referenceCells / std::max(each, 1.0), 1.0, 1e15));
        const std::size_t count = std::min(options_.rays, std::max(affordable, kFewestRays));
        if (count == options_.rays) return rays;
        note(Message(MessageId::BenchFewerRays, {{"relief", map.name},
                                                 {"elevation", elevationText(elevation)},
                                                 {"count", count},
                                                 {"wanted", options_.rays}}));
        return benchRays(field, elevation, count, options_.seed, options_.lowestRandom);
    }

    void measure(const BenchMap& map, const HeightField& field, Elevation elevation, const std::vector<Ready>& ready) {
        MapCache none;
        const auto exact = makeTracer({"exact", {}}, field, none, work_);
        const RayBlock rays = chosenRays(map, field, elevation, *exact);
        HitBlock truth;
        NullSink null;
        if (options_.pass != BenchPass::Times) exact->trace(rays, truth, null, work_);
        std::vector<BenchRow> rows;
        for (const Ready& method : ready) rows.push_back(counted(map, field, elevation, method, rays, truth));
        const bool timed = options_.pass != BenchPass::Counts;
        const auto rates = timed ? measuredRates(ready, rays) : std::vector<std::vector<double>>();
        for (std::size_t m = 0; m < rows.size(); ++m) {
            if (timed) {
                rows[m].rate = quantile(rates[m], 0.5);
                rows[m].spread = (quantile(rates[m], 0.75) - quantile(rates[m], 0.25)) / rows[m].rate;
            }
            if (options_.onRow) options_.onRow(rows[m]);
            rows_.push_back(std::move(rows[m]));
        }
    }

    // Measures everything except the rate.
    BenchRow counted(const BenchMap& map, const HeightField& field, Elevation elevation, const Ready& ready,
                     const RayBlock& rays, const HitBlock& truth) {
        BenchRow row;
        row.height = map.name;
        row.width = field.width();
        row.heightTexels = field.height();
        row.surface = field.surface();
        row.address = field.address();
        row.reliefDepth = field.reliefDepth();
        row.method = ready.choice;
        row.form = ready.tracer->form();
        row.elevation = elevation;
        row.seed = options_.seed;
        row.threads = work_.threads().size();
        row.memoryBytes = static_cast<std::int64_t>(ready.tracer->bytes());
        row.buildSeconds = ready.buildSeconds;
        row.compiler = compilerText();
        row.cpu = cpuText();
        row.commit = commitText();
        if (options_.pass == BenchPass::Times) return row;
        HitBlock hits;
        BlockCounts counts;
        ready.tracer->trace(rays, hits, counts, work_);
        work_.progress().advance();
        row.errors = tracerErrors(rays, truth, hits);
        row.stepsMean = mean(hits.steps);
        row.readsMean = mean(hits.reads);
        row.stepsMax = *std::max_element(hits.steps.begin(), hits.steps.end());
        row.stepsP95 = static_cast<std::int64_t>(nearestRank(hits.steps, 0.95));
        return row;
    }

    // Returns rays per second, by method and round.
    std::vector<std::vector<double>> measuredRates(const std::vector<Ready>& ready, const RayBlock& rays) {
        std::vector<std::vector<double>> rates(ready.size());
        for (int round = -1; round < options_.rounds; ++round) {
            for (std::size_t m = 0; m < ready.size(); ++m) {
                HitBlock hits;
                hits.resize(rays.size());
                NullSink null;
                const auto begun = Clock::now();
                ready[m].tracer->trace(rays, hits, null, work_);
                // A clock that did not advance must not make a rate infinite.
                const double seconds = std::max(secondsSince(begun), 1e-9);
                if (round >= 0) rates[m].push_back(static_cast<double>(rays.size()) / seconds);
                work_.progress().advance();
            }
        }
        return rates;
    }

    const BenchOptions& options_;
    Work& work_;
    std::vector<const MeasuredMethod*> methods_;
    std::vector<BenchRow> rows_;
};

}  // namespace

std::shared_ptr<PreparedTracers> noPreparedTracers() {
    return std::make_shared<PreparedTracers>();
}

Elevation parseElevation(const std::string& text, const std::string& option) {
    if (text == "random") return std::nullopt;
    const InputError fault(option, Message(MessageId::NotAnElevation, {{"text", text}, {"low", kLowestElevation}}));
    double degrees = 0;
    try {
        degrees = parseNumber(text, option);
    } catch (const InputError&) {
        throw fault;
    }
    if (degrees < kLowestElevation || degrees > 90) throw fault;
    return degrees;
}

std::string elevationText(Elevation elevation) {
    return elevation ? numberText(*elevation) : "random";
}

RayBlock benchRays(const HeightField& field, Elevation elevation, std::size_t count, std::uint64_t seed,
                   double lowestRandom) {
    // The rays, their exact hits, and those of one method.
    requireMemory(byteProduct({count, RayBlock::kBytes + 2 * HitBlock::kBytes}), "--rays");
    return elevation ? viewRays(field, *elevation, count, seed)
                     : randomRays(seedFor(seed, kRandomRays), field, count, lowestRandom);
}

TracerErrors tracerErrors(const RayBlock& rays, const HitBlock& truth, const HitBlock& hits) {
    TracerErrors errors;
    std::vector<double> distances;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool hit = hits.outcome[i] == Outcome::Hit;
        if (hits.outcome[i] != truth.outcome[i]) ++errors.wrongOutcome;
        if (truth.outcome[i] != Outcome::Hit) continue;
        if (overshoots(hits[i], truth[i])) ++errors.overshoots;
        if (!hit) continue;
        distances.push_back(std::abs(hits.lambda[i] - truth.lambda[i]) *
                            std::max(1.0, std::hypot(rays.a[i], rays.b[i])));
    }
    errors.mean = mean(distances);  // NaN if there are no values
    errors.p95 = nearestRank(distances, 0.95);
    errors.p9999 = nearestRank(distances, 0.9999);
    errors.max = nearestRank(distances, 1);
    return errors;
}

std::vector<BenchRow> benchTracers(const BenchOptions& options, Work& work) {
    return Bench(options, work).run();
}

}  // namespace relief
