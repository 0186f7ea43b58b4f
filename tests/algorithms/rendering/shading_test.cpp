// Methods that only shade: the picture stays on its polygon, and lighting uses the normal that each method defines.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"
#include "measuring/random_rays.h"
#include "relief/methods/look_up_point.h"
#include "rendering/frame.h"
#include "rendering/light_lanes.h"

namespace relief::test {
namespace {

// Three components, each rounded to 1/127.
constexpr double kBakedRounding = 1.7320508 / 254 + 1e-6;
// Between texels the slope of patches jumps, while interpolated normals do not; on these hills 0.065 was measured
// first.
constexpr double kBakedAngle = 0.08;

std::vector<MethodDescription> shadingMethods() {
    std::vector<MethodDescription> all;
    for (const MethodDescription& method : tracerList()) {
        if (method.kind == MethodKind::Shading) all.push_back(method);
    }
    return all;
}

FrameRequest hillsRequest(const std::string& method) {
    FrameRequest request(HeightField(share(makeRelief("hills", 128, 96, 1))));
    request.width = 120;
    request.height = 90;
    request.scene = SceneKind::Cube;
    request.method = {method, {}};
    return request;
}

std::shared_ptr<const Frame> rendered(const FrameRequest& request) {
    Work work(2);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

template <class Body>
void forEachHit(const Frame& frame, const Body& body) {
    int seen = 0;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const std::size_t i = frame.index(x, y);
            if (frame.hits->hits.outcome[i] != Outcome::Hit) continue;
            ++seen;
            body(x, y, i);
        }
    }
    EXPECT_GT(seen, 500);
}

// Relief with computed normals is lit in SIMD.
TEST(Shading, lanesHaveTheBitsOfOneNormal) {
    Random random(5);
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{64, 48}, {37, 21}, {1, 3}}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            const HeightField field(share(makeRelief("city", width, height, 1)), Surface::Bilinear, address, 0.15);
            const TexturedQuad quad = makeScene(SceneKind::Cube, width, height)[1];
            const ReliefAxes axes(quad);
            Work work;
            const PackedCones cones = buildPackedCones(field, work);
            ASSERT_FALSE(cones.nodes.empty());
            const glm::dvec3 toLight = lightDirection({});
            // Positions within the map, on nodes and rims, and whole periods away.
            std::vector<double> s, t;
            for (int n = 0; n < 501; ++n) {
                const double far = n % 5 == 0 ? 3 : 1;
                s.push_back(n % 7 == 0 ? random.below(width) + 0.5 : random.between(-far, far) * width);
                t.push_back(n % 11 == 0 ? height : random.between(-far, far) * height);
            }
            onEveryTarget([&] {
                std::vector<double> facing(s.size()), byNodes(s.size());
                facingLight(SlopeScene(field), axes, field.slabTexels(), toLight, s, t, facing);
                facingLight(SlopeScene(field, cones), axes, field.slabTexels(), toLight, s, t, byNodes);
                EXPECT_EQ(byNodes, facing);
                for (std::size_t n = 0; n < s.size(); ++n) {
                    const glm::vec3 normal(reliefNormal(quad, field.slope(s[n], t[n]), field.slabTexels()));
                    ASSERT_EQ(facing[n], glm::dot(glm::dvec3(normal), toLight)) << s[n] << ' ' << t[n];
                }
            });
        }
    }
}

TEST(Shading, aFrameIsLitByItsNormals) {
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Cube}) {
        FrameRequest request = hillsRequest("max-pyramid");
        request.scene = scene;
        request.shadows = true;
        const auto frame = rendered(request);
        forEachHit(*frame, [&](int x, int y, std::size_t i) {
            const Color expected =
                lambert(frame->color->color(x, y), frame->normal(x, y, request), lightDirection(request.light),
                        request.light, frame->shadows->shadowed[i] != 0);
            ASSERT_EQ(frame->light->color(x, y), expected) << x << ' ' << y;
        });
    }
}

