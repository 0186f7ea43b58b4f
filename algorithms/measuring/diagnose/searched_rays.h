// A tracer's rays under one model of its conventions, with an exact search: where the model's rays run through the
// surface, and where the tracer answered on them.
#pragma once

#include <vector>

#include "measuring/diagnose/chords.h"
#include "measuring/diagnose/search_faults.h"
#include "measuring/diagnose/tracer_model.h"
#include "relief/sampled_surface.h"

namespace relief {

// An error of lambda that is not rounding.
inline constexpr double kInexact = 2e-5;

// Keeps references to `given`, `fields` and `work`. Not thread-safe: chords are computed when they are first needed.
class SearchedRays {
  public:
    // Throws Cancelled.
    SearchedRays(const AnsweredRays& given, const TracerModel& model, ModelFields& fields, Work& work);

    std::size_t size() const { return given_.size(); }
    const AnsweredRays& given() const { return given_; }
    // The conventions; its search is exact.
    const TracerModel& model() const { return model_; }
    const Hit& answer(std::size_t r) const { return given_.answers[r]; }
    bool isHit(std::size_t r) const { return answer(r).outcome == Outcome::Hit; }
    // The model's answers.
    const std::vector<Hit>& exact() const { return exact_; }
    const Hit& exact(std::size_t r) const { return exact_[r]; }
    // By how much errors of lambda are multiplied to have texels: at least 1.
    double run(std::size_t r) const { return runs_[r]; }
    // Returns the distance of the answer from a predicted one, texels.
    double gap(std::size_t r, const Hit& predicted) const;
    // Returns the distance of the answer from that of a tracer which stopped at this place, without bias.
    double gapAt(std::size_t r, double lambda) const;
    // Returns the place on the ray at which the tracer stopped, lambda, without the bias of its answer.
    double lambda(std::size_t r) const;
    // Returns the surface along the model's ray; refers to this object.
    SampledSurface surface(std::size_t r) const { return {placed_.field, ray(r)}; }
    // Returns the surface minus the ray, heights.
    double surfaceGap(std::size_t r, double at) const { return surface(r).gapAt(at); }
    // Returns solidChords() of the model's ray; empty if it misses.
    const std::vector<Chord>& chords(std::size_t r);
    // Returns barelyTouches() for the answer.
    bool touches(std::size_t r);
    // Returns true if the tracer answered behind the first chord.
    bool passed(std::size_t r);

    // Returns the fault of an answer that is late in the first chord. layers: 0 if unknown.
    Fault lateFault(std::size_t r, int layers) const;

  private:
    ViewRay ray(std::size_t r) const { return modelRay(model_, placed_, given_.rays[r], fields_.given()); }
    double bias(std::size_t r) const { return lambdaBias(model_, given_.rays[r], fields_.given()); }

    const AnsweredRays& given_;
    TracerModel model_;
    const ModelFields& fields_;
    ModelFields::Placed placed_;
    std::vector<Hit> exact_;
    std::vector<double> runs_;
    std::vector<std::vector<Chord>> chords_;
};

// Sets the faults of the search to those that explain any ray. layers: the number that they are reported with; 0 if it
// is not known.
void nameCauses(Explanation& explanation, int layers);

// Returns the explanation by the kind of the errors alone: where the answers lie before, in and behind the intervals in
// which the rays are below the surface.
Explanation explanationByShape(SearchedRays& rays, const SearchEvidence& evidence);

}  // namespace relief
