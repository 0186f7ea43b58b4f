// A normal map precomputed from the heights, as tools bake it, with 8 bits per component.
//
// Texel (i, j) stores the normal of the surface at its centre, from central differences of the neighbouring heights
// (addressed), in the tangent frame of normal pictures (OpenGL: x along s, y against t, z out). Each component is
// rounded to n / 127, n from -127 to 127, which is at most 1/254 off; a level surface remains exactly level.
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
    // Tangent-space vector at (s, t), in texels not reduced to a period: interpolated bilinearly between texel centres,
    // not normalised.
    glm::vec3 at(double s, double t, Address address) const;
};

// Takes the map from the cache, or bakes it in parallel; O(texels). Depends on addressing and on the slab's thickness.
std::shared_ptr<const BakedNormals> bakedNormals(const HeightField& field, MapCache& cache, Work& work);

}  // namespace relief
