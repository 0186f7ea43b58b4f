// The lighting of a pixel, computed from the heights in long double: the slope of the surface at the hit, the normal in
// the world, and Lambert's law.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "relief/reliefs.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

using Truth = long double;

struct Vector {
    Truth x, y, z;
};
Vector of(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}
Vector plus(Vector a, Truth share, Vector b) {
    return {a.x + share * b.x, a.y + share * b.y, a.z + share * b.z};
}
Truth dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Where two patches or columns meet, the slope jumps and rounding decides. The relief repeats.
struct Slope {
    Truth s = 0, t = 0;
    bool jumps = false;
};
Slope slopeAt(const HeightField& field, Truth s, Truth t) {
    constexpr Truth kJump = 1e-5L;
    const bool columns = field.surface() == Surface::Columns;
    const Truth x = columns ? s : s - 0.5L, y = columns ? t : t - 0.5L;
    const auto i = static_cast<long>(std::floor(x)), j = static_cast<long>(std::floor(y));
    const auto h = [&](long di, long dj) {
        const long w = field.width(), n = field.height();
        return static_cast<Truth>(
            field.heights()(static_cast<int>((((i + di) % w) + w) % w), static_cast<int>((((j + dj) % n) + n) % n)));
    };
    const Truth u = x - i, v = y - j;
    const auto near = [](Truth share) { return share < kJump || share > 1 - kJump; };
    if (columns) return {(h(1, 0) - h(-1, 0)) / 2, (h(0, 1) - h(0, -1)) / 2, near(u) || near(v)};
    return {(1 - v) * (h(1, 0) - h(0, 0)) + v * (h(1, 1) - h(0, 1)),
            (1 - u) * (h(0, 1) - h(0, 0)) + u * (h(1, 1) - h(1, 0)), near(u) || near(v)};
}

Vector lightOf(const Light& light) {
    const Truth radians = std::numbers::pi_v<Truth> / 180;
    const Truth a = light.azimuth * radians, e = light.elevation * radians;
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

TEST(LightTruth, PixelsAreLitByTheSlopeWhereTheyMeetTheRelief) {
    constexpr double kColor = 2e-5;  // normals, colours and factors are float
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
            FrameRequest request(HeightField(std::make_shared<const FloatImage>(makeRelief("hills", 48, 40, 5)),
                                             surface, Address::Repeat, 0.15));
            request.width = 60;
            request.height = 45;
            request.scene = scene;
            request.camera.azimuth = 35;
            request.camera.elevation = 40;
            request.light = {.azimuth = 70, .elevation = 25, .ambient = 0.3, .intensity = 0.9};
            Work work(1);
            const auto frame = FrameRenderer(std::make_shared<MapCache>()).render(request, work);
            const Vector toLight = lightOf(request.light);
            int lit = 0, dark = 0;
            for (int y = 0; y < request.height; ++y) {
                for (int x = 0; x < request.width; ++x) {
                    const std::size_t i = frame->index(x, y);
                    const Hit hit = frame->hits->hits[i];
                    if (hit.outcome != Outcome::Hit) continue;
                    const Slope slope = slopeAt(request.field, hit.s, hit.t);
                    if (slope.jumps) continue;
                    const TexturedQuad& quad = frame->polygons[frame->rays->polygon[i]];
                    const Vector up = of(quad.normal), perS = of(quad.plane.perS), perT = of(quad.plane.perT);
                    // The slab is reliefDepth textures thick; a step of one texel along an axis rises by the slope
                    // times that thickness.
                    const Truth texelS = std::sqrt(dot(perS, perS)), texelT = std::sqrt(dot(perT, perT));
                    const Truth slab = 0.15L * 48;
                    const Vector normal =
                        cross(plus(perT, slope.t * slab * texelT, up), plus(perS, slope.s * slab * texelS, up));
                    const Truth facing = dot(normal, toLight) / std::sqrt(dot(normal, normal));
                    const Truth amount = 0.9L * (0.3L + 0.7L * std::max<Truth>(facing, 0));
                    (facing > 0 ? lit : dark) += 1;
                    for (int k = 0; k < 3; ++k) {
                        ASSERT_NEAR(frame->light->color(x, y)[k],
                                    static_cast<double>(amount * static_cast<Truth>(frame->color->color(x, y)[k])),
                                    kColor)
                            << x << " " << y << " " << sceneName(scene);
                    }
                }
            }
            EXPECT_GT(lit, 200);
            EXPECT_GT(dark, 5);
        }
    }
}

// A vector of a normal picture: x along s, y against t, z out of the polygon. Compared with hand-computed results on
// faces with known axes.
TEST(LightTruth, NormalPicturesStandOnTheirPolygon) {
    constexpr double kRounding = 1e-6;  // the picture is float
    const auto expect = [&](const TexturedQuad& quad, glm::vec3 tangent, glm::dvec3 world) {
        EXPECT_LT(glm::length(mappedNormal(quad, tangent) - world), kRounding);
    };
    const TexturedQuad floor = makeScene(SceneKind::Floor, 8, 8)[0], wall = makeScene(SceneKind::Wall, 8, 4)[0];
    const TexturedQuad right = makeScene(SceneKind::Cube, 8, 8)[1];
    expect(floor, {0.6F, 0, 0.8F}, {0.6, 0.8, 0});
    expect(floor, {0, 0.6F, 0.8F}, {0, 0.8, -0.6});
    expect(floor, {0, 0, 1}, {0, 1, 0});
    expect(wall, {0.6F, 0, 0.8F}, {0.6, 0, 0.8});
    expect(wall, {0, 0.6F, 0.8F}, {0, 0.6, 0.8});
    expect(right, {0.6F, 0, 0.8F}, {0.8, 0, -0.6});
    expect(right, {0, 0.6F, 0.8F}, {0.8, 0.6, 0});
    // Vectors of any length.
    expect(floor, {3, 0, 4}, {0.6, 0.8, 0});
}

}  // namespace
}  // namespace relief::test
