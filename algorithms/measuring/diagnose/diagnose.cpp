#include "measuring/diagnose/diagnose.h"

#include <algorithm>
#include <cmath>

#include "measuring/diagnose/compared_rays.h"
#include "measuring/diagnose/conventions.h"
#include "measuring/diagnose/ray_sample.h"
#include "measuring/diagnose/searched_rays.h"
#include "measuring/diagnose/surface_match.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Wrong answers up to this number, or this share of the rays, are no fault.
constexpr std::size_t kFewWrong = 2;
constexpr double kShareWrong = 2e-4;
// Sizes of the sample of wrong and of right rays.
constexpr std::size_t kWrongSample = 420;
constexpr std::size_t kRightSample = 280;
// Sizes of the pool from which they are taken.
constexpr std::size_t kWrongPool = 6000;
constexpr std::size_t kRightPool = 2000;
// Wrong rays over which the share of a convention's fault is counted.
constexpr std::size_t kCounted = 20000;
// A further fault must explain this share of the rays that are unexplained; one that is known by the kind of errors
// alone, more.
constexpr double kExplains = 0.3;
constexpr double kLooselyExplains = 0.6;
// What a fault costs, as a share of the unexplained rays; and being loose.
constexpr double kFaultCost = 0.02;
constexpr double kLooseCost = 0.05;
// By how much an explanation that predicts sharply may cost more than another.
constexpr double kSharpLead = 0.7;
// Faults of a smaller share of the wrong rays may be chance.
constexpr double kLeastShare = 0.004;
constexpr int kRounds = 4;
constexpr std::size_t kMatches = 24;

class Doctor {
  public:
    Doctor(const TracerRecord& record, const HeightField& field, Work& work)
        : record_(record), field_(field), work_(work), fields_(field, work) {}

    Diagnosis diagnosis() {
        compare();
        if (out_.healthy()) return out_;
        explain();
        count();
        return out_;
    }

  private:
    // Finds the wrong rays.
    void compare() {
        compared_ = compareRays(record_.rays, record_.hits, field_, work_);
        out_.rays = record_.rays.size();
        out_.wrong = compared_.wrong.size();
        out_.touching = compared_.touching;
        out_.errors = std::move(compared_.errors);
        const auto smaller = [&](std::size_t x, std::size_t y) { return out_.errors[x] < out_.errors[y]; };
        if (out_.wrong > 0) {
            out_.worst = *std::max_element(compared_.wrong.begin(), compared_.wrong.end(), smaller);
        }
    }

    // Takes the rays from which all rounds take their samples: wrong ones first.
    void takePool() {
        std::vector<std::size_t> ids = sampleOf(compared_.wrong, kWrongPool);
        wrongPool_ = ids.size();
        for (const std::size_t r : sampleOf(compared_.right, kRightPool)) ids.push_back(r);
        std::vector<bool> explained(ids.size(), true);
        std::fill_n(explained.begin(), wrongPool_, false);
        pool_ = raySample(std::move(ids), std::move(explained), record_, compared_.exact, field_);
    }
    // Takes the sample of a round: rays of the pool that are not explained, and some that are.
    void takeSample() {
        std::vector<std::size_t> open, done;
        for (std::size_t n = 0; n < pool_.ids.size(); ++n) (pool_.explained[n] ? done : open).push_back(n);
        std::vector<std::size_t> ids;
        std::vector<bool> explained;
        const auto add = [&](const std::vector<std::size_t>& places, std::size_t most) {
            for (const std::size_t n : sampleOf(places, most)) {
                ids.push_back(pool_.ids[n]);
                explained.push_back(pool_.explained[n]);
            }
        };
        add(open, kWrongSample);
        add(done, kRightSample);
        sample_ = raySample(std::move(ids), std::move(explained), record_, compared_.exact, field_);
    }

