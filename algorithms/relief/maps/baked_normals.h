// A normal map computed once from the heights, as tools bake it: 8 bits a component.
//
// Texel (i, j) holds the normal of the surface at its centre, from central differences of the heights beside it
// (addressed), in the tangent frame of normal pictures (OpenGL: x along s, y against t, z out), each component rounded
// to n / 127, n from -127 to 127: at most 1/254 off, and what is level stays exactly level.
#pragma once

#include <cstdint>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

#include "relief/height_field.h"
#include "relief/map_cache.h"

namespace relief {

struct BakedNormals {
    Image<glm::i8vec3> texels;

    std::size_t bytes() const { return texels.bytes(); }
    // Tangent-space vector at (s, t), texels, unwrapped: bilinear between texel centres, not of unit length.
    glm::vec3 at(double s, double t, Address address) const;
};

// From the cache, or baked (O(texels), in parallel). Depends on addressing and on the slab's thickness.
std::shared_ptr<const BakedNormals> bakedNormals(const HeightField& field, MapCache& cache, Work& work);

}  // namespace relief
