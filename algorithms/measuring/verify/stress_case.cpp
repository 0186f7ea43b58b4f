#include "measuring/verify/stress_case.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "measuring/verify/stress_parts.h"

namespace relief::stress_detail {

namespace {

// Steps of one method over one ray family in a case after which the family ends early; one ray at least is traced.
constexpr std::uint64_t kStepsPerFamily = 100'000;
// Logs are compared up to kLoggedSteps steps, longer ones up to kLongLoggedSteps and kLongLogs times per method and
// case.
constexpr std::uint32_t kLoggedSteps = 4096;
constexpr std::uint32_t kLongLoggedSteps = 131'072;
constexpr int kLongLogs = 2;
// Rays of a block: enough for packets of neighbouring rays, few enough to end early. Families with fewer rays in a case
// than kManyRays have no blocks.
constexpr std::size_t kBlockRays = 64;
constexpr int kManyRays = 16;
// A family's blocks end after kStepsPerFamily steps, and as many again for each this number of further rays.
constexpr std::size_t kRaysPerLimit = 1024;

constexpr std::array<double, 6> kDepths{0.1, 0.5, 0.02, 4, 0, 1e-6};

// Stream numbers for seedFor(); case numbers are below these.
constexpr std::uint64_t kOrder = std::uint64_t{1} << 62;
constexpr std::uint64_t kRays = std::uint64_t{1} << 61;
constexpr std::uint64_t kParts = std::uint64_t{1} << 60;

bool enabled(const StressOptions& options, StressPart part) {
    return options.parts.empty() || options.parts.contains(part);
}

// Returns the map family at a position of a round; a round contains each family once, in random order.
std::size_t mapAt(std::uint64_t seed, std::uint64_t round, std::size_t place) {
    std::vector<std::size_t> order(stressMapFamilies().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(seedFor(seed, kOrder + round));
    for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random.below(static_cast<int>(i + 1)))]);
    }
    return order[place];
}

// Traces the rays of one case with one method.
class Turn {
  public:
    Turn(const Case& of, const MeasuredMethod& method, const Tracer& tracer, Watched& watched, CaseResult& result,
         Work& work)
        : of_(of),
          method_(method),
          tracer_(tracer),
          watched_(watched),
          result_(result),
          coverage_(result.methods[method.choice.name]),
          work_(work) {
        coverage_.forms.insert(optionsText(method.choice, false));
    }

    void run(const FamilyRays& familyRays) {
        familyRays_ = &familyRays;
        std::uint64_t steps = 0;
        for (std::size_t r = 0; r < familyRays.rays.size() && steps < kStepsPerFamily; ++r) {
            const CountedHit answer = counted(familyRays.rays[r]);
            steps += answer.steps;
            ++coverage_.rays[std::string(familyRays.family)];
            note(answer, familyRays.rays[r]);
            if (auto fault = answerFault(tracer_, familyRays.rays[r], answer, familyRays.truth[r])) {
                report(*fault, familyRays.rays[r]);
            }
            compareSinks(answer, r);
        }
        const auto longest = kStepsPerFamily * (1 + familyRays.more.size() / kRaysPerLimit);
        steps = 0;
        for (std::size_t at = 0; at < familyRays.more.size() && steps < longest; at += kBlockRays) {
            steps += block(at, std::min(kBlockRays, familyRays.more.size() - at));
        }
    }

