// The ray that is looked at: the chosen pixel's, as the production tracer logged it, or one of somebody else's tracer,
// from its files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "measuring/compare/duel.h"
#include "relief/tracers.h"
#include "scenario/scenario.h"

namespace reliefui {

struct PixelTrace {
    relief::PixelChoice pixel;
    bool onRelief = false;  // false: no polygon covers the pixel; the rest is empty then
    relief::ViewRay ray;
    relief::Hit hit;
    std::vector<relief::Step> steps;
    std::uint32_t reads = 0;
    int baseLevel = 0;            // what the method traced instead of the heights, see Tracer::baseLevel
    bool fromFile = false;        // the steps are somebody else's
    bool hidden = false;          // somebody is guessing: hit and steps were taken out
    relief::Hit exact;            // of the same ray
    relief::Judgement judgement;  // of these steps by it

    // What breakpoints are held against.
    relief::StoppedRay stopped() const {
        const bool departs = judgement.kind != relief::Departure::None;
        return {&steps, judgement.overshoot, departs ? std::optional<std::size_t>(judgement.step) : std::nullopt};
    }
};

// The two files of somebody else's tracer.
struct OtherFiles {
    relief::OtherTracer from;  // which files; their ray and `shown` mean nothing here
    relief::RayBlock rays;
    relief::StepLog log;
};
// Throws InputError with file and line.
std::shared_ptr<const OtherFiles> readOtherFiles(const relief::OtherTracer& other);

// The ray's log by the method; the pixel's ray, or (with files) the ray of the files.
struct RayTraces {
    PixelTrace shown;                         // what all panes show
    std::shared_ptr<const PixelTrace> other;  // of the files; null: there are none
    std::size_t otherRays = 0;
};
RayTraces traceRay(const relief::Scenario& scenario, const relief::FrameRequest& request, const relief::Tracer& tracer,
                   const OtherFiles* files, relief::MapCache& maps, relief::Work& work);

}  // namespace reliefui
