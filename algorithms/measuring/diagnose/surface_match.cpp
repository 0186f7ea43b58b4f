#include "measuring/diagnose/surface_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measuring/diagnose/conventions.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

// Numbers of rays by which all combinations are compared, and the best of them again.
constexpr std::size_t kFewRays = 96;
constexpr std::size_t kMoreRays = 400;
// Distances from the surface below this, heights, count little.
constexpr double kSmallGap = 1.0 / 1024;
// What one more fault must gain, in bits per ray.
constexpr double kFaultBits = 0.15;
// Combinations that are compared by more rays.
constexpr std::size_t kFinalists = 160;

// Conventions, and how badly they fit the answers.
struct Candidate {
    TracerModel model;
    double bits = 0;  // mean of log2(1 + gap / kSmallGap), and kFaultBits for each fault
};

// z = gain * h + lift.
struct Line {
    double gain = 1;
    double lift = 0;
};

class Match {
  public:
    Match(const AnsweredRays& given, double late, ModelFields& fields) : given_(given), late_(late), fields_(fields) {
        for (std::size_t r = 0; r < given.size(); ++r) {
            const Hit& hit = given.answers[r];
            // At the ends of the ray, heights may have been clamped.
            constexpr double kEnd = 1e-6;
            if (hit.outcome == Outcome::Hit && hit.lambda > kEnd && hit.lambda < 1 - kEnd) use_.push_back(r);
        }
    }

    std::size_t rays() const { return use_.size(); }

    // Returns the bits of the model with the best line from its heights to the answers', which it sets.
    double bits(TracerModel& model, std::size_t rays) const {
        rays = std::min(rays, use_.size());
        std::vector<double> z, h;
        readHeights(model, rays, z, h);
        double best = HUGE_VAL;
        const auto offer = [&](const Line& line, double faults) {
            double sum = 0;
            for (std::size_t n = 0; n < rays; ++n) {
                sum += std::log2(1 + std::abs(z[n] - line.gain * h[n] - line.lift) / kSmallGap);
            }
            const double value = sum / static_cast<double>(rays) + faults * kFaultBits;
            if (value >= best) return;
            best = value;
            model.gain = line.gain;
            model.lift = line.lift;
        };
        offer({1, 0}, 0);
        offer({-1, 1}, 1);
        std::vector<double> rest(rays);
        for (const double gain : {1.0, -1.0}) {
            for (std::size_t n = 0; n < rays; ++n) rest[n] = z[n] - gain * h[n];
            offer({gain, upperMedian(rest)}, gain > 0 ? 1 : 2);
        }
        const Line fit = fitted(z, h);
        constexpr double kLeastGain = 0.1;
        if (std::abs(fit.gain) >= kLeastGain) offer(fit, fit.gain > 0 ? 1.5 : 2.5);
        return best;
    }

    // Returns the lift at which most answers lie on the surface of heights with this gain, 1 or -1.
    double densestLift(const TracerModel& model, double gain) const {
        std::vector<double> z, h;
        readHeights(model, use_.size(), z, h);
        for (std::size_t n = 0; n < z.size(); ++n) z[n] -= gain * h[n];
        std::sort(z.begin(), z.end());
        constexpr double kWidth = 1.0 / 512;
        std::size_t best = 0, most = 0;
        for (std::size_t first = 0, last = 0; first < z.size(); ++first) {
            while (last < z.size() && z[last] <= z[first] + kWidth) ++last;
            if (last - first <= most) continue;
            most = last - first;
            best = first + most / 2;
        }
        return z[best];
    }

  private:
    // Sets the answers' heights, and those that the model reads there, without gain and lift.
    void readHeights(const TracerModel& model, std::size_t rays, std::vector<double>& z, std::vector<double>& h) const {
        TracerModel read = model;
        read.gain = 1;
        read.lift = 0;
        const ModelFields::Placed& placed = fields_.of(read);
        z.resize(rays);
        h.resize(rays);
        for (std::size_t n = 0; n < rays; ++n) {
            const std::size_t r = use_[n * use_.size() / rays];
            double lambda = given_.answers[r].lambda + lambdaBias(model, given_.rays[r], fields_.given()) - late_;
            const ViewRay ray = modelRay(read, placed, given_.rays[r], fields_.given());
            double place = lambda;
            if (model.search == ModelSearch::OneSample) {
                place = 0;
                lambda /= oneSampleShare(model, given_.rays[r], fields_.given());
            }
            z[n] = 1 - lambda;
            h[n] = placed.field.at(ray.s0 + place * ray.a, ray.t0 + place * ray.b);
        }
    }