    // Appends the model with another addressing, and with other values of the heights.
    void addReadings(const TracerModel& head, std::vector<TracerModel>& to) const {
        const auto add = [&](auto member, auto value) {
            TracerModel model = head;
            model.*member = value;
            to.push_back(model);
        };
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            if (address != field_.address()) add(&TracerModel::address, address);
        }
        for (const int bits : {8, -8}) add(&TracerModel::bits, bits);
        for (const int curve : {1, -1}) add(&TracerModel::curve, curve);
    }

    // The extensions of the model found so far by one fault without a number.
    std::vector<TracerModel> simpleCandidates(const TracerModel& begin) const {
        std::vector<TracerModel> models;
        addReadings(begin, models);
        for (const TracerModel& model : singleFaults(begin, field_)) models.push_back(model);
        return models;
    }
    // Further extensions: those on whose surface the unexplained answers lie.
    std::vector<TracerModel> matchedCandidates(const TracerModel& begin) {
        AnsweredRays rest;
        for (std::size_t n = 0; n < sample_.ids.size(); ++n) {
            if (sample_.explained[n]) continue;
            rest.rays.push(sample_.given.rays[n]);
            rest.answers.push_back(sample_.given.answers[n]);
        }
        // Answers at layers lie half a layer behind the surface, on average.
        const Lattice lattice = latticeOf(rest);
        const double late = lattice.layers > 0 ? 0.5 / lattice.layers : 0;
        std::vector<TracerModel> models = surfaceMatches(rest, begin, fields_, kMatches, late, work_);
        constexpr std::size_t kHeads = 8;
        const std::vector<TracerModel> heads(models.begin(),
                                             models.begin() + std::min<std::ptrdiff_t>(kHeads, std::ssize(models)));
        for (const TracerModel& head : heads) addReadings(head, models);
        return models;
    }

    // What an explanation adds. share: of the rays that are not explained, less those that it loses; sharp: of those
    // that it gains, the share that is predicted to the rounding of float.
    struct Gain {
        double share = 0;
        double sharp = 0;
    };
    Gain gain(const Explanation& one) const {
        double gained = 0, lost = 0, open = 0, sharp = 0;
        for (std::size_t n = 0; n < sample_.ids.size(); ++n) {
            const bool before = sample_.explained[n];
            const bool now = one.rays[n].explained;
            open += before ? 0 : 1;
            gained += !before && now ? 1 : 0;
            sharp += !before && now && one.rays[n].sharp ? 1 : 0;
            lost += before && !now ? 1 : 0;
        }
        if (!(open > 0)) return {};
        return {(gained - lost) / open, gained > 0 ? sharp / gained : 0};
    }

    // The best explanation of a round.
    struct Found {
        std::optional<Explanation> one;
        double cost = HUGE_VAL;
        Gain gain;
    };
    // The best of a round that predict the answers sharply, and of the others.
    struct Round {
        Found sharp, other;

        // Sharp explanations are preferred: each that explains enough is a fault, further ones are found in the next
        // round.
        const Found& best() const {
            return sharp.one && sharp.gain.share >= kExplains && sharp.cost <= other.cost + kSharpLead ? sharp : other;
        }
    };

    void offer(const TracerModel& model, const TracerModel& begin, bool byShape, Round& round) const {
        work_.throwIfStopped();
        const auto conventions = [&](const TracerModel& one) {
            return static_cast<double>(modelFaults(one, field_.address()).size());
        };
        const double had = conventions(begin);
        double exactShare = 0;
        bool first = true;
        for (Explanation& one : explanations(sample_.given, sample_.evidence, model, byShape, fields_, work_)) {
            const Gain gained = gain(one);
            if (first) exactShare = gained.share;
            first = false;
            const double added = conventions(one.model) - had;
            double cost = 1 - gained.share + kFaultCost * (added + static_cast<double>(one.searchFaults.size()));
            if (one.loose) {
                // Conventions can be chosen such that a loose explanation fits: they must explain much by themselves.
                if (added > 0 && exactShare < kExplains) continue;
                // Numbers can be fitted even more easily.
                cost += kLooseCost * (1 + fittedNumbers(one.model));
            }
            const bool sharp = !one.loose && gained.sharp >= 0.5;
            Found& found = sharp ? round.sharp : round.other;
            if (cost < found.cost) found = {std::move(one), cost, gained};
        }
    }
    static double fittedNumbers(const TracerModel& model) {
        double count = std::abs(model.gain) != 1 || (model.lift != 0 && model.lift != 1) ? 1 : 0;
        for (const bool fitted : {model.runScale != 1, model.turn != 0, model.bias != 0, model.biasTexels != 0}) {
            count += fitted ? 1 : 0;
        }
        return count;
    }
    // Returns true if no better explanation can be expected, with one fault or two.
    static bool enough(const Found& found) {
        if (!found.one || found.gain.share < 0.98) return false;
        const auto& faults = found.one->searchFaults;
        if (!found.one->loose) return found.gain.sharp >= 0.8;
        return std::all_of(faults.begin(), faults.end(), [](const ModelFault& fault) {
            return fault.fault == Fault::MissedSpike || fault.fault == Fault::StepLimit;
        });
    }

    void explain() {
        takePool();
        TracerModel begin;
        for (int n = 0; n < kRounds; ++n) {
            if (open() <= kFewWrong) return;
            takeSample();
            Round round;
            offer(begin, begin, true, round);
            std::vector<TracerModel> tried;
            const auto offerAll = [&](const std::vector<TracerModel>& models, bool byShape) {
                for (const TracerModel& model : models) {
                    if (enough(round.best())) return;
                    offer(model, begin, byShape, round);
                }
            };
            for (const bool matched : {false, true}) {
                if (enough(round.best())) break;
                const auto models = matched ? matchedCandidates(begin) : simpleCandidates(begin);
                offerAll(models, false);
                constexpr std::ptrdiff_t kByShape = 40;
                tried.insert(tried.end(), models.begin(), models.begin() + std::min(kByShape, std::ssize(models)));
            }
            // The kind of the errors is used only where no model predicts the answers.
            if (&round.best() == &round.other) offerAll(tried, true);
            const Found& found = round.best();
            if (!found.one || found.gain.share < (found.one->loose ? kLooselyExplains : kExplains)) return;
            if (!extend(*found.one)) return;
            begin = best_->model;
        }
    }

    // Applies what the sample has shown to the whole pool; returns false if it explains nothing more.
    bool extend(const Explanation& found) {
        const std::size_t before = open();
        // The number of rays up to which a further explanation may be chance.
        const auto least = static_cast<std::size_t>(kLeastShare * static_cast<double>(wrongPool_));
        Explanation one;
        if (found.loose) {
            SearchedRays rays(pool_.given, found.model, fields_, work_);
            one = explanationByShape(rays, pool_.evidence);
        } else {
            one = explanationBy(pool_.given, pool_.evidence, found.model, fields_, work_);
        }
        const std::vector<bool> earlier = pool_.explained;
        for (std::size_t n = 0; n < pool_.ids.size(); ++n) pool_.explained[n] = one.rays[n].explained;
        if (open() + least < before) {
            best_ = std::move(one);
            return true;
        }
        pool_.explained = earlier;
        return false;
    }
    // Number of wrong rays of the pool that are not explained.
    std::size_t open() const {
        return static_cast<std::size_t>(std::count(
            pool_.explained.begin(), pool_.explained.begin() + static_cast<std::ptrdiff_t>(wrongPool_), false));
    }

    // The share of the faults in all rays.
    void count() {
        const double weight = static_cast<double>(compared_.wrong.size()) / static_cast<double>(wrongPool_);
        out_.unexplained = static_cast<std::size_t>(std::llround(static_cast<double>(open()) * weight));
        if (!best_) return;
        countConventions();
        for (const ModelFault& fault : best_->searchFaults) {
            Finding finding{fault, 0, 0, -1};
            double rays = 0;
            for (std::size_t n = 0; n < wrongPool_; ++n) {
                if (best_->rays[n].cause != fault.fault) continue;
                rays += weight;
                worsen(finding, pool_.ids[n]);
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
        const std::vector<std::size_t> counted = sampleOf(compared_.wrong, kCounted);
        RayBlock rays(counted.size());
        for (std::size_t n = 0; n < counted.size(); ++n) rays.set(n, record_.rays[counted[n]]);
        const std::vector<Hit> with = predict(best_->model, rays, fields_, work_);
        const double weight = static_cast<double>(compared_.wrong.size()) / static_cast<double>(counted.size());
        for (const ModelFault& fault : modelFaults(best_->model, field_.address())) {
            const bool known = std::any_of(out_.findings.begin(), out_.findings.end(),
                                           [&](const Finding& one) { return one.fault.fault == fault.fault; });
            if (known) continue;
            const std::vector<Hit> without = predict(withoutFault(best_->model, fault.fault), rays, fields_, work_);
            Finding finding{fault, 0, 0, -1};
            double sum = 0;
            for (std::size_t n = 0; n < counted.size(); ++n) {
                if (answerError(with[n], without[n], rays[n]) <= kRightTexels) continue;
                sum += weight;
                worsen(finding, counted[n]);
            }
            finding.rays = static_cast<std::size_t>(std::llround(sum));
            if (sum > kLeastShare * static_cast<double>(compared_.wrong.size())) out_.findings.push_back(finding);
        }
    }

    const TracerRecord& record_;
    HeightField field_;
    Work& work_;
    mutable ModelFields fields_;
    ComparedRays compared_;
    RaySample pool_, sample_;
    std::size_t wrongPool_ = 0;  // the pool's first rays, which are wrong
    std::optional<Explanation> best_;
    Diagnosis out_;
};

}  // namespace

bool Diagnosis::healthy() const {
    return static_cast<double>(wrong) <=
           std::max(static_cast<double>(kFewWrong), kShareWrong * static_cast<double>(rays));
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
