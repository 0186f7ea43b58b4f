#include "measuring/diagnose/search_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "relief/sampled_surface.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Fewer layers than the first number are coarse: their steps are seen everywhere. More than the second are fine: what
// is seen is that the answer is not refined. Between them the error decides, texels.
constexpr int kCoarseLayers = 24;
constexpr int kFineLayers = 64;
constexpr double kStairTexels = 1;
constexpr int kMostLayers = 512;
// Numbers of layers that people write.
constexpr std::array kUsualLayers{4,  5,  6,  8,  10, 12, 15, 16,  20,  24,  25,  30,  32,  40,
                                  48, 50, 60, 64, 75, 80, 96, 100, 120, 128, 150, 192, 200, 256};
// Deepest answer within the surface, lambda, of a search that stops behind it.
constexpr double kDeepest = 0.13;
// An error of lambda that is not rounding.
constexpr double kInexact = 2e-5;

class Search {
  public:
    Search(const AnsweredRays& given, const SearchEvidence& evidence, const TracerModel& model, ModelFields& fields,
           Work& work)
        : given_(given), evidence_(evidence), model_(model), fields_(fields), work_(work), placed_(fields.of(model)) {
        model_.search = ModelSearch::Exact;
        exact_ = predict(model_, given_.rays, fields_, work_);
        chords_.resize(given_.size());
        for (std::size_t r = 0; r < given_.size(); ++r)
            runs_.push_back(std::max(1.0, std::hypot(given.rays.a[r], given.rays.b[r])));
    }

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
        if (const Lattice lattice = latticeOf(given_); lattice.layers > 0) {
            offerLattice(found, lattice);
        } else if (const int few = secantLayers(); few > 0) {
            offerLayers(found, ModelSearch::Secant, few);
        }
        if (byShape) found.push_back(geometric());
        return found;
    }

  private:
    double gap(std::size_t r, const Hit& predicted) const {
        return answerError(given_.answers[r], predicted, given_.rays[r]);
    }
    // Returns true if an answer, within the ray, is predicted to the rounding of float.
    bool isSharp(std::size_t r, const Hit& predicted) const {
        const Hit& answer = given_.answers[r];
        if (answer.outcome != Outcome::Hit || predicted.outcome != Outcome::Hit)
            return answer.outcome == predicted.outcome;
        return std::abs(answer.lambda - predicted.lambda) <= kInexact;
    }
    bool isHit(std::size_t r) const { return given_.answers[r].outcome == Outcome::Hit; }
    // The place on the ray at which the tracer stopped, without the bias of its answer.
    double lambda(std::size_t r) const {
        return given_.answers[r].lambda + lambdaBias(model_, given_.rays[r], fields_.given());
    }
    ViewRay ray(std::size_t r) const { return modelRay(model_, placed_, given_.rays[r], fields_.given()); }

    const std::vector<Chord>& chords(std::size_t r) {
        if (chords_[r].empty() && exact_[r].outcome == Outcome::Hit) {
            const double first = exact_[r].lambda + lambdaBias(model_, given_.rays[r], fields_.given());
            chords_[r] = solidChords(placed_.field, ray(r), first);
        }
        return chords_[r];
    }
    bool touches(std::size_t r) {
        if (exact_[r].outcome != Outcome::Hit) return false;
        Hit answer = given_.answers[r];
        answer.lambda = lambda(r);
        return barelyTouches(placed_.field, ray(r), chords(r), answer, runs_[r]);
    }
    double surfaceGap(std::size_t r, double at) const { return SampledSurface(placed_.field, ray(r)).gapAt(at); }

    // The explanation by a model that predicts the answers.
    Explanation predicted(const TracerModel& model) {
        const bool exact = model == model_;
        const std::vector<Hit> answers = exact ? exact_ : predict(model, given_.rays, fields_, work_);
        Explanation out{model, std::vector<RayVerdict>(given_.size()), {}, false};
        for (std::size_t r = 0; r < given_.size(); ++r) {
            out.rays[r].explained = gap(r, answers[r]) <= kRightTexels || (exact && touches(r));
            out.rays[r].sharp = isSharp(r, answers[r]);
        }
        return out;
    }

    // A constant distance in front of the surface: of lambda, or along the ray.
    void offerBias(std::vector<Explanation>& found) {
        for (const bool along : {false, true}) {
            std::vector<double> off;
            for (std::size_t r = 0; r < given_.size(); ++r) {
                if (!isHit(r) || exact_[r].outcome != Outcome::Hit || given_.answers[r].lambda <= 0) continue;
                const double length =
                    along ? std::hypot(given_.rays.a[r], given_.rays.b[r], fields_.given().slabTexels()) : 1;
                off.push_back((exact_[r].lambda - given_.answers[r].lambda) * length);
            }
            if (off.size() < 8) return;
            const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
            std::nth_element(off.begin(), middle, off.end());
            constexpr double kLeast = 1e-5;
            if (std::abs(*middle) < kLeast) continue;
            TracerModel model = model_;
            (along ? model.biasTexels : model.bias) = *middle;
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
            Search(given_, evidence_, model, fields_, work_).offerLayers(found, ModelSearch::Layers, lattice.layers);
        }
    }

    // Returns the number of layers between which a line gives nearly all answers; 0 if there is none.
    int secantLayers() {
        std::size_t wrong = 0;
        RayBlock few;
        std::vector<Hit> answers;
        const std::size_t stride = std::max<std::size_t>(1, given_.size() / 96);
        for (std::size_t r = 0; r < given_.size(); r += stride) {
            few.push(given_.rays[r]);
            answers.push_back(given_.answers[r]);
            wrong += gap(r, exact_[r]) > kRightTexels ? 1 : 0;
        }
        // An exact search explains them.
        if (wrong * 20 < few.size()) return 0;
        TracerModel model = model_;
        model.search = ModelSearch::Secant;
        for (const int layers : kUsualLayers) {
            model.layers = layers;
            const std::vector<Hit> predicted = predict(model, few, fields_, work_);
            std::size_t same = 0;
            for (std::size_t r = 0; r < few.size(); ++r) {
                same += answerError(answers[r], predicted[r], few[r]) <= kRightTexels ? 1 : 0;
            }
            if (same * 10 >= few.size() * 9) return layers;
        }
        return 0;
    }

    void offerLayers(std::vector<Explanation>& found, ModelSearch search, int layers) {
        TracerModel model = model_;
        model.search = search;
        model.layers = layers;
        const std::vector<Hit> answers = predict(model, given_.rays, fields_, work_);
        Explanation out{model, std::vector<RayVerdict>(given_.size()), {}, false};
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (gap(r, exact_[r]) <= kRightTexels || touches(r)) {
                out.rays[r].explained = true;
                continue;
            }
            // Rounding decides whether a layer at the surface is behind it.
            const double layer = 1.0 / layers;
            constexpr double kAtSurface = 1e-4;
            const double off = given_.answers[r].lambda - answers[r].lambda;
            const bool next = isHit(r) && answers[r].outcome == Outcome::Hit && search == ModelSearch::Layers &&
                              std::abs(std::abs(off) - layer) < kInexact &&
                              std::abs(surfaceGap(r, off > 0 ? lambda(r) - layer : lambda(r))) < kAtSurface;
            const double rounding = kFloatError * layers * runs_[r];
            if (!next && gap(r, answers[r]) > kRightTexels + rounding) continue;
            out.rays[r].explained = true;
            out.rays[r].sharp = isSharp(r, answers[r]);
            out.rays[r].cause = passed(r)                       ? Fault::MissedSpike
                                : search == ModelSearch::Secant ? Fault::StairSteps
                                                                : lateFault(r, layers);
        }
        nameCauses(out, layers);
        found.push_back(std::move(out));
    }

    // The fault of an answer that is late in the first chord. layers: 0 if unknown.
    Fault lateFault(std::size_t r, int layers) const {
        if (layers == 0 || layers > kFineLayers) return Fault::NoRefinement;
        if (layers < kCoarseLayers) return Fault::StairSteps;
        return gap(r, exact_[r]) > kStairTexels ? Fault::StairSteps : Fault::NoRefinement;
    }

    // Returns true if the tracer answered behind the first chord.
    bool passed(std::size_t r) {
        if (exact_[r].outcome != Outcome::Hit) return false;
        if (!isHit(r)) return true;
        const std::vector<Chord>& all = chords(r);
        return lambda(r) > all.front().out + 1e-9;
    }

    // What a wrong answer looks like. Early: in front of the surface. Late: in the first chord. Later: on the surface
    // of a later chord; LaterIn: within one. Through: a miss.
    enum class Shape : std::uint8_t { Right, Early, Late, Later, LaterIn, Through, Limit, Other };
    Shape shape(std::size_t r) {
        if (given_.answers[r].outcome == Outcome::Limit) return Shape::Limit;
        if (gap(r, exact_[r]) <= kRightTexels || touches(r)) return Shape::Right;
        if (exact_[r].outcome != Outcome::Hit) return Shape::Other;
        if (!isHit(r)) return Shape::Through;
        const double at = lambda(r);
        const double same = kRightTexels / runs_[r];
        for (const Chord& chord : chords(r)) {
            if (at < chord.in - same) return Shape::Early;
            if (at > chord.out + same) continue;
            if (&chord == &chords(r).front()) return Shape::Late;
            return std::abs(at - chord.in) <= same || std::abs(surfaceGap(r, at)) <= kTouchDepth ? Shape::Later
                                                                                                 : Shape::LaterIn;
        }
        return Shape::Early;
    }

    // Returns how far behind its way into the surface an answer lies, lambda.
    double depthInChord(std::size_t r) {
        for (const Chord& chord : chords(r)) {
            if (lambda(r) <= chord.out) return lambda(r) - chord.in;
        }
        return 0;
    }

    Explanation geometric() {
        Explanation out{model_, std::vector<RayVerdict>(given_.size()), {}, true};
        shapes_.clear();
        std::array<std::size_t, 8> count{};
        for (std::size_t r = 0; r < given_.size(); ++r) {
            shapes_.push_back(shape(r));
            ++count[static_cast<std::size_t>(shapes_[r])];
            out.rays[r].explained = shapes_[r] == Shape::Right;
        }
        const auto of = [&](Shape one) { return count[static_cast<std::size_t>(one)]; };
        int layers = 0;
        const std::size_t passes = of(Shape::Later) + of(Shape::LaterIn) + of(Shape::Through);
        if (passes > 0) layers = refinedLayers();
        explainLimit(out);
        const bool exact = exactElsewhere();
        if (exact) explainEnded(out);
        if (exact && of(Shape::Late) + of(Shape::LaterIn) > 0) {
            explainOvershoots(out);
        } else {
            explainPasses(out, layers);
            explainLate(out);
        }
        nameCauses(out, 0);
        return out;
    }

    void cause(Explanation& out, std::size_t r, Fault fault) const {
        if (out.rays[r].explained) return;
        out.rays[r] = {true, fault, false};
    }

    // Returns the largest number of equal layers of which a search with refinement gives these answers: the surface is
    // found at the first multiple within a chord, and the answer lies in the layer before it. 0 if there is none.
    int refinedLayers() {
        std::vector<std::size_t> use;
        for (std::size_t r = 0; r < given_.size() && use.size() < 400; ++r) {
            if (exact_[r].outcome == Outcome::Hit && isHit(r)) use.push_back(r);
        }
        if (use.size() < 8) return 0;
        for (int n = kMostLayers; n >= 3; --n) {
            std::size_t wrong = 0;
            const std::size_t allowed = use.size() * 4 / 100;
            for (const std::size_t r : use) {
                const int found = layerThatFinds(r, n);
                const double same = kRightTexels / runs_[r];
                const bool in =
                    found > 0 && lambda(r) >= (found - 1.0) / n - same && lambda(r) <= found * 1.0 / n + same;
                if (!in && !touches(r) && ++wrong > allowed) break;
            }
            if (wrong <= allowed) return n;
        }
        return 0;
    }
    // Returns the first multiple of 1 / n within a chord; 0 if there is none.
    int layerThatFinds(std::size_t r, int n) {
        for (const Chord& chord : chords(r)) {
            const int first = std::max(1, static_cast<int>(std::ceil(chord.in * n - 1e-9)));
            if (first <= chord.out * n && first <= n) return first;
        }
        return 0;
    }

    // A limit that the tracer reports; or many answers in front of the surface after the same, largest number of steps
    // or at the same place.
    void explainLimit(Explanation& out) {
        std::vector<std::size_t> early;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] == Shape::Limit) cause(out, r, Fault::StepLimit);
            if (shapes_[r] == Shape::Early) early.push_back(r);
        }
        if (early.size() < 3) return;
        if (!evidence_.counts.empty()) {
            const std::uint32_t most = *std::max_element(evidence_.counts.begin(), evidence_.counts.end());
            std::size_t at = 0;
            for (const std::size_t r : early) at += evidence_.counts[r] == most ? 1 : 0;
            if (most > 1 && static_cast<double>(at) >= 0.8 * static_cast<double>(early.size())) {
                for (std::size_t r = 0; r < given_.size(); ++r) {
                    const bool stopped = shapes_[r] == Shape::Early || shapes_[r] == Shape::Through;
                    if (stopped && evidence_.counts[r] == most) cause(out, r, Fault::StepLimit);
                }
                return;
            }
        }
        for (const bool texels : {false, true}) {
            std::map<long long, std::size_t> places;
            const auto place = [&](std::size_t r) {
                const double at = texels ? lambda(r) * std::hypot(given_.rays.a[r], given_.rays.b[r]) / 64 : lambda(r);
                return std::llround(at * 1e5);
            };
            for (const std::size_t r : early) ++places[place(r)];
            const auto top = std::max_element(places.begin(), places.end(),
                                              [](const auto& x, const auto& y) { return x.second < y.second; });
            if (static_cast<double>(top->second) < 0.8 * static_cast<double>(early.size())) continue;
            for (const std::size_t r : early) {
                if (std::llabs(place(r) - top->first) <= 1) cause(out, r, Fault::StepLimit);
            }
            return;
        }
    }

    // Returns true if the wrong answers are not on the surface while most others are exactly on it: a search that
    // refines its answers, but whose steps lead through the surface, or end before it, here and there.
    bool exactElsewhere() const {
        std::size_t right = 0, exact = 0;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] != Shape::Right || !isHit(r) || exact_[r].outcome != Outcome::Hit) continue;
            ++right;
            exact += std::abs(given_.answers[r].lambda - exact_[r].lambda) <= kInexact ? 1 : 0;
        }
        return right >= 8 && exact * 2 >= right;
    }
    void explainOvershoots(Explanation& out) {
        for (std::size_t r = 0; r < given_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one == Shape::Early || one == Shape::Other || one == Shape::Limit) continue;
            Fault here = Fault::UnsafeMap;
            if (!evidence_.kinds.empty() && evidence_.kinds[r]) here = *evidence_.kinds[r];
            cause(out, r, here);
        }
    }
    // Long rays that end in the air, while the others end on the surface.
    void explainEnded(Explanation& out) {
        std::vector<double> ended, right;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] == Shape::Right) right.push_back(runs_[r]);
            if (shapes_[r] == Shape::Early) ended.push_back(runs_[r]);
        }
        if (ended.size() < 3 || right.empty()) return;
        const auto median = [](std::vector<double>& values) {
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            return *middle;
        };
        constexpr double kLonger = 1.2;
        if (median(ended) < kLonger * median(right)) return;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] == Shape::Early) cause(out, r, Fault::StepLimit);
        }
    }

    // Answers behind a chord that was passed. With constant layers, no chord that holds a multiple is passed.
    void explainPasses(Explanation& out, int layers) {
        std::vector<double> thin;  // lengths of chords that were passed
        std::size_t within = 0, deep = 0;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one == Shape::LaterIn) {
                ++within;
                deep += depthInChord(r) > kDeepest ? 1 : 0;
            }
            if (one != Shape::Later && one != Shape::LaterIn && one != Shape::Through) continue;
            thin.push_back(chords(r).front().out - chords(r).front().in);
        }
        // Answers deep within the surface are not those of a search that passed a feature.
        if (thin.empty() || deep * 10 > within || (within > 0 && followsHeight())) return;
        Fault fault = Fault::MissedSpike;
        if (layers == 0) {
            const auto middle = thin.begin() + static_cast<std::ptrdiff_t>(thin.size() / 2);
            std::nth_element(thin.begin(), middle, thin.end());
            std::size_t missed = 0, met = 0;
            for (std::size_t r = 0; r < given_.size(); ++r) {
                if (exact_[r].outcome != Outcome::Hit || touches(r)) continue;
                const Chord& chord = chords(r).front();
                if (chord.out - chord.in > 0.5 * *middle) continue;
                (passed(r) ? missed : met) += 1;
            }
            // Equal steps miss nearly all of the thinnest features; a map's overshoots miss some of them.
            if (missed < met) fault = Fault::UnsafeMap;
        }
        for (std::size_t r = 0; r < given_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one != Shape::Later && one != Shape::LaterIn && one != Shape::Through) continue;
            Fault here = fault;
            if (!evidence_.kinds.empty() && evidence_.kinds[r]) here = *evidence_.kinds[r];
            cause(out, r, here);
        }
    }

    // Answers within the first chord, not deeper than a step; only if the steps are small.
    void explainLate(Explanation& out) {
        std::vector<double> late;
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] == Shape::Late) late.push_back(lambda(r) - chords(r).front().in);
        }
        if (late.empty() || followsHeight()) return;
        std::sort(late.begin(), late.end());
        const double most = late[late.size() * 95 / 100];
        if (most > kDeepest) return;
        const int layers = static_cast<int>(std::lround(1 / std::max(most, 1.0 / kMostLayers)));
        for (std::size_t r = 0; r < given_.size(); ++r) {
            if (shapes_[r] != Shape::Late || lambda(r) - chords(r).front().in > 2 * most) continue;
            cause(out, r, lateFault(r, layers));
        }
    }

    // Returns true if the depth of the answers below the surface follows from the height there: the tracer reads other
    // heights. Where a search stops does not depend on the height.
    bool followsHeight() {
        std::vector<std::pair<double, double>> depths;  // height, depth
        for (std::size_t r = 0; r < given_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one != Shape::Late && one != Shape::LaterIn && one != Shape::Early) continue;
            const double depth = surfaceGap(r, lambda(r));
            depths.emplace_back(depth + 1 - lambda(r), depth);
        }
        constexpr std::size_t kLeast = 32;
        if (depths.size() < kLeast) return false;
        std::sort(depths.begin(), depths.end());
        // The mean step between neighbours in height, against that between any two.
        double near = 0, far = 0;
        const std::size_t n = depths.size();
        for (std::size_t k = 0; k + 1 < n; ++k) near += std::abs(depths[k + 1].second - depths[k].second);
        for (std::size_t k = 0; k + 1 < n; ++k) far += std::abs(depths[(k + n / 2) % n].second - depths[k].second);
        constexpr double kFollows = 0.35;
        return near < kFollows * far;
    }

    // Lists the faults of the search that explain any ray.
    void nameCauses(Explanation& out, int layers) const {
        std::map<Fault, std::size_t> counts;
        for (const RayVerdict& ray : out.rays) {
            if (ray.cause) ++counts[*ray.cause];
        }
        for (const auto& [fault, count] : counts) out.searchFaults.push_back({fault, static_cast<double>(layers)});
    }

    const AnsweredRays& given_;
    const SearchEvidence& evidence_;
    TracerModel model_;
    ModelFields& fields_;
    Work& work_;
    ModelFields::Placed placed_;
    std::vector<Hit> exact_;
    std::vector<double> runs_;
    std::vector<std::vector<Chord>> chords_;
    std::vector<Shape> shapes_;
};

}  // namespace

std::vector<Explanation> explanations(const AnsweredRays& given, const SearchEvidence& evidence,
                                      const TracerModel& model, bool byShape, ModelFields& fields, Work& work) {
    return Search(given, evidence, model, fields, work).all(byShape);
}

}  // namespace relief
