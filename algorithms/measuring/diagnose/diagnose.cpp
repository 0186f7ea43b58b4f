#include "measuring/diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "measuring/compare/duel.h"
#include "measuring/random_rays.h"
#include "relief/tracers.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Wrong answers up to this number, or this share of the rays, are no fault.
constexpr std::size_t kFewWrong = 2;
constexpr double kShareWrong = 2e-4;
// Sizes of the sample of wrong and of right rays.
constexpr std::size_t kWrongSample = 420;
constexpr std::size_t kRightSample = 280;
// Rays over which the share of a convention's fault is counted; wrong rays that are looked at for barely touching.
constexpr std::size_t kCounted = 20000;
// A further fault must explain this share of the rays that are unexplained; one that is known by the kind of errors
// alone, more.
constexpr double kExplains = 0.3;
constexpr double kLooselyExplains = 0.6;
// What a fault costs, as a share of the unexplained rays; and being loose.
constexpr double kFaultCost = 0.02;
constexpr double kLooseCost = 0.05;
constexpr int kRounds = 4;
constexpr std::size_t kMatches = 24;
constexpr std::uint64_t kSeed = 7;

double runOf(const ViewRay& ray) {
    return std::max(1.0, std::hypot(ray.a, ray.b));
}

// Returns `count` of the indices, evenly random, in their order.
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

// The exact answers to the given rays.
HitBlock exactHits(const RayBlock& rays, const HeightField& field, Work& work) {
    MapCache maps;
    HitBlock hits;
    NullSink sink;
    makeTracer({"max-pyramid", {}}, field, maps, work)->trace(rays, hits, sink, work);
    return hits;
}

class Doctor {
  public:
    Doctor(const TracerRecord& record, const HeightField& field, Work& work)
        : record_(record), field_(field), work_(work), fields_(field, work) {}

    Diagnosis diagnosis() {
        compare();
        if (out_.healthy()) return out_;
        takeSample();
        explain();
        count();
        return out_;
    }

  private:
    // Finds the wrong rays.
    void compare() {
        const std::size_t n = record_.rays.size();
        out_.rays = n;
        exact_ = exactHits(record_.rays, field_, work_);
        out_.errors.resize(n);
        for (std::size_t r = 0; r < n; ++r) {
            const double error = answerError(record_.hits[r], exact_[r], record_.rays[r]);
            out_.errors[r] = static_cast<float>(error);
            (error > kRightTexels ? wrong_ : right_).push_back(r);
        }
        dropTouching();
        out_.wrong = wrong_.size();
        if (n > 0) {
            const auto worst = std::max_element(out_.errors.begin(), out_.errors.end());
            out_.worst = static_cast<std::size_t>(worst - out_.errors.begin());
        }
    }

    // Rays that barely touch the surface are no fault of the tracer. Where very many are wrong, this is not looked at.
    void dropTouching() {
        if (wrong_.size() > kCounted) return;
        std::vector<std::uint8_t> touching(wrong_.size(), 0);
        parallelFor(work_, wrong_.size(), [&](std::size_t n) {
            const std::size_t r = wrong_[n];
            if (exact_.outcome[r] != Outcome::Hit) return;
            const ViewRay ray = record_.rays[r];
            const auto chords = solidChords(field_, ray, exact_.lambda[r]);
            touching[n] = barelyTouches(field_, ray, chords, record_.hits[r], runOf(ray)) ? 1 : 0;
        });
        std::vector<std::size_t> rest;
        for (std::size_t n = 0; n < wrong_.size(); ++n) (touching[n] != 0 ? right_ : rest).push_back(wrong_[n]);
        out_.touching = wrong_.size() - rest.size();
        wrong_ = rest;
    }

    void takeSample() {
        chosen_ = sampleOf(wrong_, kWrongSample);
        wrongSample_ = chosen_.size();
        for (const std::size_t r : sampleOf(right_, kRightSample)) chosen_.push_back(r);
        sample_.rays.resize(chosen_.size());
        bool counted = false;
        for (std::size_t n = 0; n < chosen_.size(); ++n) {
            const std::size_t r = chosen_[n];
            sample_.rays.set(n, record_.rays[r]);
            sample_.answers.push_back(record_.hits[r]);
            evidence_.counts.push_back(record_.hits.steps[r]);
            counted = counted || record_.hits.steps[r] > 0;
        }
        if (!counted) evidence_.counts.clear();
        if (record_.steps) readSteps();
    }

