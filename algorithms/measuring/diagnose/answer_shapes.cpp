#include <algorithm>
#include <cmath>
#include <map>

#include "measuring/diagnose/searched_rays.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

// Deepest answer within the surface, lambda, of a search that stops behind it.
constexpr double kDeepest = 0.13;

// Returns true if the Mann-Whitney U test (one-sided, 1% significance) finds the runs longer than the others. By
// chance, the run is the longer one in half of all pairs, with the standard deviation below. Neither list may be empty.
bool longerThanByChance(const std::vector<double>& runs, std::vector<double> others) {
    std::sort(others.begin(), others.end());
    double longer = 0;
    for (const double run : runs) {
        const auto [equal, above] = std::equal_range(others.begin(), others.end(), run);
        longer += 0.5 * static_cast<double>((equal - others.begin()) + (above - others.begin()));
    }
    const double pairs = static_cast<double>(runs.size()) * static_cast<double>(others.size());
    const double deviation = std::sqrt((static_cast<double>(runs.size() + others.size()) + 1) / (12 * pairs));
    constexpr double kDeviations = 2.33;
    return longer / pairs >= 0.5 + kDeviations * deviation;
}

class Shapes {
  public:
    Shapes(SearchedRays& rays, const SearchEvidence& evidence) : rays_(rays), evidence_(evidence) {}