  private:
    // Traces a block of the further rays; returns the number of steps.
    std::uint64_t block(std::size_t at, std::size_t size) {
        RayBlock rays(size);
        for (std::size_t i = 0; i < size; ++i) rays.set(i, familyRays_->more[at + i]);
        HitBlock hits, plain;
        BlockCounts counts;
        NullSink null;
        watched_.begin({&of_, StressPart::Tracers, &method_.choice, familyRays_->family, rays[0], nullptr, true});
        tracer_.trace(rays, hits, counts, work_);
        tracer_.trace(rays, plain, null, work_);
        watched_.end();
        std::uint64_t steps = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const CountedHit answer{hits[i], hits.steps[i], hits.reads[i]};
            steps += answer.steps;
            note(answer, rays[i]);
            if (auto fault = answerFault(tracer_, rays[i], answer, familyRays_->moreTruth[at + i])) {
                report(*fault, rays[i], true);
            }
            if (!sameHit(answer.hit, plain[i])) report(sinksFault(answer.hit, plain[i]), rays[i], true);
        }
        coverage_.rays[std::string(familyRays_->family)] += size;
        return steps;
    }

    static StressFault sinksFault(const Hit& counted, const Hit& plain) {
        return {"sinks", "the answer changes when reads are counted: lambda " + numberText(plain.lambda) +
                             " without, " + numberText(counted.lambda) + " with"};
    }

    template <class Sink>
    HitBlock traced(const ViewRay& ray, Sink& sink) {
        RayBlock rays(1);
        rays.set(0, ray);
        HitBlock hits;
        watched_.begin({&of_, StressPart::Tracers, &method_.choice, familyRays_->family, ray});
        tracer_.trace(rays, hits, sink, work_);
        watched_.end();
        return hits;
    }

    CountedHit counted(const ViewRay& ray) {
        BlockCounts counts;
        const HitBlock hits = traced(ray, counts);
        return {hits[0], hits.steps[0], hits.reads[0]};
    }

    void compareSinks(const CountedHit& answer, std::size_t r) {
        NullSink null;
        const Hit plain = traced(familyRays_->rays[r], null)[0];
        if (!sameHit(answer.hit, plain)) report(sinksFault(answer.hit, plain), familyRays_->rays[r]);
        if (answer.steps > kLoggedSteps) {
            if (answer.steps > kLongLoggedSteps || longLogs_ == kLongLogs) return;
            ++longLogs_;
        }
        StepLog log;
        const Hit logged = traced(familyRays_->rays[r], log)[0];
        ++coverage_.logs;
        if (auto fault = logFault(answer, logged, log)) report(*fault, familyRays_->rays[r]);
    }

    void note(const CountedHit& answer, const ViewRay& ray) {
        const double share = answer.steps / tracer_.stepBound(ray);
        if (!(share > coverage_.worstBound)) return;
        coverage_.worstBound = share;
        coverage_.worstWhere = std::string(familyRays_->family) + " over " + of_.map;
    }

    void report(const StressFault& fault, const ViewRay& ray, bool block = false) {
        result_.report({fault, StressPart::Tracers, method_.choice, familyRays_->family, ray, nullptr, block});
    }

    const Case& of_;
    const MeasuredMethod& method_;
    const Tracer& tracer_;
    Watched& watched_;
    CaseResult& result_;
    StressMethodCoverage& coverage_;
    Work& work_;
    const FamilyRays* familyRays_ = nullptr;
    int longLogs_ = 0;
};

// Adds the further rays of the family, whose random numbers follow those of its first rays.
void addMore(FamilyRays& familyRays, const StressRayFamily& family, const Case& of, int moreRays, Random& random,
             const Tracer& exact, Watched& watched, Work& work) {
    if (family.rays < kManyRays) return;
    const MethodChoice truth{exact.description().name, {}};
    for (int r = 0; r < family.rays * moreRays; ++r) familyRays.more.push(family.make(of.field, random));
    NullSink null;
    watched.begin({&of, StressPart::Tracers, &truth, family.name, familyRays.more[0], nullptr, true});
    exact.trace(familyRays.more, familyRays.moreTruth, null, work);
    watched.end();
}

std::vector<FamilyRays> raysOfFamilies(const Case& of, const StressOptions& options, const Tracer& exact,
                                       Watched& watched, Work& work) {
    const MethodChoice truth{exact.description().name, {}};
    std::vector<FamilyRays> all;
    const auto& families = stressRayFamilies();
    for (std::size_t f = 0; f < families.size(); ++f) {
        const StressRayFamily& family = families[f];
        if ((of.number + f) % static_cast<std::uint64_t>(family.every) != 0) continue;
        Random random(seedFor(options.seed, kRays + of.number * families.size() + f));
        FamilyRays familyRays{family.name, {}, {}, {}, {}};
        for (int r = 0; r < family.rays; ++r) {
            familyRays.rays.push_back(family.make(of.field, random));
            RayBlock rays(1);
            rays.set(0, familyRays.rays.back());
            HitBlock hits;
            NullSink null;
            watched.begin({&of, StressPart::Tracers, &truth, family.name, familyRays.rays.back()});
            exact.trace(rays, hits, null, work);
            watched.end();
            familyRays.truth.push_back(hits[0]);
        }
        if (options.moreRays > 0 && enabled(options, StressPart::Tracers)) {
            addMore(familyRays, family, of, options.moreRays, random, exact, watched, work);
        }
        all.push_back(std::move(familyRays));
    }
    return all;
}

