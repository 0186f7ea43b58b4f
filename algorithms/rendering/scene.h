// The scene: textured parallelograms below which the relief lies.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "mapping/homography.h"

namespace relief {

// Floor: one polygon, facing up. Wall: one upright polygon, facing +z. Cube: six, facing outwards. Each shows the
// picture once, with the picture's aspect; the cube's top and bottom are square, so that it is cropped or repeated
// there.
enum class SceneKind : std::uint8_t { Floor, Wall, Cube };

std::string_view sceneName(SceneKind kind);
SceneKind parseScene(std::string_view text);  // throws InputError("--scene", ...)

// A parallelogram in world units that shows the texels [0, width] x [0, height] of its plane. normal: unit vector
// towards the front; the relief lies behind it, below the polygon.
struct TexturedQuad {
    TexturedPlane plane;
    int width = 1;
    int height = 1;
    glm::dvec3 normal{0, 0, 1};
};

// width, height: size of the height map, texels.
std::vector<TexturedQuad> makeScene(SceneKind kind, int width, int height);

}  // namespace relief
