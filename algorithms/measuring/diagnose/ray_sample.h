// Samples of a tracer's rays, with everything by which their answers are explained.
#pragma once

#include <cstddef>
#include <vector>

#include "measuring/diagnose/diagnose.h"

namespace relief {

// ids: the numbers of the rays in the record. explained: of each ray, true if its answer is right or a fault that was
// found explains it.
struct RaySample {
    std::vector<std::size_t> ids;
    AnsweredRays given;
    SearchEvidence evidence;
    std::vector<bool> explained;
};

// Returns `count` of the numbers, chosen uniformly and always the same, in their order; all if there are no more.
std::vector<std::size_t> sampleOf(const std::vector<std::size_t>& all, std::size_t count);

// Returns these rays of the record. exact: the right answers to all of its rays.
RaySample raySample(std::vector<std::size_t> ids, std::vector<bool> explained, const TracerRecord& record,
                    const HitBlock& exact, const HeightField& field);

}  // namespace relief
