#include "rendering/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "rendering/light_lanes.h"

namespace relief {

glm::dvec3 lightDirection(const Light& light) {
    const double azimuth = light.azimuth * std::numbers::pi / 180;
    const double elevation = light.elevation * std::numbers::pi / 180;
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

glm::dvec2 lightRun(const TexturedQuad& quad, glm::dvec3 toLight, double slabTexels) {
    const glm::dvec3 &perS = quad.plane.perS, &perT = quad.plane.perT;
    const double length = slabTexels * glm::length(perS) / glm::dot(toLight, quad.normal);
    return {length * glm::dot(toLight, perS) / glm::dot(perS, perS),
            length * glm::dot(toLight, perT) / glm::dot(perT, perT)};
}

ReliefAxes::ReliefAxes(const TexturedQuad& quad)
    : normal(quad.normal), alongS(glm::normalize(quad.plane.perS)), alongT(glm::normalize(quad.plane.perT)) {}

glm::dvec3 ReliefAxes::normalOf(std::pair<double, double> slope, double slabTexels) const {
    return glm::normalize(normal - slabTexels * slope.first * alongS - slabTexels * slope.second * alongT);
}

glm::dvec3 reliefNormal(const TexturedQuad& quad, std::pair<double, double> slope, double slabTexels) {
    return ReliefAxes(quad).normalOf(slope, slabTexels);
}

glm::dvec3 mappedNormal(const TexturedQuad& quad, glm::vec3 tangent) {
    const glm::dvec3 n(tangent);
    return glm::normalize(n.x * glm::normalize(quad.plane.perS) - n.y * glm::normalize(quad.plane.perT) +
                          n.z * quad.normal);
}

Color lit(Color albedo, double facing, const Light& light) {
    return albedo * litAmount(facing, light);
}

Color lambert(Color albedo, glm::dvec3 normal, glm::dvec3 toLight, const Light& light, bool shadowed) {
    return lit(albedo, shadowed ? 0.0 : glm::dot(normal, toLight), light);
}

}  // namespace relief
