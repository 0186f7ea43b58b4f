#include "measuring/diagnose/ray_sample.h"

#include <algorithm>

#include "measuring/compare/duel.h"
#include "measuring/random_rays.h"
#include "scenario/ray_files.h"

namespace relief {

namespace {

constexpr std::uint64_t kSeed = 7;

AnsweredRays answered(const std::vector<std::size_t>& ids, const TracerRecord& record) {
    AnsweredRays out;
    out.rays.resize(ids.size());
    for (std::size_t n = 0; n < ids.size(); ++n) {
        out.rays.set(n, record.rays[ids[n]]);
        out.answers.push_back(record.hits[ids[n]]);
    }
    return out;
}

// Returns the fault that the recorded steps of each ray show; std::nullopt if they show none or were not recorded.
std::vector<std::optional<Fault>> kindsOf(const std::vector<std::size_t>& ids, const TracerRecord& record,
                                          const HitBlock& exact, const HeightField& field) {
    std::vector<std::optional<Fault>> kinds(ids.size());
    const StepLog& log = *record.steps;
    for (std::size_t n = 0; n < ids.size(); ++n) {
        const std::size_t r = ids[n];
        if (r >= log.rays()) continue;
        const std::span<const Step> steps = stepsOf(log, r);
        if (steps.empty()) continue;
        DuelRun run;
        run.hit = record.hits[r];
        run.steps.assign(steps.begin(), steps.end());
        const Departure kind = judge(run, exact[r], record.rays[r], field).kind;
        if (kind == Departure::UnsafeMap) kinds[n] = Fault::UnsafeMap;
        if (kind == Departure::MissedSpike) kinds[n] = Fault::MissedSpike;
    }
    return kinds;
}

}  // namespace

std::vector<std::size_t> sampleOf(const std::vector<std::size_t>& all, std::size_t count) {
    if (all.size() <= count) return all;
    std::vector<std::size_t> mixed = all;
    Random random(kSeed);
    for (std::size_t n = 0; n < count; ++n) {
        std::swap(mixed[n], mixed[n + static_cast<std::size_t>(random.below(static_cast<int>(all.size() - n)))]);
    }
    mixed.resize(count);
    std::sort(mixed.begin(), mixed.end());
    return mixed;
}

RaySample raySample(std::vector<std::size_t> ids, std::vector<bool> explained, const TracerRecord& record,
                    const HitBlock& exact, const HeightField& field) {
    RaySample sample;
    sample.given = answered(ids, record);
    sample.evidence.lattice = latticeOf(sample.given);
    bool counted = false;
    for (const std::size_t r : ids) {
        sample.evidence.counts.push_back(record.hits.steps[r]);
        counted = counted || record.hits.steps[r] > 0;
    }
    if (!counted) sample.evidence.counts.clear();
    if (record.steps) sample.evidence.kinds = kindsOf(ids, record, exact, field);
    sample.ids = std::move(ids);
    sample.explained = std::move(explained);
    return sample;
}

}  // namespace relief
