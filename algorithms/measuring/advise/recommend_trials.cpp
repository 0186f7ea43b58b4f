#include "measuring/advise/recommend_trials.h"

#include <ctime>

#include <algorithm>
#include <cmath>
#include <new>

#include "measuring/advise/build_watch.h"
#include "measuring/random_rays.h"
#include "relief/tracers/map_choice.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// Rays of a block, which is traced on the calling thread: enough for any vector width, too few to be divided among
// threads.
constexpr std::size_t kBlockRays = 1024;
constexpr std::size_t kFewestRays = 64;
// Limit on the number of cells that `exact` visits to compute all reference answers.
constexpr double kTruthCells = 3e8;
constexpr std::size_t kSampleEvery = 64;

// Processor time of this thread: other processes affect it only through shared caches.
double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Returns true for options that change only the traversal and not the map that is built.
bool keepsMap(const std::string& name) {
    return name == "iterations" || name == "rule" || name == "bisections" || name == "level";
}

// Returns the same text for methods that trace with the same map; empty: without a map.
std::string mapKey(const MethodChoice& method) {
    if (const auto inner = innerMethod(method)) return mapKey(*inner);
    const MethodDescription& description = findTracer(method.name);
    if (description.maps.empty()) return {};
    std::string key = description.maps.front();
    for (const auto& [name, value] : method.options) {
        if (!keepsMap(name)) key += ":" + name + "=" + value;
    }
    return key;
}

// Side of the piece from which building time and memory are estimated.
constexpr int kPieceSide = 64;

// Returns one of every kEvery runs of neighbouring pixels of a picture, so that the rays cover the whole map and
// packets still consist of neighbouring rays.
RayBlock blockRays(const AdviceOptions& options, Elevation view, std::size_t count, std::uint64_t seed) {
    constexpr std::size_t kRun = 32;
    constexpr std::size_t kEvery = 64;
    const RayBlock picture = benchRays(options.field, view, count * kEvery, seed);
    RayBlock rays;
    for (std::size_t i = 0; i < picture.size() && rays.size() < count; ++i) {
        if (i / kRun % kEvery == kEvery / 2) rays.push(picture[i]);
    }
    return rays;
}

// Returns how many of a block's rays `exact` can trace within kTruthCells, given this number of views.
std::size_t affordableRays(const Tracer& exact, const RayBlock& rays, std::size_t views, Work& work) {
    RayBlock sample;
    for (std::size_t i = 0; i < rays.size(); i += kSampleEvery) sample.push(rays[i]);
    HitBlock hits;
    BlockCounts counts;
    exact.trace(sample, hits, counts, work);
    const double each = std::max(1.0, static_cast<double>(counts.steps) / static_cast<double>(sample.size()));
    const double affordable = kTruthCells / static_cast<double>(views * AdviceRays::kBlocks) / each;
    return static_cast<std::size_t>(
        std::clamp(affordable, static_cast<double>(kFewestRays), static_cast<double>(rays.size())));
}

}  // namespace

HeightField middlePiece(const HeightField& field, int side) {
    const int width = std::min(side, field.width()), height = std::min(side, field.height());
    auto heights = std::make_shared<FloatImage>(width, height);
    const int x0 = (field.width() - width) / 2;
    const int y0 = (field.height() - height) / 2;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) (*heights)(x, y) = field.texel(x0 + x, y0 + y);
    }
    return {heights, field.surface(), field.address(), field.slabTexels() / width};
}

AdviceRays::AdviceRays(const AdviceOptions& options, std::uint64_t seed, Work& work) : options_(options) {
    MapCache none;
    const auto exact = makeTracer({"exact", {}}, options.field, none, work);
    NullSink null;
    for (std::size_t v = 0; v < options.views.size(); ++v) {
        views_.emplace_back(kBlocks);
        for (std::size_t b = 0; b < kBlocks; ++b) {
            const std::uint64_t blockSeed = seedFor(seed, v * kBlocks + b + 1);
            RayBlock rays = blockRays(options, options.views[v], kBlockRays, blockSeed);
            const std::size_t affordable = affordableRays(*exact, rays, options.views.size(), work);
            if (affordable < rays.size()) {
                rays = blockRays(options, options.views[v], affordable, blockSeed);
            }
            Block& block = views_.back()[b];
            block.rays = std::move(rays);
            exact->trace(block.rays, block.truth, null, work);
        }
    }
}

void AdviceRays::count(AdviceTrial& trial, std::size_t blocks, Work& work) const {
    AdvisedForm& facts = trial.facts;
    std::size_t rays = 0;
    std::size_t beyond = 0;
    std::size_t over = 0;
    BlockCounts counts;
    trial.blocks = blocks;
    facts.largest = 0;
    facts.mostSteps = 0;
    for (const auto& view : views_) {
        for (std::size_t b = 0; b < blocks; ++b) {
            const Block& block = view[b];
            HitBlock hits;
            trial.tracer->trace(block.rays, hits, counts, work);
            rays += block.rays.size();
            for (std::size_t i = 0; i < block.rays.size(); ++i) {
                const auto steps = static_cast<std::int64_t>(hits.steps[i]);
                facts.mostSteps = std::max(facts.mostSteps, steps);
                if (options_.maxSteps > 0 && steps > options_.maxSteps) ++over;
                if (hits.outcome[i] != block.truth.outcome[i]) {
                    ++beyond;
                    continue;
                }
                if (hits.outcome[i] != Outcome::Hit) continue;
                const double error = std::abs(hits.lambda[i] - block.truth.lambda[i]) *
                                     std::max(1.0, std::hypot(block.rays.a[i], block.rays.b[i]));
                facts.largest = std::max(facts.largest, error);
                if (error > options_.error) ++beyond;
            }
        }
    }
    const auto each = 1 / static_cast<double>(rays);
    facts.steps = static_cast<double>(counts.steps) * each;
    facts.reads = static_cast<double>(counts.reads) * each;
    facts.overSteps = static_cast<double>(over) * each;
    facts.beyond = static_cast<double>(beyond) * each;
    if (options_.form == Form::Scalar) facts.cost = facts.reads + options_.stepCost * facts.steps;
}

