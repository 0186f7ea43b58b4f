// halving: bisection of the whole ray. A guest: in the lists of the tests' own programs only.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: the half in which the surface is crossed, as the height at its middle says, again and again.
// Guarantee: none. Failure mode: of several crossings it finds any one. Cost: one height a halving.
#pragma once

#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/sampled_surface.h"

namespace relief {

class HalvingTracer {
  public:
    struct Options {
        int halvings = 12;

        static std::vector<OptionField<Options>> fields() {
            return {{{"halvings", OptionKind::Integer, "halvings", 1, 50, 1, {}, "how often the ray is cut"},
                     &Options::halvings}};
        }
    };
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "halving";
        method.title = "halving";
        method.help = "Bisection of the whole ray; of several crossings any one.";
        method.source = "a guest";
        return method;
    }
    static HalvingTracer make(const HeightField& field, const Options& options, MapCache&, Work&) {
        return {field, options.halvings};
    }
    HalvingTracer(HeightField field, int halvings) : field_(std::move(field)), halvings_(halvings) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field_, ray);
        double above = 0, below = 1;
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
    std::size_t bytes() const { return 0; }
    double stepBound(const ViewRay&) const { return halvings_ + 1; }

  private:
    HeightField field_;
    int halvings_;
};

}  // namespace relief
