// Displacement mapping: traced single rays are compared with the rasterised frame, and both with the exact tracer on a
// fine mesh.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "algorithms/relief/fields.h"
#include "measuring/compare/picture_error.h"
#include "relief/methods/displacement_mesh.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

// Difference of rasterised and traced hits, in texels: the rounding of projected coordinates (about 1e-12 of the
// screen), magnified where the mesh is seen almost edge-on.
constexpr double kHitTolerance = 1e-6;
// Share of the pixels that may differ more: those whose centre is within rounding of a silhouette.
constexpr double kSilhouetteShare = 1e-4;
// PSNR in decibels of the mesh with a vertex on every texel, against exact tracing of the bilinear surface (border):
// the mesh has two triangles in place of one curved patch, which is most visible on steep walls seen from the side. The
// bounds are 10% below the values measured first (in the comments), to allow for different rounding at silhouettes.
struct FineMesh {
    const char* relief;
    SceneKind scene;
    double psnr;
};
constexpr FineMesh kFineMeshes[]{
    {"bricks", SceneKind::Floor, 43},  // 48.0
    {"bricks", SceneKind::Wall, 35},   // 39.8
    {"hills", SceneKind::Floor, 83},   // 93.1
    {"hills", SceneKind::Wall, 87},    // 97.7
    {"city", SceneKind::Floor, 42},    // 47.3
    {"city", SceneKind::Wall, 30},     // 34.2
};

FrameRequest meshRequest(SceneKind scene, Address address, int density, const std::string& relief = "bricks",
                         int width = 64, int height = 48) {
    FrameRequest request(HeightField(share(makeRelief(relief, width, height, 1)), Surface::Bilinear, address, 0.15));
    request.width = 200;
    request.height = 150;
    request.scene = scene;
    request.method = {"displacement", {{"density", std::to_string(density)}}};
    return request;
}

std::shared_ptr<const Frame> rendered(const FrameRequest& request, int threads = 2) {
    Work work(threads);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

struct Agreement {
    std::size_t pixels = 0;
    std::size_t different = 0;
    double worst = 0;
};

// Compares every pixel's rasterised hit with the traced ray of that pixel. Pixels whose traced hit is outside the
// polygon (under repeat and clamp tracing continues there) must be empty.
Agreement comparedWithTracing(const FrameRequest& request) {
    const auto frame = rendered(request);
    MapCache cache;
    Work work;
    const auto tracer = makeTracer(request.method, request.field, cache, work);
    Agreement agreement;
    for (std::size_t i = 0; i < frame->hits->hits.size(); ++i) {
        if (frame->rays->polygon[i] == kNoPolygon) {
            EXPECT_EQ(frame->hits->hits.outcome[i], Outcome::Unset);
            continue;
        }
        ++agreement.pixels;
        const TexturedQuad& quad = frame->polygons[frame->rays->polygon[i]];
        Hit walked = traceLogged(*tracer, frame->rays->rays[i]).hit;
        const bool own = walked.s >= 0 && walked.s <= quad.width && walked.t >= 0 && walked.t <= quad.height;
        if (!own) walked = Hit::none(Outcome::Miss);
        const Hit drawn = frame->hits->hits[i];
        if (walked.outcome != drawn.outcome) {
            ++agreement.different;
        } else if (walked.outcome == Outcome::Hit) {
            const double slab = frame->slabTexels;
            const double apart = std::max({std::abs(walked.s - drawn.s), std::abs(walked.t - drawn.t),
                                           slab * std::abs(walked.lambda - drawn.lambda)});
            if (apart > kHitTolerance) {
                ++agreement.different;
            } else {
                agreement.worst = std::max(agreement.worst, apart);
            }
        }
    }
    return agreement;
}

// The mesh of one surface is not used for the other.
TEST(Displacement, eachSurfaceHasAMeshOfItsOwn) {
    MapCache cache;
    Work work(1);
    const Heights heights = share(makeRelief("city", 32, 32, 1));
    const auto bilinear = meshHeights({heights, Surface::Bilinear, Address::Repeat, 0.2}, 50, cache, work);
    const auto columns = meshHeights({heights, Surface::Columns, Address::Repeat, 0.2}, 50, cache, work);
    EXPECT_FALSE(bilinear->heights == columns->heights);
    EXPECT_EQ(meshHeights({heights, Surface::Bilinear, Address::Repeat, 0.7}, 50, cache, work), bilinear);
}

TEST(Displacement, rasterisedHitsAreTheTracedHits) {
    for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
        for (const Address address : allAddresses()) {
            for (const int density : {1, 7, 64, 150}) {
                FrameRequest request = meshRequest(scene, address, density);
                for (const double elevation : {70.0, 20.0}) {
                    request.camera.elevation = elevation;
                    const Agreement agreement = comparedWithTracing(request);
                    SCOPED_TRACE(std::string(sceneName(scene)) + " " + std::string(addressName(address)) + " density " +
                                 std::to_string(density) + " elevation " + numberText(elevation));
                    EXPECT_GT(agreement.pixels, 1000U);
                    EXPECT_LE(static_cast<double>(agreement.different),
                              1 + kSilhouetteShare * static_cast<double>(agreement.pixels))
                        << "worst of the others " << agreement.worst;
                }
            }
        }
    }
}