void traceRays(const CaseRun& run, const std::vector<FamilyRays>& familyRays) {
    const Case& tried = run.of;
    const std::uint64_t turn = tried.number + tried.number / stressMapFamilies().size();
    for (std::size_t g = 0; g < run.groups.size(); ++g) {
        const MeasuredMethod& method = run.groups[g].forms[(turn + g) % run.groups[g].forms.size()];
        if (method.buildsMaps && tried.field.heights().size() > kStressBuildTexels) continue;
        if (!method.supports(tried.field.surface(), tried.field.address())) continue;
        const auto tracer = method.make(tried.field, *run.maps, run.work);
        Turn methodTurn(tried, method, *tracer, run.watched, run.result, run.work);
        for (const FamilyRays& family : familyRays) {
            run.work.throwIfStopped();
            methodTurn.run(family);
        }
    }
}

}  // namespace

Case makeCase(std::uint64_t seed, std::uint64_t number) {
    const auto& families = stressMapFamilies();
    const std::uint64_t round = number / families.size();
    const std::size_t place = number % families.size();
    const std::size_t map = mapAt(seed, round, place);
    // Within six rounds, each map family meets every pair of surface and addressing.
    const std::uint64_t pair = (round + map) % 6;
    Random random(seedFor(seed, number));
    const auto& sizes = stressSizes();
    const StressSize size = sizes[static_cast<std::size_t>(random.below(static_cast<int>(sizes.size())))];
    const double depth = kDepths[static_cast<std::size_t>(random.below(int{kDepths.size()}))];
    StressMap made = families[map].make(size.width, size.height, random);
    HeightField field(made.heights, pair % 2 == 0 ? Surface::Bilinear : Surface::Columns,
                      static_cast<Address>(pair / 2), depth);
    return {number, std::string(families[map].name), std::move(made), std::move(field)};
}

Random partRandom(const CaseRun& run, StressPart part, std::uint64_t n) {
    return Random(seedFor(run.options.seed, kParts + n * kStressParts + static_cast<std::uint64_t>(part)));
}

void CaseResult::report(Found violation) {
    ++violationCount;
    const bool known = std::any_of(found.begin(), found.end(), [&](const Found& f) {
        return f.part == violation.part && f.method == violation.method && f.fault.check == violation.fault.check;
    });
    if (!known) found.push_back(std::move(violation));
}

CaseResult runCase(const Case& tried, const StressOptions& options, const std::vector<MethodGroup>& groups,
                   Watched& watched, Work& work) {
    CaseResult result;
    result.number = tried.number;
    result.map = tried.map;
    result.size = std::to_string(tried.field.width()) + "x" + std::to_string(tried.field.height());
    static const StressSubjects own;
    const StressSubjects& subjects = options.subjects ? *options.subjects : own;
    const CaseRun run{tried, options, groups, subjects, std::make_shared<MapCache>(), watched, result, work};
    if (enabled(options, StressPart::Tracers) || enabled(options, StressPart::AnyHit) || options.oracle) {
        const auto exact = makeTracer({"exact", {}}, tried.field, *run.maps, work);
        const std::vector<FamilyRays> familyRays = raysOfFamilies(tried, options, *exact, watched, work);
        if (enabled(options, StressPart::Tracers)) traceRays(run, familyRays);
        if (enabled(options, StressPart::AnyHit)) stressAnyHit(run, familyRays);
        if (options.oracle) stressOracle(run, familyRays);
    }
    if (enabled(options, StressPart::Frames)) stressFrames(run);
    if (enabled(options, StressPart::Homographies)) stressHomographies(run);
    if (enabled(options, StressPart::Rows)) stressRows(run);
    return result;
}

}  // namespace relief::stress_detail
