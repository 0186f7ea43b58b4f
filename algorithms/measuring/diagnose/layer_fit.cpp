#include "measuring/diagnose/layer_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measuring/diagnose/layer_bracket.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Numbers of layers that people write.
constexpr std::array kUsualLayers{4,  5,  6,  8,  10, 12, 15, 16,  20,  24,  25,  30,  32,  40,
                                  48, 50, 60, 64, 75, 80, 96, 100, 120, 128, 150, 192, 200, 256};
// Numbers of layers along the normal and along the plane that people write.
constexpr std::array<std::array<int, 2>, 14> kUsualPairs{{{8, 32},
                                                          {4, 16},
                                                          {8, 16},
                                                          {8, 64},
                                                          {16, 64},
                                                          {4, 32},
                                                          {16, 32},
                                                          {10, 20},
                                                          {10, 30},
                                                          {15, 30},
                                                          {1, 30},
                                                          {5, 15},
                                                          {20, 60},
                                                          {32, 128}}};
// Pairs of these are tried as well where only the search is in question.
constexpr std::array kPaired{1, 2, 4, 5, 8, 10, 12, 15, 16, 20, 24, 25, 30, 32, 40, 48, 50, 60, 64, 80, 96, 100, 128};
constexpr int kMostHalvings = 10;

// The searches that differ in what they do between two layers: 0 is the secant, 1 the layer itself; 2 n and 2 n + 1 end
// in the middle and at the lower end after n halvings. If the errors are equal, the first is meant.
constexpr std::size_t kRefinements = 2 + 2 * kMostHalvings;
void setRefinement(TracerModel& model, std::size_t n) {
    model.search = n == 0 ? ModelSearch::Secant : n % 2 == 1 ? ModelSearch::Layers : ModelSearch::Middle;
    model.halvings = static_cast<int>(n / 2);
}

class Fit {
  public:
    Fit(const SearchedRays& rays, const HeightField& given) : rays_(rays), given_(given) {
        const std::size_t stride = std::max<std::size_t>(1, rays.size() / 96);
        for (std::size_t r = 0; r < rays.size(); ++r) {
            all_.push_back(r);
            if (r % stride == 0) few_.push_back(r);
        }
    }

    // Returns true if an exact search does not give the answers, and most lie near its answers.
    bool worthwhile() const {
        std::size_t wrong = 0, distant = 0;
        for (const std::size_t r : few_) {
            wrong += isWrong(r) ? 1 : 0;
            constexpr double kLayer = 0.1;
            distant += rays_.isHit(r) && std::abs(rays_.answer(r).lambda - rays_.exact(r).lambda) <= kLayer ? 0 : 1;
        }
        return wrong * 20 >= few_.size() && 2 * distant <= few_.size();
    }

    // Tries these layers with all refinements.
    void offer(int layers, int grazingLayers = 0, bool squareCosine = false) {
        TracerModel model = rays_.model();
        model.layers = layers;
        model.grazingLayers = grazingLayers;
        model.squareCosine = squareCosine;
        if (!couldBe(model)) return;
        const Errors few = errors(model, few_);
        bool any = false;
        for (std::size_t n = 0; n < kRefinements; ++n) any = any || few.givesNearlyAll(n, few_.size());
        if (!any) return;
        const Errors all = errors(model, all_);
        for (std::size_t n = 0; n < kRefinements; ++n) {
            if (!few.givesNearlyAll(n, few_.size()) || !(all.sum[n] < least_)) continue;
            least_ = all.sum[n];
            setRefinement(model, n);
            best_ = model;
        }
    }

    const std::optional<TracerModel>& best() const { return best_; }

  private:
    bool isWrong(std::size_t r) const { return rays_.gap(r, rays_.exact(r)) > kRightTexels; }
    double layersAt(const TracerModel& model, std::size_t r) const {
        return layersOf(model, rays_.given().rays[r], given_);
    }