// The eye is just above the mesh, so triangles extend behind it and are clipped.
TEST(Displacement, nearTrianglesAreCut) {
    FrameRequest request = meshRequest(SceneKind::Floor, Address::Border, 48);
    request.camera.kind = Camera::Kind::Free;
    request.camera.eye = {0.02, 0.03, 0.1};
    request.camera.target = {0, -0.02, -0.3};
    const Agreement agreement = comparedWithTracing(request);
    EXPECT_GT(agreement.pixels, 1000U);
    EXPECT_LE(static_cast<double>(agreement.different), 1 + kSilhouetteShare * static_cast<double>(agreement.pixels));
}

TEST(Displacement, aFineMeshShowsWhatExactTracingShows) {
    Work work;
    for (const FineMesh& fine : kFineMeshes) {
        FrameRequest request = meshRequest(fine.scene, Address::Border, 128, fine.relief, 128, 128);
        const auto at = [&](const char* density) {
            request.method = {"displacement", {{"density", density}}};
            const auto mesh = rendered(request);
            request.method = {"exact", {}};
            FloatImage flip;
            return pictureError(rendered(request)->light->color, mesh->light->color, kPixelsPerDegree, flip, work).psnr;
        };
        const double coarse = at("16");
        const double everyTexel = at("128");
        const double finer = at("1152");
        std::cout << fine.relief << " " << sceneName(fine.scene) << ": " << coarse << ", " << everyTexel << ", "
                  << finer << " dB with 16, 128, 1152 quads a side\n";
        EXPECT_GE(everyTexel, fine.psnr);
        EXPECT_LT(coarse, everyTexel) << "a coarse mesh must show";
        EXPECT_GT(finer, everyTexel) << "nine vertices a texel side: nearer to the curved patches";
    }
}

// Every density that is a multiple of the map's has vertices on all texel centres: doubling it never increases the
// distance from the surface.
TEST(Displacement, refiningTheMapsOwnMeshLowersTheError) {
    constexpr int kSide = 32;
    Work work;
    for (const std::string relief : {"bricks", "fractal", "city", "hills"}) {
        for (const Address address : allAddresses()) {
            SCOPED_TRACE(relief + " " + std::string(addressName(address)));
            const HeightField field(share(makeRelief(relief, kSide, kSide, 1)), Surface::Bilinear, address, 0.2);
            MapCache cache;
            double before = std::numeric_limits<double>::infinity();
            for (const int density : {kSide, 2 * kSide, 4 * kSide, 8 * kSide}) {
                const auto tracer =
                    makeTracer({"displacement", {{"density", std::to_string(density)}}}, field, cache, work);
                const HeightField& mesh = tracer->mesh()->mesh();
                const int every = density / kSide;
                // The difference of the mesh from the surface, in the middle of the finest quads and at the texels.
                double error = 0;
                constexpr int kLooks = 16;
                for (int y = 0; y < kLooks * (kSide - 1); ++y) {
                    for (int x = 0; x < kLooks * (kSide - 1); ++x) {
                        const double s = (x + 0.5) / kLooks;
                        const double t = (y + 0.5) / kLooks;
                        const auto i = static_cast<int>(s * every);
                        const auto j = static_cast<int>(t * every);
                        const double height = DisplacementMesh::height(
                            {mesh.texel(i, j), mesh.texel(i + 1, j), mesh.texel(i, j + 1), mesh.texel(i + 1, j + 1)},
                            s * every - i, t * every - j);
                        error += std::abs(height - field.at(s + 0.5, t + 0.5));
                    }
                }
                for (int y = 0; y < kSide; ++y) {
                    for (int x = 0; x < kSide; ++x) {
                        ASSERT_EQ(mesh.texel(x * every, y * every), field.texel(x, y)) << density;
                    }
                }
                EXPECT_LE(error, before * 0.5) << density << ": the error falls with the square of the quads";
                before = error;
            }
        }
    }
}

// The same for traced rays: the mean error against exact.
TEST(Displacement, refinedMeshesAreHitCloserToTheSurface) {
    constexpr int kSide = 32;
    Work work;
    for (const std::string relief : {"bricks", "fractal", "hills"}) {
        const HeightField field(share(makeRelief(relief, kSide, kSide, 1)), Surface::Bilinear, Address::Repeat, 0.2);
        MapCache cache;
        RayBlock rays;
        Random random(9);
        for (int n = 0; n < 3000; ++n) rays.push(randomRay(random, field, 3));
        HitBlock truth;
        NullSink sink;
        makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, sink, work);
        double before = std::numeric_limits<double>::infinity();
        for (const int density : {kSide, 2 * kSide, 4 * kSide}) {
            HitBlock hits;
            makeTracer({"displacement", {{"density", std::to_string(density)}}}, field, cache, work)
                ->trace(rays, hits, sink, work);
            double sum = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) sum += std::abs(hits.lambda[i] - truth.lambda[i]);
            EXPECT_LE(sum, before) << relief << " " << density;
            before = sum;
        }
    }
}