    // A line by least squares, of weights that fall with the distance.
    static Line fitted(const std::vector<double>& z, const std::vector<double>& h) {
        Line line{0, upperMedian(z)};
        std::vector<double> weight(z.size(), 1);
        double scale = 0.25;
        for (int round = 0; round < 12; ++round) {
            double w = 0, x = 0, y = 0, xx = 0, xy = 0;
            for (std::size_t n = 0; n < z.size(); ++n) {
                w += weight[n];
                x += weight[n] * h[n];
                y += weight[n] * z[n];
                xx += weight[n] * h[n] * h[n];
                xy += weight[n] * h[n] * z[n];
            }
            const double spread = w * xx - x * x;
            if (!(spread > 1e-12)) return line;
            line.gain = (w * xy - x * y) / spread;
            line.lift = (y - line.gain * x) / w;
            scale = std::max(scale * 0.5, 1e-4);
            for (std::size_t n = 0; n < z.size(); ++n) {
                const double off = (z[n] - line.gain * h[n] - line.lift) / scale;
                weight[n] = 1 / (1 + off * off);
            }
        }
        return line;
    }

    const AnsweredRays& given_;
    double late_;
    ModelFields& fields_;
    std::vector<std::size_t> use_;
};

// Improves a number of the model by a search of the golden section within `reach` on both sides.
template <class Number>
void refine(Candidate& candidate, Number TracerModel::*number, double reach, const Match& match, double penalty) {
    constexpr double kGolden = 0.6180339887498949;
    double low = candidate.model.*number - reach;
    double high = candidate.model.*number + reach;
    const auto bitsAt = [&](double value) {
        TracerModel model = candidate.model;
        model.*number = value;
        return match.bits(model, kMoreRays);
    };
    double x = high - kGolden * (high - low), y = low + kGolden * (high - low);
    double atX = bitsAt(x), atY = bitsAt(y);
    for (int round = 0; round < 32; ++round) {
        if (atX < atY) {
            high = y;
            y = x;
            atY = atX;
            x = high - kGolden * (high - low);
            atX = bitsAt(x);
        } else {
            low = x;
            x = y;
            atX = atY;
            y = low + kGolden * (high - low);
            atY = bitsAt(y);
        }
    }
    TracerModel model = candidate.model;
    model.*number = 0.5 * (low + high);
    const double bits = match.bits(model, kMoreRays) + penalty;
    if (bits < candidate.bits) candidate = {model, bits};
}

void sortCandidates(std::vector<Candidate>& candidates, std::size_t most) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.bits < y.bits; });
    if (candidates.size() > most) candidates.resize(most);
}

double rounded(double value, double step) {
    return std::round(value / step) * step;
}

// Appends the model with its numbers rounded to such as people write: where answers are not refined, fits are rough.
void appendRounded(std::vector<TracerModel>& models, const TracerModel& model, const Match& match) {
    const auto add = [&](const TracerModel& other) {
        if (other.runScale > 0 && std::find(models.begin(), models.end(), other) == models.end()) {
            models.push_back(other);
        }
    };
    constexpr double kDegrees = std::numbers::pi / 180;
    std::vector<TracerModel> lines{model};
    TracerModel line = model;
    line.gain = model.gain > 0 ? 1 : -1;
    const double plain = model.gain > 0 ? 0 : 1;
    const double lift = match.densestLift(line, line.gain);
    for (const double other : {plain, lift, rounded(lift, 0.05), rounded(lift, 0.01)}) {
        line.lift = other;
        lines.push_back(line);
    }
    for (const TracerModel& one : lines) {
        add(one);
        for (const double step : {0.25, 0.1, 0.05}) {
            TracerModel other = one;
            if (model.runScale != 1) other.runScale = rounded(model.runScale, step);
            if (model.turn != 0) other.turn = rounded(model.turn, (step > 0.06 ? 15 : 1) * kDegrees);
            if (model.bias != 0) other.bias = rounded(model.bias, step / 50);
            add(other);
        }
        if (model.runScale == 1) continue;
        for (const double off : {-0.05, 0.05}) {
            TracerModel other = one;
            other.runScale = rounded(model.runScale, 0.05) + off;
            add(other);
        }
    }
}

double penalty(const Candidate& one) {
    return conventionFaults(one.model) * kFaultBits;
}

