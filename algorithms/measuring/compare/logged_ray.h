// One ray with all that is known of it: its steps and hit, as logged by a method or as read from another program's
// files, the exact hit, and where the steps depart from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measuring/compare/duel.h"
#include "relief/tracers.h"
#include "scenario/scenario.h"
#include "scenario/step_columns.h"

namespace relief {

// Gives bit for bit the results of `exact`, but is faster.
inline constexpr const char* kExactTracer = "max-pyramid";

struct LoggedRay {
    ViewRay ray;
    Hit hit;
    std::vector<Step> steps;
    std::uint32_t reads = 0;  // 0 for a ray from files
    Hit exact;
    Judgement judgement;
    std::vector<FurtherColumn> further;  // of a ray from files, with a cell for each step
};

// Contents of the two files of another program's tracer. hits: if the second file holds hits in place of steps; the log
// then has one step for each ray, its answer.
struct RayFiles {
    RayBlock rays;
    StepLog log;
    std::vector<FurtherColumn> further;  // with a cell for each step of `log`
    std::optional<HitBlock> hits{};
};
// Throws InputError that names file and line; also if the files have no ray, or not as many hits as rays.
RayFiles readRayFiles(const OtherTracer& other);

// Traces the ray. Sets all but `exact` and `judgement`. Throws Cancelled.
LoggedRay tracedRay(const Tracer& tracer, const ViewRay& ray, Work& work);
// Returns ray `other.ray` of the files' contents. Sets all but `reads`, `exact` and `judgement`. Throws InputError if
// the files do not have this ray, or its steps do not fit the heights.
LoggedRay rayOfFiles(const OtherTracer& other, const RayFiles& files, const HeightField& field);
// Sets `exact` and `judgement`. name: of the method or the file, for messages. Throws Cancelled.
void judgeAgainstExact(LoggedRay& ray, const std::string& name, const HeightField& field, MapCache& maps, Work& work);

}  // namespace relief