    // Returns true if nearly all answers lie between the layers that they must lie between.
    bool couldBe(const TracerModel& model) const {
        std::size_t outside = 0;
        for (const std::size_t r : few_) {
            const double layers = layersAt(model, r);
            const std::optional<LayerBracket> bracket = firstLayer(rays_.surface(r), layers);
            const double same = kRightTexels / rays_.run(r) + kFloatError * layers;
            const double at = rays_.lambda(r);
            const bool in = bracket ? rays_.isHit(r) && at >= bracket->above - same && at <= bracket->below + same
                                    : !rays_.isHit(r);
            if (!in && ++outside * 10 > few_.size()) return false;
        }
        return true;
    }

    // Of each refinement: the sum of the errors, texels, none more than that of a wrong answer; the number of right
    // answers; and of the answers that an exact search does not give, how many are right.
    struct Errors {
        std::array<double, kRefinements> sum{};
        std::array<std::size_t, kRefinements> same{}, sameOfWrong{};
        std::size_t wrong = 0;

        bool givesNearlyAll(std::size_t n, std::size_t rays) const {
            return same[n] * 10 >= rays * 9 && sameOfWrong[n] * 10 >= wrong * 9;
        }
        void add(std::size_t n, double error, bool isWrong) {
            sum[n] += std::min(error, kRightTexels);
            same[n] += error <= kRightTexels ? 1 : 0;
            sameOfWrong[n] += error <= kRightTexels && isWrong ? 1 : 0;
        }
    };
    Errors errors(const TracerModel& model, const std::vector<std::size_t>& rays) const {
        Errors out;
        for (const std::size_t r : rays) {
            const bool wrong = isWrong(r);
            out.wrong += wrong ? 1 : 0;
            const SampledSurface surface = rays_.surface(r);
            std::optional<LayerBracket> bracket = firstLayer(surface, layersAt(model, r));
            const auto add = [&](std::size_t n, double lambda) {
                out.add(n, bracket ? rays_.gapAt(r, std::min(lambda, 1.0)) : rays_.gap(r, Hit::none(Outcome::Miss)),
                        wrong);
            };
            if (!bracket) {
                for (std::size_t n = 0; n < kRefinements; ++n) add(n, 1);
                continue;
            }
            add(0, bracket->secant());
            add(1, bracket->below);
            for (std::size_t n = 2; n < kRefinements; n += 2) {
                bracket->halve(surface);
                add(n, bracket->middle());
                add(n + 1, bracket->below);
            }
        }
        return out;
    }

    const SearchedRays& rays_;
    const HeightField& given_;
    std::vector<std::size_t> all_, few_;
    std::optional<TracerModel> best_;
    double least_ = HUGE_VAL;
};

}  // namespace

std::optional<TracerModel> fittedLayers(const SearchedRays& rays, const HeightField& given, int lattice) {
    Fit fit(rays, given);
    if (!fit.worthwhile()) return std::nullopt;
    if (lattice > 0) {
        // Halvings of whole layers end at layers as well.
        fit.offer(lattice);
        for (int layers = lattice; layers % 2 == 0 && layers > 2; layers /= 2) fit.offer(layers / 2);
        // The search that nothing refines is another's: its answers may be moved.
        if (fit.best() && fit.best()->layers == lattice) return std::nullopt;
        return fit.best();
    }
    for (const int layers : kUsualLayers) fit.offer(layers);
    const auto offerPair = [&](int normal, int plane) {
        fit.offer(normal, plane);
        if (given.width() != given.height()) fit.offer(normal, plane, true);
    };
    for (const std::array<int, 2>& pair : kUsualPairs) offerPair(pair[0], pair[1]);
    if (fit.best() || !(rays.model() == TracerModel{})) return fit.best();
    for (const int normal : kPaired) {
        for (const int plane : kPaired) {
            if (normal != plane) offerPair(normal, plane);
        }
    }
    return fit.best();
}

}  // namespace relief
