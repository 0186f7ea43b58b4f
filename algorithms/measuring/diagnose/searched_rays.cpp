#include "measuring/diagnose/searched_rays.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Fewer layers than the first number are coarse: their steps are seen everywhere. More than the second are fine: what
// is seen is that the answer is not refined. Between them the error decides, texels.
constexpr int kCoarseLayers = 24;
constexpr int kFineLayers = 64;
constexpr double kStairTexels = 1;

TracerModel withExactSearch(TracerModel model) {
    model.search = ModelSearch::Exact;
    return model;
}

}  // namespace

SearchedRays::SearchedRays(const AnsweredRays& given, const TracerModel& model, ModelFields& fields, Work& work)
    : given_(given),
      model_(withExactSearch(model)),
      fields_(fields),
      placed_(fields.of(model)),
      exact_(predict(model_, given.rays, fields, work)),
      chords_(given.size()) {
    for (std::size_t r = 0; r < given.size(); ++r) {
        runs_.push_back(std::max(1.0, std::hypot(given.rays.a[r], given.rays.b[r])));
    }
}

double SearchedRays::gap(std::size_t r, const Hit& predicted) const {
    return answerError(answer(r), predicted, given_.rays[r]);
}

double SearchedRays::gapAt(std::size_t r, double lambda) const {
    return gap(r, {Outcome::Hit, std::max(0.0, lambda - bias(r))});
}

double SearchedRays::lambda(std::size_t r) const {
    return answer(r).lambda + bias(r);
}

const std::vector<Chord>& SearchedRays::chords(std::size_t r) {
    if (chords_[r].empty() && exact_[r].outcome == Outcome::Hit) {
        chords_[r] = solidChords(placed_.field, ray(r), exact_[r].lambda + bias(r));
    }
    return chords_[r];
}

bool SearchedRays::touches(std::size_t r) {
    if (exact_[r].outcome != Outcome::Hit) return false;
    Hit moved = answer(r);
    moved.lambda = lambda(r);
    return barelyTouches(placed_.field, ray(r), chords(r), moved, runs_[r]);
}

bool SearchedRays::passed(std::size_t r) {
    if (exact_[r].outcome != Outcome::Hit) return false;
    return !isHit(r) || lambda(r) > chords(r).front().out + 1e-9;
}

Fault SearchedRays::lateFault(std::size_t r, int layers) const {
    if (layers == 0 || layers > kFineLayers) return Fault::NoRefinement;
    if (layers < kCoarseLayers) return Fault::StairSteps;
    return gap(r, exact_[r]) > kStairTexels ? Fault::StairSteps : Fault::NoRefinement;
}

void nameCauses(Explanation& explanation, int layers) {
    std::set<Fault> causes;
    for (const RayVerdict& ray : explanation.rays) {
        if (ray.cause) causes.insert(*ray.cause);
    }
    for (const Fault fault : causes) explanation.searchFaults.push_back({fault, static_cast<double>(layers)});
}

}  // namespace relief
