#include "measuring/diagnose/search_faults.h"

#include <algorithm>
#include <cmath>

#include "measuring/diagnose/layer_fit.h"
#include "measuring/diagnose/searched_rays.h"
#include "measuring/quantiles.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

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
        const std::optional<TracerModel> refined = fittedLayers(rays_, fields_.given(), evidence_.lattice.layers);
        if (refined) {
            found.push_back(ofLayers(*refined));
        } else if (evidence_.lattice.layers > 0) {
            offerLattice(found, evidence_.lattice);
        }
        if (byShape) found.push_back(explanationByShape(rays_, evidence_));
        return found;
    }

    // The explanation by the model with this search.
    Explanation by(const TracerModel& model) { return hasLayers(model) ? ofLayers(model) : predicted(model); }

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
        TracerModel model = model_;
        model.search = ModelSearch::Layers;
        model.layers = lattice.layers;
        found.push_back(ofLayers(model));
        if (shift == 0 || model_.bias != 0) return;
        for (const double more : {0.0, 1.0, 2.0, 3.0}) {
            model.bias = more * layer - shift;
            found.push_back(Search(rays_.given(), evidence_, model, fields_, work_).ofLayers(model));
        }
    }

    // The explanation by a model with layers.
    Explanation ofLayers(const TracerModel& model) {
        const std::vector<Hit> answers = predict(model, rays_.given().rays, fields_, work_);
        Explanation out{model, std::vector<RayVerdict>(rays_.size()), {}, false};
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (rays_.gap(r, rays_.exact(r)) <= kRightTexels || rays_.touches(r)) {
                out.rays[r].explained = true;
                continue;
            }
            const double layers = layersOf(model, rays_.given().rays[r], fields_.given());
            const double rounding = kFloatError * layers * rays_.run(r);
            if (!isNextLayer(r, answers[r], model, layers) && rays_.gap(r, answers[r]) > kRightTexels + rounding) {
                continue;
            }
            out.rays[r].explained = true;
            out.rays[r].sharp = isSharp(r, answers[r]);
            out.rays[r].cause = rays_.passed(r) ? Fault::MissedSpike : lateFault(r, model, layers);
        }
        // No one number describes layers that depend on the view.
        nameCauses(out, model.grazingLayers > 0 ? 0 : model.layers);
        return out;
    }
    // Returns true if the answer lies a layer from the predicted one, at the surface: rounding decides whether a layer
    // there is behind it.
    bool isNextLayer(std::size_t r, const Hit& predicted, const TracerModel& model, double layers) const {
        if (!rays_.isHit(r) || predicted.outcome != Outcome::Hit || model.search != ModelSearch::Layers) return false;
        const double layer = std::ldexp(1 / layers, -model.halvings);
        constexpr double kAtSurface = 1e-4;
        const double off = rays_.answer(r).lambda - predicted.lambda;
        return std::abs(std::abs(off) - layer) < kInexact &&
               std::abs(rays_.surfaceGap(r, off > 0 ? rays_.lambda(r) - layer : rays_.lambda(r))) < kAtSurface;
    }
    // Returns the fault of an answer near the first hit.
    Fault lateFault(std::size_t r, const TracerModel& model, double layers) const {
        if (model.search == ModelSearch::Secant) return Fault::StairSteps;
        // Halved too seldom.
        if (model.search == ModelSearch::Middle || model.halvings > 0) return Fault::NoRefinement;
        return rays_.lateFault(r, static_cast<int>(std::lround(layers)));
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

Explanation explanationBy(const AnsweredRays& given, const SearchEvidence& evidence, const TracerModel& model,
                          ModelFields& fields, Work& work) {
    return Search(given, evidence, model, fields, work).by(model);
}

}  // namespace relief
