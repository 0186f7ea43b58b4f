// The ray shown in the panes: the chosen pixel's, as logged by the method, or a ray from files of another program's
// tracer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measuring/compare/logged_ray.h"
#include "relief/tracers.h"
#include "scenario/rays_view.h"
#include "scenario/scenario.h"

namespace reliefui {

struct PixelTrace {
    relief::PixelChoice pixel;
    bool onRelief = false;  // false: no polygon covers the pixel, and the other members are empty
    relief::ViewRay ray;
    relief::Hit hit;
    std::vector<relief::Step> steps;
    std::uint32_t reads = 0;
    int baseLevel = 0;            // pyramid level that the method traced instead of the heights, see Tracer::baseLevel
    bool fromFile = false;        // the steps come from another program's files
    bool hidden = false;          // the user is guessing: hit and steps were removed
    relief::Hit exact;            // exact hit of the same ray
    relief::Judgement judgement;  // of the steps, compared with `exact`
    // The columns of another program's steps that are none of ours.
    std::vector<relief::FurtherColumn> further;
    std::optional<std::size_t> number;  // of a ray from files, also if the method traced it

    // The steps by columns; keeps references.
    relief::StepColumns columns() const {
        if (number) return {steps, &further, {}, *number};
        return {steps, &further, std::array{pixel.x, pixel.y}};
    }
    // The data against which breakpoints are checked; keeps references.
    relief::StoppedRay stopped() const {
        const bool departs = judgement.kind != relief::Departure::None;
        return {&steps, judgement.overshoot, departs ? std::optional<std::size_t>(judgement.step) : std::nullopt,
                columns()};
    }
};

// Contents of the two files of another program's tracer, and their paths; the other members of `from` are unused.
struct OtherFiles : relief::RayFiles {
    relief::OtherTracer from;
    std::optional<relief::RaysView> view;           // of the rays, if a file next to them names it
    std::optional<relief::InputError> viewProblem;  // why that file cannot be used

    // Returns true if `other` names these files.
    bool areOf(const relief::OtherTracer& other) const { return from.rays == other.rays && from.steps == other.steps; }
};
// Throws InputError that names file and line.
std::shared_ptr<const OtherFiles> readOtherFiles(const relief::OtherTracer& other);

// Traces the pixel's ray or, if there are files, the chosen ray of the files, and logs the method's steps.
struct RayTraces {
    PixelTrace shown;                         // shown in all panes
    std::shared_ptr<const PixelTrace> other;  // ray and steps from the files; null without files
    std::size_t otherRays = 0;
};
RayTraces traceRay(const relief::Scenario& scenario, const relief::FrameRequest& request, const relief::Tracer& tracer,
                   const OtherFiles* files, relief::MapCache& maps, relief::Work& work);

}  // namespace reliefui
