// A traced ray on a procedural relief, and the profile's drawing of it.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "panes/profile/profile_drawing.h"
#include "panes/slice.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"

namespace reliefui {

// Heights and positions in the drawing are computed in double from the same numbers.
inline constexpr double kRounding = 1e-9;

struct Traced {
    relief::Work work;
    relief::MapCache cache;
    relief::HeightField field;
    relief::HitBlock hits;
    relief::StepLog log;
    ProfileSource source;

    Traced(const char* recipe, int width, int height, relief::Surface surface, relief::Address address)
        : Traced(relief::makeRelief(recipe, width, height, 3), surface, address) {}
    Traced(relief::FloatImage heights, relief::Surface surface, relief::Address address)
        : field(std::make_shared<const relief::FloatImage>(std::move(heights)), surface, address) {
        source.field = &field;
        source.maxima = relief::maxPyramidMap(field, cache, work);
    }
    void trace(const relief::ViewRay& ray, const relief::MethodChoice& method) {
        relief::RayBlock rays;
        rays.push(ray);
        log = {};
        relief::makeTracer(method, field, cache, work)->trace(rays, hits, log, work);
        source.hasRay = true;
        source.ray = ray;
        source.hit = hits[0];
        source.steps = &log.steps;
    }
    relief::PyramidWalk walk() const { return {field, source.maxima}; }
};

}  // namespace reliefui