TEST(Displacement, sameBitsForAnyNumberOfThreads) {
    const FrameRequest request = meshRequest(SceneKind::Cube, Address::Repeat, 100);
    const auto one = rendered(request, 1);
    const auto two = rendered(request, 2);
    for (std::size_t i = 0; i < one->hits->hits.size(); ++i) {
        ASSERT_TRUE(sameBits(one->hits->hits[i], two->hits->hits[i])) << i;
    }
    EXPECT_TRUE(one->light->color == two->light->color);
}

TEST(Displacement, flatMeshesAreTheClosedForm) {
    MapCache cache;
    Work work;
    for (const Address address : allAddresses()) {
        for (const float h : {0.0F, 0.3F, 1.0F}) {
            const HeightField field(constantHeights(13, 7, h), Surface::Bilinear, address, 0.2);
            const auto tracer = makeTracer({"displacement", {{"density", "19"}}}, field, cache, work);
            Random random(7);
            for (int i = 0; i < 500; ++i) {
                ViewRay ray = randomRay(random, field, 5);
                if (address == Address::Border) ray = {6.5, 3.5, ray.a * 0.1, ray.b * 0.1};
                const Hit hit = traceLogged(*tracer, ray).hit;
                ASSERT_EQ(hit.outcome, Outcome::Hit) << describe(ray);
                EXPECT_NEAR(hit.lambda, 1 - static_cast<double>(h), 1e-14);
            }
        }
    }
}

// A traced hit lies on the mesh, nothing of the mesh is above the ray before it, and under repeat and clamp no ray
// misses; checked by dense sampling of an independent height function.
TEST(Displacement, tracingFindsTheFirstPointOfTheMesh) {
    constexpr int kLooks = 400;
    MapCache cache;
    Work work;
    for (const Address address : allAddresses()) {
        const HeightField field(randomHeights(9, 6, 12), Surface::Bilinear, address, 0.5);
        const int density = 11;
        const auto tracer = makeTracer({"displacement", {{"density", "11"}}}, field, cache, work);
        const DisplacementMesh& mesh = *tracer->mesh();
        const auto heightAt = [&](double s, double t) {
            const double x = (s - 0.5) * density / field.width();
            const double y = (t - 0.5) * density / field.height();
            const auto i = static_cast<std::int64_t>(std::floor(x));
            const auto j = static_cast<std::int64_t>(std::floor(y));
            const double u = x - std::floor(x);
            const double v = y - std::floor(y);
            const double h00 = mesh.mesh().texel(i, j);
            const double h10 = mesh.mesh().texel(i + 1, j);
            const double h01 = mesh.mesh().texel(i, j + 1);
            const double h11 = mesh.mesh().texel(i + 1, j + 1);
            // Barycentric interpolation in the triangle that contains (u, v).
            return u >= v ? (1 - u) * h00 + (u - v) * h10 + v * h11 : (1 - v) * h00 + (v - u) * h01 + u * h11;
        };
        Random random(15);
        for (int n = 0; n < 2000; ++n) {
            const ViewRay ray = randomRay(random, field, 4);
            const Logged logged = traceLogged(*tracer, ray);
            EXPECT_LE(static_cast<double>(logged.steps.size()), tracer->stepBound(ray));
            if (address != Address::Border) {
                ASSERT_EQ(logged.hit.outcome, Outcome::Hit) << describe(ray);
            }
            const bool hit = logged.hit.outcome == Outcome::Hit;
            const auto inside = [&](double s, double t) {
                return address != Address::Border || (s >= 0 && s <= field.width() && t >= 0 && t <= field.height());
            };
            if (hit && logged.hit.lambda > 0) {
                EXPECT_NEAR(heightAt(logged.hit.s, logged.hit.t), 1 - logged.hit.lambda, 1e-12) << describe(ray);
            }
            const double end = hit ? logged.hit.lambda : 1.0;
            for (int k = 0; k < kLooks; ++k) {
                const double lambda = end * k / kLooks;
                const double s = ray.s0 + lambda * ray.a;
                const double t = ray.t0 + lambda * ray.b;
                if (!inside(s, t)) break;
                ASSERT_LE(heightAt(s, t), 1 - lambda + 1e-12) << describe(ray) << " at " << lambda;
            }
        }
    }
}

TEST(Displacement, theMeshIsSampledOnce) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = meshRequest(SceneKind::Floor, Address::Repeat, 32);
    const auto first = renderer.render(request, work);
    EXPECT_GT(first->counters.at(MessageId::CountTriangles), 32 * 32);
    EXPECT_EQ(first->counters.at(MessageId::CountRaysTraced), 0);
    request.camera.azimuth += 10;
    renderer.render(request, work);
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 1);
    EXPECT_THROW(rendered(meshRequest(SceneKind::Floor, Address::Repeat, 0)), InputError);
}

}  // namespace
}  // namespace relief::test
