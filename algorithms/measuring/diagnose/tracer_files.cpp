#include "measuring/diagnose/tracer_files.h"

#include "scenario/ray_files.h"
#include "scenario/witness.h"

namespace relief {

TracerRecord tracerRecord(RayFiles files, const HeightField& field, const std::string& stepsFile) {
    TracerRecord record;
    record.rays = std::move(files.rays);
    if (files.hits) {
        record.hits = std::move(*files.hits);
        return record;
    }
    record.steps = std::move(files.log);
    const std::size_t rays = record.rays.size();
    record.hits.resize(rays);
    for (std::size_t r = 0; r < rays; ++r) {
        const std::span<Step> steps = stepsOf(*record.steps, r);
        placeSteps(steps, record.rays[r], field, stepsFile, r);
        record.hits.set(r, answerOf(steps, record.rays[r]));
        record.hits.steps[r] = static_cast<std::uint32_t>(steps.size());
    }
    return record;
}

Scenario sceneOfRay(Scenario scenario, const HeightField& field, const RayBlock& rays,
                    const std::optional<RaysView>& view, std::size_t ray) {
    if (!view) return witness(std::move(scenario), field, rays[ray]);
    scenario.scene = view->scenario.scene;
    scenario.camera = view->scenario.camera;
    scenario.width = view->scenario.width;
    scenario.height = view->scenario.height;
    scenario.pixel = view->pixels[ray];
    return scenario;
}

}  // namespace relief
