#include "measuring/diagnose/search_faults.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measuring/diagnose/searched_rays.h"
#include "measuring/quantiles.h"
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

class Search {
  public:
    Search(const AnsweredRays& given, const SearchEvidence& evidence, const TracerModel& model, ModelFields& fields,
           Work& work)
        : rays_(given, model, fields, work), evidence_(evidence), model_(rays_.model()), fields_(fields), work_(work) {}

    std::vector<Explanation> all(bool byShape) {
        std::vector<Explanation> found;
        found.push_back(predicted(model_));
        if (model_.bias == 0 && model_.biasTexels == 0) offerBias(found);
        for (const bool limited : {model_.limited, !model_.limited}) {
            TracerModel one = model_;
            one.search = ModelSearch::OneSample;
            one.limited = limited;
            found.push_back(predicted(one));
        }
        if (evidence_.lattice.layers > 0) {
            offerLattice(found, evidence_.lattice);
        } else if (const std::array<int, 2> few = secantLayers(); few[0] > 0) {
            offerLayers(found, ModelSearch::Secant, few[0], few[1]);
        }
        if (byShape) found.push_back(explanationByShape(rays_, evidence_));
        return found;
    }

  private:
    // Returns true if an answer, within the ray, is predicted to the rounding of float.
    bool isSharp(std::size_t r, const Hit& predicted) const {
        const Hit& answer = rays_.answer(r);
        if (answer.outcome != Outcome::Hit || predicted.outcome != Outcome::Hit)
            return answer.outcome == predicted.outcome;
        return std::abs(answer.lambda - predicted.lambda) <= kInexact;
    }

