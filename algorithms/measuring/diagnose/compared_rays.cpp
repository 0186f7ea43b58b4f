#include "measuring/diagnose/compared_rays.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "measuring/diagnose/chords.h"
#include "relief/tracers.h"
#include "scenario/step_sentence.h"

namespace relief {

namespace {

// Largest number of wrong rays that are examined for barely touching the surface, which takes long. More are taken as
// wrong.
constexpr std::size_t kMostExamined = 20000;

// Moves wrong rays that barely touch the surface to the right ones: their errors are no fault of the tracer.
void dropTouching(ComparedRays& compared, const RayBlock& rays, const HitBlock& hits, const HeightField& field,
                  Work& work) {
    const std::vector<std::size_t> wrong = std::move(compared.wrong);
    std::vector<std::uint8_t> touching(wrong.size(), 0);
    parallelFor(work, wrong.size(), [&](std::size_t n) {
        const std::size_t r = wrong[n];
        if (compared.exact.outcome[r] != Outcome::Hit) return;
        const ViewRay ray = rays[r];
        const auto chords = solidChords(field, ray, compared.exact.lambda[r]);
        const double run = std::max(1.0, std::hypot(ray.a, ray.b));
        touching[n] = barelyTouches(field, ray, chords, hits[r], run) ? 1 : 0;
    });
    compared.wrong.clear();
    for (std::size_t n = 0; n < wrong.size(); ++n) {
        (touching[n] != 0 ? compared.right : compared.wrong).push_back(wrong[n]);
    }
    compared.touching = wrong.size() - compared.wrong.size();
}

}  // namespace

ComparedRays compareRays(const RayBlock& rays, const HitBlock& hits, const HeightField& field, Work& work) {
    ComparedRays compared;
    MapCache maps;
    NullSink sink;
    makeTracer({"max-pyramid", {}}, field, maps, work)->trace(rays, compared.exact, sink, work);
    for (std::size_t r = 0; r < rays.size(); ++r) {
        const double error = answerError(hits[r], compared.exact[r], rays[r]);
        compared.errors.push_back(static_cast<float>(error));
        (error > kRightTexels ? compared.wrong : compared.right).push_back(r);
    }
    if (compared.wrong.size() <= kMostExamined) dropTouching(compared, rays, hits, field, work);
    return compared;
}

}  // namespace relief