// Normals and light from their definitions in long double: the cross product of the surface's tangents in the world,
// and angles in the sky.
TEST(Shading, normalsAndLightAreThoseOfTheWorld) {
    using Truth = long double;
    constexpr double kRounding = 1e-12;
    struct Vector {
        Truth x, y, z;
    };
    const auto of = [](glm::dvec3 v) { return Vector{v.x, v.y, v.z}; };
    const auto cross = [](Vector a, Vector b) {
        return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const auto dot = [](Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    Random random(12);
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
        for (const TexturedQuad& quad : makeScene(scene, 24, 16)) {
            const Vector s = of(quad.plane.perS), t = of(quad.plane.perT), n = of(quad.normal);
            EXPECT_NEAR(static_cast<double>(dot(n, n)), 1, kRounding);
            for (int k = 0; k < 50; ++k) {
                const Truth slopeS = random.between(-2, 2), slopeT = random.between(-2, 2),
                            slab = random.between(0, 30);
                // A step of one texel has this length, and rises by the slope times the slab's thickness.
                const Truth texelS = std::sqrt(dot(s, s)), texelT = std::sqrt(dot(t, t));
                const Vector alongS{s.x + slopeS * slab * texelS * n.x, s.y + slopeS * slab * texelS * n.y,
                                    s.z + slopeS * slab * texelS * n.z};
                const Vector alongT{t.x + slopeT * slab * texelT * n.x, t.y + slopeT * slab * texelT * n.y,
                                    t.z + slopeT * slab * texelT * n.z};
                Vector normal = cross(alongT, alongS);
                const Truth length = std::sqrt(dot(normal, normal)) * (dot(normal, n) < 0 ? -1 : 1);
                const glm::dvec3 found = reliefNormal(quad, {static_cast<double>(slopeS), static_cast<double>(slopeT)},
                                                      static_cast<double>(slab));
                EXPECT_NEAR(found.x, static_cast<double>(normal.x / length), kRounding);
                EXPECT_NEAR(found.y, static_cast<double>(normal.y / length), kRounding);
                EXPECT_NEAR(found.z, static_cast<double>(normal.z / length), kRounding);
            }
        }
    }
    // The elevation is measured from the ground towards y, the azimuth from z to x.
    const auto near = [&](double azimuth, double elevation, glm::dvec3 expected) {
        const glm::dvec3 found = lightDirection({.azimuth = azimuth, .elevation = elevation});
        EXPECT_LT(glm::length(found - expected), kRounding) << azimuth << " " << elevation;
    };
    near(0, 0, {0, 0, 1});
    near(90, 0, {1, 0, 0});
    near(180, 0, {0, 0, -1});
    near(17, 90, {0, 1, 0});
    near(-90, 30, {-std::sqrt(0.75), 0.5, 0});
    near(45, 45, {0.5, std::sqrt(0.5), 0.5});
    // A surface turned away from the light, or in shadow, has ambient light only.
    const Light light{.ambient = 0.2, .intensity = 1.5};
    const glm::dvec3 up{0, 1, 0};
    for (const auto& [toLight, shadowed, amount] :
         {std::tuple(up, false, 1.5), std::tuple(-up, false, 0.3), std::tuple(up, true, 0.3),
          std::tuple(glm::dvec3(std::sqrt(0.75), 0.5, 0), false, 0.9)}) {
        const Color found = lambert(Color(1, 0.5F, 0.25F), up, toLight, light, shadowed);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], amount * std::ldexp(1.0, -c), 1e-6) << amount;
    }
}

TEST(Shading, thereAreThree) {
    std::vector<std::string> names;
    for (const MethodDescription& method : shadingMethods()) names.push_back(method.name);
    EXPECT_EQ(names, (std::vector<std::string>{"flat", "bump", "normal-map"}));
}

TEST(Shading, raysStayOnTheTopPlane) {
    MapCache cache;
    Work work;
    for (const MethodDescription& method : shadingMethods()) {
        SCOPED_TRACE(method.name);
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(13, 9, 5), surface, address);
                const auto tracer = makeTracer({method.name, {}}, field, cache, work);
                Random random(3);
                for (int i = 0; i < 200; ++i) {
                    const ViewRay ray{random.between(-13, 26), random.between(-9, 18), random.between(-30, 30), 7};
                    const bool inside = ray.s0 >= 0 && ray.s0 <= 13 && ray.t0 >= 0 && ray.t0 <= 9;
                    const bool hits = inside || address != Address::Border;
                    const Logged logged = traceLogged(*tracer, ray);
                    ASSERT_EQ(logged.hit.outcome, hits ? Outcome::Hit : Outcome::Miss) << describe(ray);
                    ASSERT_EQ(logged.steps.size(), 2U);
                    EXPECT_EQ(logged.steps[0].decision, Decision::Start);
                    EXPECT_EQ(logged.steps[1].decision, hits ? Decision::Hit : Decision::Miss);
                    EXPECT_LE(2, tracer->stepBound(ray));
                    if (!hits) continue;
                    EXPECT_EQ(logged.hit.lambda, 0);
                    EXPECT_EQ(logged.hit.s, ray.s0);
                    EXPECT_EQ(logged.hit.t, ray.t0);
                }
            }
        }
    }
}