    // The explanation by a model that predicts the answers.
    Explanation predicted(const TracerModel& model) {
        const bool exact = model == model_;
        const std::vector<Hit> answers = exact ? rays_.exact() : predict(model, rays_.given().rays, fields_, work_);
        Explanation out{model, std::vector<RayVerdict>(rays_.size()), {}, false};
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            out.rays[r].explained = rays_.gap(r, answers[r]) <= kRightTexels || (exact && rays_.touches(r));
            out.rays[r].sharp = isSharp(r, answers[r]);
        }
        return out;
    }

    // A constant distance in front of the surface: of lambda, or along the ray.
    void offerBias(std::vector<Explanation>& found) {
        for (const bool along : {false, true}) {
            std::vector<double> off;
            for (std::size_t r = 0; r < rays_.size(); ++r) {
                if (!rays_.isHit(r) || rays_.exact(r).outcome != Outcome::Hit || rays_.answer(r).lambda <= 0) continue;
                const double length =
                    along ? std::hypot(rays_.given().rays.a[r], rays_.given().rays.b[r], fields_.given().slabTexels())
                          : 1;
                off.push_back((rays_.exact(r).lambda - rays_.answer(r).lambda) * length);
            }
            if (off.size() < 8) return;
            const double bias = upperMedian(off);
            constexpr double kLeast = 1e-5, kSame = 1e-3;
            // A tenth of the answers must have it, or the model need not be tried.
            const auto same = static_cast<std::size_t>(
                std::count_if(off.begin(), off.end(), [&](double one) { return std::abs(one - bias) <= kSame; }));
            if (std::abs(bias) < kLeast || same * 10 < off.size()) continue;
            TracerModel model = model_;
            (along ? model.biasTexels : model.bias) = bias;
            found.push_back(predicted(model));
        }
    }

    // Layers whose answers are moved by a bias, which is known but for multiples of a layer.
    void offerLattice(std::vector<Explanation>& found, const Lattice& lattice) {
        const double layer = 1.0 / lattice.layers;
        const double shift = std::abs(lattice.phase) < 1e-5 ? 0 : lattice.phase;
        offerLayers(found, ModelSearch::Layers, lattice.layers);
        if (shift == 0 || model_.bias != 0) return;
        for (const double more : {0.0, 1.0, 2.0, 3.0}) {
            TracerModel model = model_;
            model.bias = more * layer - shift;
            Search(rays_.given(), evidence_, model, fields_, work_)
                .offerLayers(found, ModelSearch::Layers, lattice.layers);
        }
    }

    // Returns the number of layers between which a line gives nearly all answers; 0 if there is none. Second: that
    // along the plane if it depends on the view, otherwise 0.
    std::array<int, 2> secantLayers() {
        std::size_t wrong = 0, distant = 0;
        RayBlock few;
        std::vector<Hit> answers;
        const std::size_t stride = std::max<std::size_t>(1, rays_.size() / 96);
        for (std::size_t r = 0; r < rays_.size(); r += stride) {
            few.push(rays_.given().rays[r]);
            answers.push_back(rays_.answer(r));
            wrong += rays_.gap(r, rays_.exact(r)) > kRightTexels ? 1 : 0;
            constexpr double kLayer = 0.1;
            distant += rays_.isHit(r) && std::abs(rays_.answer(r).lambda - rays_.exact(r).lambda) <= kLayer ? 0 : 1;
        }
        // An exact search explains them; or they lie further from its answers than a layer.
        if (wrong * 20 < few.size() || 2 * distant > few.size()) return {};
        TracerModel model = model_;
        model.search = ModelSearch::Secant;
        std::vector<std::array<int, 2>> tried;
        for (const int layers : kUsualLayers) tried.push_back({layers, 0});
        tried.insert(tried.end(), kUsualPairs.begin(), kUsualPairs.end());
        for (const std::array<int, 2>& layers : tried) {
            model.layers = layers[0];
            model.grazingLayers = layers[1];
            const std::vector<Hit> predicted = predict(model, few, fields_, work_);
            std::size_t same = 0;
            for (std::size_t r = 0; r < few.size(); ++r) {
                same += answerError(answers[r], predicted[r], few[r]) <= kRightTexels ? 1 : 0;
            }
            if (same * 10 >= few.size() * 9) return layers;
        }
        return {};
    }

    void offerLayers(std::vector<Explanation>& found, ModelSearch search, int layers, int grazing = 0) {
        TracerModel model = model_;
        model.search = search;
        model.layers = layers;
        model.grazingLayers = grazing;
        const std::vector<Hit> answers = predict(model, rays_.given().rays, fields_, work_);
        Explanation out{model, std::vector<RayVerdict>(rays_.size()), {}, false};
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (rays_.gap(r, rays_.exact(r)) <= kRightTexels || rays_.touches(r)) {
                out.rays[r].explained = true;
                continue;
            }
            // Rounding decides whether a layer at the surface is behind it.
            const double layer = 1.0 / layers;
            constexpr double kAtSurface = 1e-4;
            const double off = rays_.answer(r).lambda - answers[r].lambda;
            const bool next =
                rays_.isHit(r) && answers[r].outcome == Outcome::Hit && search == ModelSearch::Layers &&
                std::abs(std::abs(off) - layer) < kInexact &&
                std::abs(rays_.surfaceGap(r, off > 0 ? rays_.lambda(r) - layer : rays_.lambda(r))) < kAtSurface;
            const double rounding = kFloatError * layers * rays_.run(r);
            if (!next && rays_.gap(r, answers[r]) > kRightTexels + rounding) continue;
            out.rays[r].explained = true;
            out.rays[r].sharp = isSharp(r, answers[r]);
            out.rays[r].cause = rays_.passed(r)                 ? Fault::MissedSpike
                                : search == ModelSearch::Secant ? Fault::StairSteps
                                                                : rays_.lateFault(r, layers);
        }
        // No one number describes layers that depend on the view.
        nameCauses(out, grazing > 0 ? 0 : layers);
        found.push_back(std::move(out));
    }

    SearchedRays rays_;
    const SearchEvidence& evidence_;
    const TracerModel& model_;
    ModelFields& fields_;
    Work& work_;
};

}  // namespace

std::vector<Explanation> explanations(const AnsweredRays& given, const SearchEvidence& evidence,
                                      const TracerModel& model, bool byShape, ModelFields& fields, Work& work) {
    return Search(given, evidence, model, fields, work).all(byShape);
}

}  // namespace relief
