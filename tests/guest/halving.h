// halving: bisection of the ray below the highest point. The worked example of a tracer and of a map
// (algorithms/README.md); only in the lists of the tests' own programs.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: the height at the middle of an interval decides in which half the surface is crossed; that half is the next
// interval. The first interval begins at the height of the highest point, which is the method's map.
// Guarantee: none. Failure mode: of several crossings it may find any. Cost: one height per halving.
#pragma once

#include <algorithm>

#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/sampled_surface.h"

namespace relief {

// The map: the largest height.
struct HighestPoint {
    double height = 1;
    std::size_t bytes() const { return sizeof *this; }
};

class HalvingTracer {
  public:
    struct Options {
        int halvings = 12;

        static std::vector<OptionField<Options>> fields() {
            return {{{"halvings", OptionKind::Integer, "halvings", 1, 50, 1, {}, "how often the interval is halved"},
                     &Options::halvings}};
        }
    };
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "halving";
        method.title = "halving";
        method.help = "Bisection of the ray below the highest point; of several crossings any one.";
        method.source = "a guest";
        method.maps = {"highest-point"};
        return method;
    }
    static HalvingTracer make(const HeightField& field, const Options& options, MapCache& maps, Work& work) {
        const auto build = [&](Work&) {
            const auto heights = field.heights().pixels();
            return HighestPoint{*std::max_element(heights.begin(), heights.end())};
        };
        // The key of the map contains everything that it depends on, here only the heights.
        return {field, options.halvings,
                maps.get<HighestPoint>({"highest-point", field.sharedHeights()}, sizeof(HighestPoint), work, build)};
    }
    HalvingTracer(HeightField field, int halvings, std::shared_ptr<const HighestPoint> map)
        : field_(std::move(field)), halvings_(halvings), map_(std::move(map)) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field_, ray);
        double above = 1 - map_->height, below = 1;
        for (int n = 0; n < halvings_; ++n) {
            const double middle = (above + below) / 2;
            const double gap = surface.gapAt(middle);
            sink.read(surface.readsEach());
            sink.step([&] {
                return surface.record(Phase::Refine, Decision::Refine, above, middle, gap + 1 - middle, middle);
            });
            (gap >= 0 ? below : above) = middle;
        }
        const bool hit = surface.inside(below);
        sink.step([&] {
            const double height = surface.heightAt(below);
            return surface.record(Phase::Search, hit ? Decision::Hit : Decision::Miss, above, below, height, below);
        });
        return hit ? Hit::at(ray, below) : Hit::none(Outcome::Miss);
    }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return map_->bytes(); }
    double stepBound(const ViewRay&) const { return halvings_ + 1; }

  private:
    HeightField field_;
    int halvings_;
    std::shared_ptr<const HighestPoint> map_;
};

}  // namespace relief
