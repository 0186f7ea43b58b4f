// Lambert shading with one directional light, and the normal of the relief.
#pragma once

#include <utility>

#include <glm/vec3.hpp>

#include "relief/image.h"
#include "rendering/scene.h"

namespace relief {

// Direction towards the light: azimuth and elevation in degrees, as for the camera. ambient in [0, 1]: the part of the
// light that also reaches surfaces turned away; intensity scales both parts.
struct Light {
    double azimuth = -50;
    double elevation = 40;
    double ambient = 0.25;
    double intensity = 1.15;
    bool operator==(const Light&) const = default;
};

// Returns the unit vector towards the light, world space.
glm::dvec3 lightDirection(const Light& light);

// Returns the texels (s, t) that the light passes over while it rises from the bottom of the polygon's slab to its top.
// The light must be in front of the polygon. slabTexels: slab thickness in texels.
glm::dvec2 lightRun(const TexturedQuad& quad, glm::dvec3 toLight, double slabTexels);

// A polygon's axes normalised to length 1, computed once for many normals.
struct ReliefAxes {
    glm::dvec3 normal, alongS, alongT;

    explicit ReliefAxes(const TexturedQuad& quad);
    // The same result as reliefNormal().
    glm::dvec3 normalOf(std::pair<double, double> slope, double slabTexels) const;
};

// Returns the world-space unit normal of the relief. slope: (dh/ds, dh/dt) per texel; slabTexels: slab thickness in
// texels.
glm::dvec3 reliefNormal(const TexturedQuad& quad, std::pair<double, double> slope, double slabTexels);
// Returns the world-space unit normal for a normal map's vector (OpenGL convention: x along s, y against t, z
// outwards).
glm::dvec3 mappedNormal(const TexturedQuad& quad, glm::vec3 tangent);

// Returns the grey that shows a height where there is no colour picture.
inline Color heightGrey(double height) {
    return Color(static_cast<float>(0.2 + 0.6 * height));
}

// The same as lambert() for a surface with this cosine between its normal and the light; not positive: turned away.
Color lit(Color albedo, double facing, const Light& light);

// Returns albedo * intensity * (ambient + (1 - ambient) * max(0, n . l)); in shadow only the ambient part.
Color lambert(Color albedo, glm::dvec3 normal, glm::dvec3 toLight, const Light& light, bool shadowed = false);

}  // namespace relief