    Explanation explanation() {
        Explanation out{rays_.model(), std::vector<RayVerdict>(rays_.size()), {}, true};
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            shapes_.push_back(shape(r));
            out.rays[r].explained = shapes_[r] == Shape::Right;
        }
        explainLimit(out);
        const bool exact = exactElsewhere();
        if (exact) explainEnded(out);
        const bool inside = std::any_of(shapes_.begin(), shapes_.end(),
                                        [](Shape one) { return one == Shape::Late || one == Shape::LaterIn; });
        if (exact && inside) {
            explainOvershoots(out);
        } else {
            explainPasses(out);
            explainLate(out);
        }
        nameCauses(out, 0);
        return out;
    }

  private:
    // What a wrong answer looks like. Early: in front of the surface. Late: in the first chord. Later: on the surface
    // of a later chord; LaterIn: within one. Through: a miss.
    enum class Shape : std::uint8_t { Right, Early, Late, Later, LaterIn, Through, Limit, Other };
    Shape shape(std::size_t r) {
        if (rays_.answer(r).outcome == Outcome::Limit) return Shape::Limit;
        if (rays_.gap(r, rays_.exact(r)) <= kRightTexels || rays_.touches(r)) return Shape::Right;
        if (rays_.exact(r).outcome != Outcome::Hit) return Shape::Other;
        if (!rays_.isHit(r)) return Shape::Through;
        const double at = rays_.lambda(r);
        const double same = kRightTexels / rays_.run(r);
        for (const Chord& chord : rays_.chords(r)) {
            if (at < chord.in - same) return Shape::Early;
            if (at > chord.out + same) continue;
            if (&chord == &rays_.chords(r).front()) return Shape::Late;
            return std::abs(at - chord.in) <= same || std::abs(rays_.surfaceGap(r, at)) <= kTouchDepth ? Shape::Later
                                                                                                       : Shape::LaterIn;
        }
        return Shape::Early;
    }

    // Returns how far behind its way into the surface an answer lies, lambda.
    double depthInChord(std::size_t r) {
        for (const Chord& chord : rays_.chords(r)) {
            if (rays_.lambda(r) <= chord.out) return rays_.lambda(r) - chord.in;
        }
        return 0;
    }

    // Returns true if the answer lies behind a chord that was passed.
    static bool isPast(Shape shape) {
        return shape == Shape::Later || shape == Shape::LaterIn || shape == Shape::Through;
    }

    // Returns the fault that the recorded steps of the ray show; `otherwise` if they show none.
    Fault recordedOr(std::size_t r, Fault otherwise) const {
        return evidence_.kinds.empty() ? otherwise : evidence_.kinds[r].value_or(otherwise);
    }
    // Explains the answer by the fault unless it is explained already.
    static void cause(Explanation& out, std::size_t r, Fault fault) {
        if (out.rays[r].explained) return;
        out.rays[r] = {true, fault, false};
    }

    // Returns true if there is a number of equal layers of which a search with refinement gives these answers: the
    // surface is found at the first multiple within a chord, and the answer lies in the layer before it.
    bool refinesLayers() {
        std::vector<std::size_t> use;
        for (std::size_t r = 0; r < rays_.size() && use.size() < 400; ++r) {
            if (rays_.exact(r).outcome == Outcome::Hit && rays_.isHit(r)) use.push_back(r);
        }
        if (use.size() < 8) return false;
        for (int n = kMostLayers; n >= 3; --n) {
            std::size_t wrong = 0;
            const std::size_t allowed = use.size() * 4 / 100;
            for (const std::size_t r : use) {
                const int found = layerThatFinds(r, n);
                const double same = kRightTexels / rays_.run(r);
                const bool in = found > 0 && rays_.lambda(r) >= (found - 1.0) / n - same &&
                                rays_.lambda(r) <= found * 1.0 / n + same;
                if (!in && !rays_.touches(r) && ++wrong > allowed) break;
            }
            if (wrong <= allowed) return true;
        }
        return false;
    }
    // Returns the first multiple of 1 / n within a chord; 0 if there is none.
    int layerThatFinds(std::size_t r, int n) {
        for (const Chord& chord : rays_.chords(r)) {
            const int first = std::max(1, static_cast<int>(std::ceil(chord.in * n - 1e-9)));
            if (first <= chord.out * n && first <= n) return first;
        }
        return 0;
    }

    // A limit that the tracer reports; or many answers in front of the surface after the same, largest number of steps
    // or at the same place.
    void explainLimit(Explanation& out) {
        std::vector<std::size_t> early;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] == Shape::Limit) cause(out, r, Fault::StepLimit);
            if (shapes_[r] == Shape::Early) early.push_back(r);
        }
        if (early.size() < 3) return;
        if (!evidence_.counts.empty()) {
            const std::uint32_t most = *std::max_element(evidence_.counts.begin(), evidence_.counts.end());
            std::size_t at = 0;
            for (const std::size_t r : early) at += evidence_.counts[r] == most ? 1 : 0;
            if (most > 1 && static_cast<double>(at) >= 0.8 * static_cast<double>(early.size())) {
                for (std::size_t r = 0; r < rays_.size(); ++r) {
                    const bool stopped = shapes_[r] == Shape::Early || shapes_[r] == Shape::Through;
                    if (stopped && evidence_.counts[r] == most) cause(out, r, Fault::StepLimit);
                }
                return;
            }
        }
        for (const bool texels : {false, true}) {
            std::map<long long, std::size_t> places;
            const auto place = [&](std::size_t r) {
                const double at =
                    texels ? rays_.lambda(r) * std::hypot(rays_.given().rays.a[r], rays_.given().rays.b[r]) / 64
                           : rays_.lambda(r);
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
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] != Shape::Right || !rays_.isHit(r) || rays_.exact(r).outcome != Outcome::Hit) continue;
            ++right;
            exact += std::abs(rays_.answer(r).lambda - rays_.exact(r).lambda) <= kInexact ? 1 : 0;
        }
        return right >= 8 && exact * 2 >= right;
    }
    void explainOvershoots(Explanation& out) {
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one == Shape::Early || one == Shape::Other || one == Shape::Limit) continue;
            cause(out, r, recordedOr(r, Fault::UnsafeMap));
        }
    }
    // Long rays that end in the air, while the others end on the surface.
    void explainEnded(Explanation& out) {
        std::vector<double> ended, right;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] == Shape::Right) right.push_back(rays_.run(r));
            if (shapes_[r] == Shape::Early) ended.push_back(rays_.run(r));
        }
        if (ended.size() < 3 || right.empty()) return;
        constexpr double kLonger = 1.2;
        if (upperMedian(ended) < kLonger * upperMedian(right)) return;
        if (!longerThanByChance(ended, right)) return;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] == Shape::Early) cause(out, r, Fault::StepLimit);
        }
    }

    // Answers behind a chord that was passed. With constant layers, no chord that holds a multiple is passed.
    void explainPasses(Explanation& out) {
        std::vector<double> thin;  // lengths of chords that were passed
        std::size_t within = 0, deep = 0;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one == Shape::LaterIn) {
                ++within;
                deep += depthInChord(r) > kDeepest ? 1 : 0;
            }
            if (!isPast(one)) continue;
            thin.push_back(rays_.chords(r).front().out - rays_.chords(r).front().in);
        }
        // Answers deep within the surface are not those of a search that passed a feature.
        if (thin.empty() || deep * 10 > within || (within > 0 && followsHeight())) return;
        Fault fault = Fault::MissedSpike;
        if (!refinesLayers()) {
            const double middle = upperMedian(thin);
            std::size_t missed = 0, met = 0;
            for (std::size_t r = 0; r < rays_.size(); ++r) {
                if (rays_.exact(r).outcome != Outcome::Hit || rays_.touches(r)) continue;
                const Chord& chord = rays_.chords(r).front();
                if (chord.out - chord.in > 0.5 * middle) continue;
                (rays_.passed(r) ? missed : met) += 1;
            }
            // Equal steps miss nearly all of the thinnest features; a map's overshoots miss some of them.
            if (missed < met) fault = Fault::UnsafeMap;
        }
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (!isPast(shapes_[r])) continue;
            cause(out, r, recordedOr(r, fault));
        }
    }

    // Answers within the first chord, not deeper than a step; only if the steps are small.
    void explainLate(Explanation& out) {
        std::vector<double> late;
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] == Shape::Late) late.push_back(rays_.lambda(r) - rays_.chords(r).front().in);
        }
        if (late.empty() || followsHeight()) return;
        std::sort(late.begin(), late.end());
        const double most = late[late.size() * 95 / 100];
        if (most > kDeepest) return;
        const int layers = static_cast<int>(std::lround(1 / std::max(most, 1.0 / kMostLayers)));
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            if (shapes_[r] != Shape::Late || rays_.lambda(r) - rays_.chords(r).front().in > 2 * most) continue;
            cause(out, r, rays_.lateFault(r, layers));
        }
    }

    // Returns true if the depth of the answers below the surface follows from the height there: the tracer reads other
    // heights. Where a search stops does not depend on the height.
    bool followsHeight() {
        std::vector<std::pair<double, double>> depths;  // height, depth
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const Shape one = shapes_[r];
            if (one != Shape::Late && one != Shape::LaterIn && one != Shape::Early) continue;
            const double depth = rays_.surfaceGap(r, rays_.lambda(r));
            depths.emplace_back(depth + 1 - rays_.lambda(r), depth);
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

    SearchedRays& rays_;
    const SearchEvidence& evidence_;
    std::vector<Shape> shapes_;
};

}  // namespace

Explanation explanationByShape(SearchedRays& rays, const SearchEvidence& evidence) {
    return Shapes(rays, evidence).explanation();
}

}  // namespace relief