void AdviceRays::time(AdviceTrial& trial, std::size_t block, Work& work) const {
    double seconds = 0;
    NullSink null;
    HitBlock hits;
    for (const auto& view : views_) {
        const RayBlock& rays = view[block % kBlocks].rays;
        hits.resize(rays.size());
        const double begun = processorSeconds();
        trial.tracer->trace(rays, hits, null, work);
        seconds += (processorSeconds() - begun) / static_cast<double>(rays.size());
    }
    trial.times.push_back(std::max(seconds / static_cast<double>(views_.size()), 1e-12));
}

bool AdviceRays::keepsSteps(const AdvisedForm& facts) const {
    return options_.maxSteps == 0 || facts.overSteps <= options_.outliers;
}

bool AdviceRays::keepsBound(const AdvisedForm& facts) const {
    return facts.beyond <= options_.outliers;
}

AdviceMaps::AdviceMaps(const AdviceOptions& options, Work& work)
    : options_(options),
      work_(work),
      maps_(static_cast<std::size_t>(std::max<std::int64_t>(options.memory, std::int64_t{1} << 20)) * 4) {}

// Builds the maps of small pieces first, and estimates from them whether the whole map can keep the memory and time
// limits.
bool AdviceMaps::fits(AdviceTrial& trial, double limit) {
    const HeightField& field = options_.field;
    const int side = std::min(field.width(), field.height());
    if (side <= 2 * kPieceSide || !measuredMethod(trial.facts.method).buildsMaps) return true;
    constexpr double kFixedBuildSeconds = 0.05;  // seconds; shorter times are the fixed cost of building any map
    constexpr int kLeastShare = 8;               // of the map's side
    double seconds = 0;
    for (int piece = kPieceSide; seconds <= kFixedBuildSeconds; piece *= 2) {
        MapCache maps;
        const auto begun = Clock::now();
        const auto tracer = makeTracer(trial.facts.method, middlePiece(field, piece), maps, work_, options_.form);
        seconds = std::chrono::duration<double>(Clock::now() - begun).count();
        const double times = static_cast<double>(field.width()) * field.height() / (static_cast<double>(piece) * piece);
        const double bytes = static_cast<double>(tracer->bytes()) * times;
        // A sixth of the piece's bytes may be specific to its size, such as a map's border.
        if (bytes > 1.2 * static_cast<double>(options_.memory)) {
            trial.facts.verdict = Verdict::Memory;
            trial.facts.bytes = static_cast<std::int64_t>(bytes);
        } else if (seconds > kFixedBuildSeconds && seconds * times > 4 * limit) {
            trial.facts.verdict = Verdict::BuildTime;
        }
        if (trial.facts.verdict != Verdict::Kept || piece * 2 * kLeastShare > side) break;
    }
    return trial.facts.verdict == Verdict::Kept;
}

std::unique_ptr<Tracer> AdviceMaps::built(const MethodChoice& method, double limit, double& seconds) {
    const BuildWatch watch(work_, limit);
    Work work(work_.threads().size(), watch.token());
    const auto begun = Clock::now();
    auto tracer = makeTracer(method, options_.field, maps_, work, options_.form);
    seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    return tracer;
}

void AdviceMaps::make(AdviceTrial& trial, double limit) {
    AdvisedForm& facts = trial.facts;
    const std::string key = mapKey(facts.method);
    facts.guarantee = findTracer(facts.method.name).guarantee;
    try {
        const bool known = key.empty() || seconds_.contains(key);
        if (!known && limit <= 0) {
            facts.verdict = Verdict::BuildTime;
            return;
        }
        if (!known && !fits(trial, limit)) return;
        if (!known && maps_.bytes() > static_cast<std::size_t>(options_.memory)) {
            // Tracers that are still compared keep theirs.
            maps_.clear();
            seconds_.clear();
        }
        trial.tracer = built(facts.method, known ? options_.seconds : limit, facts.buildSeconds);
    } catch (const Cancelled&) {
        work_.throwIfStopped();
        facts.verdict = Verdict::BuildTime;
        return;
    } catch (const MemoryError&) {
        facts.verdict = Verdict::Memory;
        return;
    } catch (const InputError&) {
        facts.verdict = Verdict::Refused;
        return;
    } catch (const std::bad_alloc&) {
        facts.verdict = Verdict::Memory;
        return;
    }
    if (!key.empty()) facts.buildSeconds = std::max(facts.buildSeconds, seconds_[key]);
    if (!key.empty()) seconds_[key] = facts.buildSeconds;
    facts.guarantee = trial.tracer->guarantee();
    facts.bytes = static_cast<std::int64_t>(trial.tracer->bytes());
    if (facts.bytes > options_.memory) {
        facts.verdict = Verdict::Memory;
        trial.tracer.reset();
    }
}

}  // namespace relief