TEST(Shading, flatIsLitAsThePolygon) {
    const FrameRequest request = hillsRequest("flat");
    const auto frame = rendered(request);
    forEachHit(*frame, [&](int x, int y, std::size_t i) {
        const TexturedQuad& quad = frame->polygons[frame->rays->polygon[i]];
        EXPECT_EQ(frame->normal(x, y, request), glm::vec3(quad.normal));
        EXPECT_EQ(frame->light->color(x, y),
                  lambert(frame->color->color(x, y), quad.normal, lightDirection(request.light), request.light));
    });
}

TEST(Shading, bumpSeesTheSlopesEvenWhereThereIsANormalPicture) {
    FrameRequest request = hillsRequest("bump");
    request.normals = std::make_shared<Image<glm::vec3>>(4, 4, glm::vec3(0.6F, 0, 0.8F));
    const auto frame = rendered(request);
    double steepest = 0;
    forEachHit(*frame, [&](int x, int y, std::size_t i) {
        const TexturedQuad& quad = frame->polygons[frame->rays->polygon[i]];
        const auto slope = request.field.slope(frame->hits->hits.s[i], frame->hits->hits.t[i]);
        const glm::vec3 normal = frame->normal(x, y, request);
        EXPECT_EQ(normal, glm::vec3(reliefNormal(quad, slope, frame->slabTexels)));
        steepest = std::max(steepest, std::acos(std::min(1.0, glm::dot(glm::dvec3(normal), quad.normal))));
    });
    EXPECT_GT(steepest, 0.2) << "a relief with only vertical normals tests nothing";
}

TEST(Shading, normalMapIsThePictureOrBaked) {
    FrameRequest request = hillsRequest("normal-map");
    const auto baked = rendered(request);
    double worst = 0;
    double different = 0;
    forEachHit(*baked, [&](int x, int y, std::size_t i) {
        const TexturedQuad& quad = baked->polygons[baked->rays->polygon[i]];
        const auto slope = request.field.slope(baked->hits->hits.s[i], baked->hits->hits.t[i]);
        const glm::dvec3 truth = reliefNormal(quad, slope, baked->slabTexels);
        const double apart = glm::length(truth - glm::dvec3(baked->normal(x, y, request)));
        worst = std::max(worst, apart);
        different += apart > 1e-6 ? 1 : 0;
    });
    std::cout << "baked normals are at most " << worst << " off\n";
    EXPECT_LE(worst, kBakedAngle);
    EXPECT_GT(different, 500) << "8 bits must show";
    request.normals = std::make_shared<Image<glm::vec3>>(4, 4, glm::vec3(0.6F, 0, 0.8F));
    const auto given = rendered(request);
    forEachHit(*given, [&](int x, int y, std::size_t i) {
        const TexturedQuad& quad = given->polygons[given->rays->polygon[i]];
        const glm::vec3 expected(mappedNormal(quad, glm::vec3(0.6F, 0, 0.8F)));
        EXPECT_LE(glm::length(given->normal(x, y, request) - expected), 1e-6F);
    });
}

TEST(Shading, bakedTexelsAreTheRoundedNormals) {
    MapCache cache;
    Work work;
    for (const Address address : allAddresses()) {
        const HeightField field(randomHeights(19, 11, 4), Surface::Bilinear, address, 0.2);
        const auto baked = bakedNormals(field, cache, work);
        for (int j = 0; j < 11; ++j) {
            for (int i = 0; i < 19; ++i) {
                const double perS = (field.texel(i + 1, j) - field.texel(i - 1, j)) / 2.0;
                const double perT = (field.texel(i, j + 1) - field.texel(i, j - 1)) / 2.0;
                const glm::dvec3 truth = glm::normalize(glm::dvec3(-3.8 * perS, 3.8 * perT, 1));
                const glm::dvec3 stored(baked->at(i + 0.5, j + 0.5, address));
                EXPECT_LE(glm::length(stored - truth), kBakedRounding);
                EXPECT_EQ(baked->at(i + 0.5 + 190, j + 0.5, Address::Repeat),
                          baked->at(i + 0.5, j + 0.5, Address::Repeat));
            }
        }
    }
}

