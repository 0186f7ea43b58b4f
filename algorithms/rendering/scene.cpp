#include "rendering/scene.h"

#include <array>
#include <string>

#include <glm/geometric.hpp>

#include "relief/errors.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 3> kScenes{"floor", "wall", "cube"};

// center: the middle of the polygon; alongS, alongT: its edge vectors, whole length.
TexturedQuad quad(glm::dvec3 center, glm::dvec3 alongS, glm::dvec3 alongT, int width, int height) {
    TexturedQuad made;
    made.plane.origin = center - 0.5 * alongS - 0.5 * alongT;
    made.plane.perS = alongS / static_cast<double>(width);
    made.plane.perT = alongT / static_cast<double>(height);
    made.width = width;
    made.height = height;
    made.normal = glm::normalize(made.plane.frontNormal());
    return made;
}

}  // namespace

std::string_view sceneName(SceneKind kind) {
    return kScenes[static_cast<std::size_t>(kind)];
}

SceneKind parseScene(std::string_view text) {
    for (std::size_t i = 0; i < kScenes.size(); ++i) {
        if (kScenes[i] == text) return static_cast<SceneKind>(i);
    }
    throw InputError("--scene", unknownName({"what", MessageId::WordScene}, std::string(text), "floor, wall, cube"));
}

std::vector<TexturedQuad> makeScene(SceneKind kind, int width, int height) {
    const double aspect = static_cast<double>(height) / width;
    const glm::dvec3 x{1, 0, 0};
    const glm::dvec3 y{0, 1, 0};
    const glm::dvec3 z{0, 0, 1};
    switch (kind) {
        case SceneKind::Floor:
            return {quad({0, 0, 0}, x, aspect * z, width, height)};
        case SceneKind::Wall:
            return {quad({0, 0, 0}, x, -aspect * y, width, height)};
        case SceneKind::Cube:
            break;
    }
    // The box is as wide and deep as the picture and as high as its aspect requires, so that texels are square on all
    // sides; on top and bottom the picture is cropped or repeated to a square.
    const double high = aspect;
    std::vector<TexturedQuad> faces{
        quad({0, 0, 0.5}, x, -high * y, width, height), quad({0.5, 0, 0}, -z, -high * y, width, height),
        quad({0, 0, -0.5}, -x, -high * y, width, height), quad({-0.5, 0, 0}, z, -high * y, width, height)};
    faces.push_back(quad({0, 0.5 * high, 0}, x, z, width, width));
    faces.push_back(quad({0, -0.5 * high, 0}, x, -z, width, width));
    return faces;
}

}  // namespace relief
