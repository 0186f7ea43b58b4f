#include "painting/step_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Decision;
namespace subject = relief::subject;

}  // namespace

bool StepBody::whole() const {
    return to - from > 2 * std::numbers::pi - 1e-9;
}

bool StepBody::holds(double x, double y) const {
    if (whole()) return true;
    constexpr double kTurn = 2 * std::numbers::pi;
    double azimuth = std::atan2(y, x);
    if (azimuth < 0) azimuth += kTurn;
    return azimuth >= from && azimuth <= to;
}

double StepBody::away(double x, double y) const {
    return square ? std::max(std::abs(x), std::abs(y)) : std::hypot(x, y);
}

StepBody stepBody(const relief::Step& step) {
    StepBody body;
    if (!step.trustsMap()) return body;
    if (const auto* const sphere = step.as<subject::Sphere>()) {
        body = {StepBody::Kind::Sphere, step.lambdaIn, sphere->radius};
        body.refined = sphere->refined;
    } else if (const auto* const voxel = step.as<subject::Voxel>()) {
        // The distance is valid for every point of the voxel: the ray continues from where it leaves the voxel.
        body = {StepBody::Kind::Sphere, step.lambdaOut, voxel->distance};
        body.refined = voxel->refined;
    } else if (const auto* const cone = step.as<subject::Cone>()) {
        body.kind = StepBody::Kind::Cone;
        body.lambda = cone->ofCell ? step.lambdaOut : step.lambdaIn;
        body.apex = cone->apex;
        body.slope = cone->slope;
        body.from = 2 * std::numbers::pi * cone->sector / cone->sectors;
        body.to = 2 * std::numbers::pi * (cone->sector + 1) / cone->sectors;
        body.square = cone->square;
        body.relaxed = cone->relaxed;
    }
    return body;
}

Role bodyRole(const relief::Step& step, const relief::ViewRay& ray, const relief::Hit& exact) {
    const bool broken = relief::mapPromise(step, {nullptr, ray, exact}) == relief::MapPromise::Broken;
    return broken ? Role::Overshoot : Role::Empty;
}

bool valueIsHeight(const relief::Step& step) {
    if (step.as<subject::Voxel>() != nullptr || step.as<subject::Sphere>() != nullptr) return false;
    return step.as<subject::Cone>() == nullptr || step.decision != Decision::Advance;
}

bool liesInVoxel(const relief::Step& step) {
    return step.as<subject::Voxel>() != nullptr && !step.tests();
}

VoxelHeights voxelHeights(const relief::Step& step) {
    const auto* const voxel = step.as<subject::Voxel>();
    if (voxel == nullptr) return {};
    return {static_cast<double>(voxel->k) / voxel->layers, static_cast<double>(voxel->k + 1) / voxel->layers};
}

}  // namespace reliefui