TEST(Shading, bakedNormalsFollowTheDepthAndAreBakedOnce) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = hillsRequest("normal-map");
    renderer.render(request, work);
    request.light.azimuth += 20;
    renderer.render(request, work);
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 1);
    request.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.3);
    const auto deeper = renderer.render(request, work);
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 2);
    EXPECT_TRUE(deeper->light->color == rendered(request)->light->color);
}

// The colour and slope of a column's wall are those of the column that was hit, on whichever side rounding puts the
// hit.
TEST(Shading, wallsOfColumnsBelongToTheColumnHit) {
    MapCache cache;
    Work work;
    for (const Address address : allAddresses()) {
        const HeightField field(randomHeights(23, 17, 9), Surface::Columns, address, 0.4);
        const auto tracer = makeTracer({"exact", {}}, field, cache, work);
        Random random(77);
        int walls = 0;
        int wrongSide = 0;
        for (int n = 0; n < 20000; ++n) {
            const ViewRay ray = randomRay(random, field, 2);
            const Logged logged = traceLogged(*tracer, ray);
            if (logged.hit.outcome != Outcome::Hit) continue;
            const Step& last = logged.steps.back();
            const glm::dvec2 place = lookUpPoint(field, ray, logged.hit);
            const auto column = [&](double x, int size) {
                return addressIndex(static_cast<std::int64_t>(std::floor(x)), size, address);
            };
            ASSERT_EQ(column(place.x, 23), addressIndex(last.i, 23, address)) << describe(ray);
            ASSERT_EQ(column(place.y, 17), addressIndex(last.j, 17, address)) << describe(ray);
            EXPECT_LE(std::abs(place.x - logged.hit.s), 2 * kWallNudge);
            EXPECT_LE(std::abs(place.y - logged.hit.t), 2 * kWallNudge);
            if (place == glm::dvec2(logged.hit.s, logged.hit.t)) continue;
            ++walls;
            wrongSide +=
                column(logged.hit.s, 23) != column(place.x, 23) || column(logged.hit.t, 17) != column(place.y, 17);
        }
        std::cout << walls << " walls hit, " << wrongSide << " of them rounded to the other side\n";
        EXPECT_GT(walls, 5000);
        EXPECT_GT(wrongSide, 500) << "otherwise there is nothing to mend";
    }
}

// Hits on tops just before a border, from all eight directions: the top is visible, not the ground behind it.
TEST(Shading, topsOfColumnsBelongToTheirColumn) {
    MapCache cache;
    Work work;
    const int width = 13, height = 11;
    for (const Address address : allAddresses()) {
        const HeightField field(randomHeights(width, height, 10), Surface::Columns, address, 0.4);
        const auto tracer = makeTracer({"exact", {}}, field, cache, work);
        int moved = 0;
        for (int n = 0; n < 8 * width * height; ++n) {
            constexpr int kWays[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
            const auto& [alongX, alongY] = kWays[n % 8];
            const int i = n / 8 % width, j = n / 8 / width;
            // A quarter of the nudge before the line towards which the ray runs; across it, or along both axes towards
            // the corner.
            const auto end = [](int index, int way, double run) {
                const double line = way > 0 ? index + 1 : index;
                return way == 0 ? index + 0.5 : line - std::copysign(kWallNudge / 4, run);
            };
            ViewRay ray;
            ray.a = 0.1 * alongX;
            ray.b = 0.13 * alongY;
            const double lambda = 1 - static_cast<double>(field.heights()(i, j));
            ray.s0 = end(i, alongX, ray.a) - lambda * ray.a;
            ray.t0 = end(j, alongY, ray.b) - lambda * ray.b;
            const Logged logged = traceLogged(*tracer, ray);
            const Step& last = logged.steps.back();
            // In front of a column of at least that height the hit belongs to the wall, by design: both are closer than
            // a nudge.
            if (field.texel(i + alongX, j + alongY) >= field.texel(i, j)) continue;
            if (logged.hit.outcome != Outcome::Hit) continue;
            const glm::dvec2 place = lookUpPoint(field, ray, logged.hit);
            const auto column = [&](double x, int size) {
                return addressIndex(static_cast<std::int64_t>(std::floor(x)), size, address);
            };
            EXPECT_EQ(column(place.x, width), addressIndex(last.i, width, address)) << describe(ray);
            EXPECT_EQ(column(place.y, height), addressIndex(last.j, height, address)) << describe(ray);
            moved += place == glm::dvec2(logged.hit.s, logged.hit.t) ? 0 : 1;
        }
        EXPECT_GT(moved, 2 * width * height) << "of rays that end beside a line";
    }
}

}  // namespace
}  // namespace relief::test