    // What the recorded steps of the wrong rays show.
    void readSteps() {
        const StepLog& log = *record_.steps;
        for (const std::size_t r : chosen_) {
            evidence_.kinds.emplace_back();
            if (r >= log.rays() || log.begin[r] == log.begin[r + 1]) continue;
            DuelRun run;
            run.hit = record_.hits[r];
            run.steps.assign(log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r]),
                             log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r + 1]));
            const Departure kind = judge(run, exact_[r], record_.rays[r], field_).kind;
            if (kind == Departure::UnsafeMap) evidence_.kinds.back() = Fault::UnsafeMap;
            if (kind == Departure::MissedSpike) evidence_.kinds.back() = Fault::MissedSpike;
        }
    }

    // The extensions of the model found so far that are tried.
    std::vector<TracerModel> candidates(const TracerModel& begin) {
        std::vector<TracerModel> all;
        AnsweredRays rest;
        for (std::size_t n = 0; n < chosen_.size(); ++n) {
            if (best_ ? best_->rays[n].explained : n >= wrongSample_) continue;
            rest.rays.push(sample_.rays[n]);
            rest.answers.push_back(sample_.answers[n]);
        }
        for (const TracerModel& model : surfaceMatches(rest, begin, fields_, kMatches, work_)) all.push_back(model);
        std::vector<TracerModel> heads{begin};
        heads.insert(heads.end(), all.begin(), all.begin() + std::min<std::ptrdiff_t>(2, std::ssize(all)));
        std::vector<TracerModel> further;
        for (const TracerModel& head : heads) {
            for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
                TracerModel model = head;
                model.address = address;
                if (address != field_.address()) further.push_back(model);
            }
            for (const int bits : {8, -8}) {
                TracerModel model = head;
                model.bits = bits;
                further.push_back(model);
            }
        }
        all.insert(all.begin(), further.begin(), further.end());
        return all;
    }

    // The share of the unexplained rays that an explanation adds, less those that it loses.
    double gain(const Explanation& one) const {
        double gained = 0, lost = 0, open = 0;
        for (std::size_t n = 0; n < chosen_.size(); ++n) {
            const bool before = best_ ? best_->rays[n].explained : n >= wrongSample_;
            open += before ? 0 : 1;
            gained += !before && one.rays[n].explained ? 1 : 0;
            lost += before && !one.rays[n].explained ? 1 : 0;
        }
        return open > 0 ? (gained - lost) / open : 0;
    }

    // The best explanation of a round.
    struct Found {
        std::optional<Explanation> one;
        double cost = HUGE_VAL;
        double share = 0;
    };

    void offer(const TracerModel& model, const TracerModel& begin, bool byShape, Found& found) {
        work_.throwIfStopped();
        const std::size_t had = modelFaults(begin, field_.address()).size();
        for (Explanation& one : explanations(sample_, evidence_, model, byShape, fields_, work_)) {
            const double share = gain(one);
            const double faults = static_cast<double>(modelFaults(one.model, field_.address()).size()) -
                                  static_cast<double>(had) + static_cast<double>(one.searchFaults.size());
            double cost = 1 - share + kFaultCost * faults;
            // Numbers can be chosen such that a loose explanation fits.
            if (one.loose) cost += kLooseCost * (1 + fittedNumbers(one.model));
            if (cost >= found.cost) continue;
            found = {std::move(one), cost, share};
        }
    }
    static double fittedNumbers(const TracerModel& model) {
        double count = std::abs(model.gain) != 1 || (model.lift != 0 && model.lift != 1) ? 1 : 0;
        for (const bool fitted : {model.runScale != 1, model.turn != 0, model.bias != 0, model.biasTexels != 0}) {
            count += fitted ? 1 : 0;
        }
        return count;
    }
    // Whether no better explanation can be expected, with one fault or two.
    static bool enough(const Found& found) {
        if (!found.one || found.share < 0.98) return false;
        const auto& faults = found.one->searchFaults;
        return !found.one->loose || std::all_of(faults.begin(), faults.end(), [](const ModelFault& fault) {
            return fault.fault == Fault::MissedSpike || fault.fault == Fault::StepLimit;
        });
    }

    void explain() {
        TracerModel begin;
        for (int round = 0; round < kRounds; ++round) {
            if (best_ && unexplainedOf(*best_) <= 0.02 * static_cast<double>(wrongSample_)) return;
            Found found;
            offer(begin, begin, true, found);
            if (!enough(found)) {
                constexpr int kByShape = 12;
                int tried = 0;
                for (const TracerModel& model : candidates(begin)) {
                    offer(model, begin, tried++ < kByShape, found);
                    if (enough(found)) break;
                }
            }
            if (!found.one || found.share < (found.one->loose ? kLooselyExplains : kExplains)) return;
            best_ = std::move(found.one);
            begin = best_->model;
        }
    }

    double unexplainedOf(const Explanation& one) const {
        double open = 0;
        for (std::size_t n = 0; n < wrongSample_; ++n) open += one.rays[n].explained ? 0 : 1;
        return open;
    }

    // The share of the faults in all rays.
    void count() {
        const double weight = static_cast<double>(wrong_.size()) / static_cast<double>(wrongSample_);
        const double open = best_ ? unexplainedOf(*best_) : static_cast<double>(wrongSample_);
        out_.unexplained = static_cast<std::size_t>(std::llround(open * weight));
        if (!best_) return;
        countConventions();
        for (const ModelFault& fault : best_->searchFaults) {
            Finding finding{fault, 0, 0, -1};
            double rays = 0;
            for (std::size_t n = 0; n < wrongSample_; ++n) {
                if (best_->rays[n].cause != fault.fault) continue;
                rays += weight;
                worsen(finding, chosen_[n]);
            }
            finding.rays = static_cast<std::size_t>(std::llround(rays));
            if (finding.rays > 0) out_.findings.push_back(finding);
        }
        std::stable_sort(out_.findings.begin(), out_.findings.end(),
                         [](const Finding& x, const Finding& y) { return x.rays > y.rays; });
    }

    void worsen(Finding& finding, std::size_t ray) const {
        const double texels = out_.errors[ray];
        if (texels <= finding.texels) return;
        finding.texels = texels;
        finding.worst = ray;
    }

    // A convention makes those rays wrong whose answer the model changes if the convention is put right.
    void countConventions() {
        const std::vector<std::size_t> counted = sampleOf(wrong_, kCounted);
        RayBlock rays(counted.size());
        for (std::size_t n = 0; n < counted.size(); ++n) rays.set(n, record_.rays[counted[n]]);
        const std::vector<Hit> with = predict(best_->model, rays, fields_, work_);
        const double weight = static_cast<double>(wrong_.size()) / static_cast<double>(counted.size());
        for (const ModelFault& fault : modelFaults(best_->model, field_.address())) {
            const std::vector<Hit> without = predict(withoutFault(best_->model, fault.fault), rays, fields_, work_);
            Finding finding{fault, 0, 0, -1};
            double sum = 0;
            for (std::size_t n = 0; n < counted.size(); ++n) {
                if (answerError(with[n], without[n], rays[n]) <= kRightTexels) continue;
                sum += weight;
                worsen(finding, counted[n]);
            }
            finding.rays = static_cast<std::size_t>(std::llround(sum));
            if (finding.rays > 0) out_.findings.push_back(finding);
        }
    }

    const TracerRecord& record_;
    HeightField field_;
    Work& work_;
    ModelFields fields_;
    HitBlock exact_;
    std::vector<std::size_t> wrong_, right_;
    // Indices of the rays of the sample, the wrong ones first.
    std::vector<std::size_t> chosen_;
    std::size_t wrongSample_ = 0;
    AnsweredRays sample_;
    SearchEvidence evidence_;
    std::optional<Explanation> best_;
    Diagnosis out_;
};

}  // namespace

bool Diagnosis::healthy() const {
    return static_cast<double>(wrong) <= std::max(static_cast<double>(kFewWrong), kShareWrong * static_cast<double>(rays));
}

bool Diagnosis::unknown() const {
    if (healthy()) return false;
    constexpr double kOpen = 0.1;
    return findings.empty() || static_cast<double>(unexplained) > kOpen * static_cast<double>(wrong);
}

Diagnosis diagnose(const TracerRecord& record, const HeightField& field, Work& work) {
    return Doctor(record, field, work).diagnosis();
}

}  // namespace relief
