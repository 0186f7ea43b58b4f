// The scene: textured parallelograms under which the relief lies.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace relief {

// Floor: one polygon, face up. Wall: one, upright, facing +z. Cube: six, facing out. Each shows the picture once, with
// the picture's aspect (the cube's faces are square).
enum class SceneKind : std::uint8_t { Floor, Wall, Cube };

std::string_view sceneName(SceneKind kind);
SceneKind parseScene(std::string_view text);  // throws InputError("--scene", ...)

// A parallelogram in world units: origin is the texture's corner (0, 0), alongS and alongT its edges, s growing along
// alongS and t along alongT, the whole texture on it. The front is where alongT x alongS... points: see `normal`.
struct TexturedQuad {
    glm::dvec3 origin;
    glm::dvec3 alongS;
    glm::dvec3 alongT;
    glm::dvec3 normal;  // unit, towards the front: the relief lies behind, under the polygon
};

// width, height: of the height map, texels.
std::vector<TexturedQuad> makeScene(SceneKind kind, int width, int height);

}  // namespace relief