// Returns the best combinations of a direction and a reading, compared first by few rays and then by more.
std::vector<Candidate> combinations(const AnsweredRays& given, const TracerModel& begin, const HeightField& field,
                                    const Match& match, Work& work) {
    constexpr double kMostFaults = 2;
    std::vector<TracerModel> heads = directions(begin);
    for (const TracerModel& model : reportedDirections(given, begin, field)) heads.push_back(model);
    std::vector<Candidate> candidates;
    const double before = conventionFaults(begin);
    const std::vector<TracerModel> ways = readings(field);
    for (const TracerModel& direction : heads) {
        work.throwIfStopped();
        const double turned = conventionFaults(direction) - before;
        for (const TracerModel& reading : ways) {
            TracerModel model = joined(direction, reading);
            if (turned >= kMostFaults && !(model == direction)) continue;
            const double faults = conventionFaults(model) - before;
            if (faults > kMostFaults) continue;
            const double bits = match.bits(model, kFewRays) + faults * kFaultBits;
            candidates.push_back({model, bits});
        }
    }
    sortCandidates(candidates, kFinalists);
    for (Candidate& one : candidates) one.bits = match.bits(one.model, kMoreRays) + penalty(one);
    return candidates;
}

// Improves the scale of the run and the turn where they differ from those of `begin`.
void refineDirection(Candidate& one, const TracerModel& begin, const Match& match) {
    constexpr double kScaleReach = 0.09, kTurnReach = 0.06;
    for (int round = 0; round < 2; ++round) {
        const bool scaled = one.model.runScale != begin.runScale, turned = one.model.turn != begin.turn;
        if (scaled) refine(one, &TracerModel::runScale, one.model.runScale * kScaleReach, match, penalty(one));
        if (turned) refine(one, &TracerModel::turn, kTurnReach, match, penalty(one));
        if (!(scaled && turned)) break;
    }
}

// Appends those of the best that fit better with a bias of the answers, which hides the other numbers.
void appendBiased(std::vector<Candidate>& candidates, const TracerModel& begin, const Match& match) {
    constexpr std::size_t kBiased = 6;
    constexpr double kBiasReach = 0.04;
    const std::size_t count = std::min(candidates.size(), kBiased);
    for (std::size_t n = 0; n < count; ++n) {
        Candidate one = candidates[n];
        one.model.bias = 1e-6;
        one.bits = HUGE_VAL;
        for (int round = 0; round < 2; ++round) {
            refine(one, &TracerModel::bias, round == 0 ? kBiasReach : kBiasReach / 8, match, penalty(one));
            one.bits += 1e-9;
            refineDirection(one, begin, match);
        }
        if (one.bits < candidates[n].bits) candidates.push_back(one);
    }
}

// Returns the best with the heights as they are or inverted, without a bias: what most tracers have.
std::vector<TracerModel> withPlainHeights(const std::vector<Candidate>& candidates) {
    constexpr std::size_t kPlain = 10;
    std::vector<TracerModel> models;
    for (std::size_t n = 0; n < std::min(candidates.size(), kPlain); ++n) {
        TracerModel plain = candidates[n].model;
        plain.lift = plain.gain > 0 ? 0 : 1;
        plain.gain = plain.gain > 0 ? 1 : -1;
        if (std::find(models.begin(), models.end(), plain) == models.end()) models.push_back(plain);
    }
    return models;
}

}  // namespace

std::vector<TracerModel> surfaceMatches(const AnsweredRays& given, const TracerModel& begin, ModelFields& fields,
                                        std::size_t most, double late, Work& work) {
    const Match match(given, late, fields);
    if (match.rays() < 8) return {};
    std::vector<Candidate> candidates = combinations(given, begin, fields.given(), match, work);
    sortCandidates(candidates, most);
    for (Candidate& candidate : candidates) {
        work.throwIfStopped();
        refineDirection(candidate, begin, match);
    }
    sortCandidates(candidates, most);
    std::vector<TracerModel> models = withPlainHeights(candidates);
    if (begin.bias == 0 && late == 0) appendBiased(candidates, begin, match);
    sortCandidates(candidates, most);
    // The likeliest also with rounded numbers.
    constexpr std::size_t kRounded = 5;
    for (std::size_t n = 0; n < candidates.size(); ++n) {
        if (n < kRounded) {
            appendRounded(models, candidates[n].model, match);
        } else {
            models.push_back(candidates[n].model);
        }
    }
    return models;
}

}  // namespace relief
