#include "scenario/witness.h"

#include <cmath>

namespace relief {

Scenario witness(Scenario scenario, const HeightField& field, const ViewRay& ray) {
    constexpr double kAway = 1.5;
    // Odd, so that the centre of a pixel lies in the centre of the picture.
    scenario.width = 801;
    scenario.height = 601;
    scenario.scene = SceneKind::Floor;
    const double texel = 1.0 / field.width();
    const glm::dvec3 entry(ray.s0 * texel - 0.5, 0, (ray.t0 - field.height() * 0.5) * texel);
    const glm::dvec3 along(ray.a * texel, -field.reliefDepth(), ray.b * texel);
    const double length = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
    scenario.camera.kind = Camera::Kind::Free;
    scenario.camera.target = entry;
    scenario.camera.eye = entry - along * (kAway / length);
    scenario.pixel = PixelChoice{scenario.width / 2, scenario.height / 2};
    scenario.step = 0;
    return scenario;
}

}  // namespace relief
