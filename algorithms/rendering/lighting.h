// Lambert light from one direction, and the normal of the relief.
#pragma once

#include <utility>

#include <glm/vec3.hpp>

#include "relief/image.h"
#include "rendering/scene.h"

namespace relief {

// Direction towards the light: azimuth and elevation in degrees, as of the camera. ambient in [0, 1]: what reaches a
// surface that is turned away; intensity scales all.
struct Light {
    double azimuth = -50;
    double elevation = 40;
    double ambient = 0.25;
    double intensity = 1.15;
    bool operator==(const Light&) const = default;
};

glm::dvec3 lightDirection(const Light& light);

// A polygon's axes of length 1, made once for many normals.
struct ReliefAxes {
    glm::dvec3 normal, alongS, alongT;

    explicit ReliefAxes(const TexturedQuad& quad);
    // As reliefNormal.
    glm::dvec3 normalOf(std::pair<double, double> slope, double slabTexels) const;
};

// World normal of the relief: slope (dh/ds, dh/dt) per texel, slab thickness in texels, on a polygon's axes.
glm::dvec3 reliefNormal(const TexturedQuad& quad, std::pair<double, double> slope, double slabTexels);
// World normal from a normal map's vector (OpenGL: x along s, y against t, z out).
glm::dvec3 mappedNormal(const TexturedQuad& quad, glm::vec3 tangent);

// The colour of a height where there is no colour picture.
inline Color heightGrey(double height) {
    return Color(static_cast<float>(0.2 + 0.6 * height));
}

// As lambert of a surface that is turned to the light by this cosine; not positive: turned away.
Color lit(Color albedo, double facing, const Light& light);

// albedo * intensity * (ambient + (1 - ambient) * max(0, n . l)); in shadow only the ambient part.
Color lambert(Color albedo, glm::dvec3 normal, glm::dvec3 toLight, const Light& light, bool shadowed = false);

}  // namespace relief
