// The cells of a step's line in step files, in the order of kStepsHeader.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "relief/step_log.h"
#include "scenario/ray_files.h"

namespace relief {

// Calls put(name, value) or putName(name, text) for each column of a step, in the order of kStepsHeader.
template <class Number, class Name>
void forEachColumn(const Step& step, std::size_t ray, std::size_t number, const Number& put, const Name& putName) {
    put("ray", static_cast<std::int64_t>(ray));
    put("number", static_cast<std::int64_t>(number));
    putName("phase", phaseName(step.phase));
    put("level", static_cast<std::int64_t>(step.level));
    put("i", step.i);
    put("j", step.j);
    put("k", step.k);
    put("lambda_in", step.lambdaIn);
    put("lambda_out", step.lambdaOut);
    put("z_in", step.zIn());
    put("z_out", step.zOut());
    put("value", step.value);
    putName("decision", decisionName(step.decision));
    put("lambda_after", step.lambdaAfter);
}

// The values that a kind of subject has in addition to the columns above, in the order of kSubjectColumns without the
// first.
using SubjectValues = std::array<std::optional<double>, kSubjectColumns.size() - 1>;
inline SubjectValues subjectValues(const Step& step) {
    SubjectValues values;
    auto& [s, t, z, width, height, index, count] = values;
    if (const auto* const sphere = step.as<subject::Sphere>()) {
        s = sphere->s, t = sphere->t, z = sphere->z;
    } else if (const auto* const cone = step.as<subject::Cone>()) {
        s = cone->s, t = cone->t, z = cone->apex, index = cone->sector, count = cone->sectors;
        if (cone->ofCell) width = 1, height = 1;
    } else if (const auto* const voxel = step.as<subject::Voxel>()) {
        width = voxel->footprint, height = voxel->footprint, count = voxel->layers;
    } else if (const auto* const quad = step.as<subject::Quad>()) {
        s = quad->s, t = quad->t, width = quad->width, height = quad->height;
    } else if (const auto* const texel = step.as<subject::Texel>()) {
        if (texel->ray) s = texel->ray->x, t = texel->ray->y;
    } else if (const auto* const layer = step.as<subject::Layer>()) {
        index = layer->n, count = layer->count;
    }
    return values;
}

}  // namespace relief
