// The whole exported fragment shader, drawn by OpenGL, against exact hits of the CPU: place, silhouette at the
// border, depth and self-shadow.
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "algorithms/relief/fields.h"
#include "shaders/shader_fixture.h"

namespace relief::test {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr double kNear = 0.1, kFar = 10;
const glm::dvec3 kEye(0.45, 1.35, 0.62);  // in the polygon's tangent frame
const glm::dvec3 kLight(-0.6, 0.35, 0.5);

class ShaderPicture : public ShaderTest {
  protected:
    Gl::Picture draw(const std::string& tracer, const ShaderUniforms& uniforms, const ShaderTexture& colors) {
        ShaderChoice choice;
        choice.method.name = tracer;
        choice.address = Address::Border;
        bindMaps(*gl_, choice, field_, uniforms, work_);
        gl_->setTexture(2, colors, Address::Clamp);
        return gl_->draw(vertexText(), shaderText(choice, "test"), kWidth, kHeight);
    }
    // The colour of a place is the place.
    static ShaderTexture places() {
        ShaderTexture data{kSide, kSide, 1, 4, {{}}, true};
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                for (const double number : {(x + 0.5) / kSide, (y + 0.5) / kSide, 1.0, 1.0}) {
                    data.levels[0].push_back(static_cast<float>(number));
                }
            }
        }
        return data;
    }
    // The colour is the level.
    static ShaderTexture levels(int side) {
        ShaderTexture data{side, side, 1, 4, {}, true};
        for (int l = 0; side >> l > 0; ++l) {
            const auto count = static_cast<std::size_t>(side >> l) * static_cast<std::size_t>(side >> l) * 4;
            data.levels.emplace_back(count, static_cast<float>(l));
        }
        return data;
    }
    std::string vertexText() const {
        const auto three = [](glm::dvec3 v) {
            return "vec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
        };
        std::string matrix;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                matrix += (matrix.empty() ? "" : ", ") + std::to_string(view_[column][row]);
            }
        }
        return "#version 450\n"
               "layout(location = 0) out vec2 texcoord;\nlayout(location = 1) out vec3 fromEye;\n"
               "layout(location = 2) out vec3 toLight;\nvoid main() {\n"
               "    texcoord = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n    vec3 point = vec3(texcoord, 0.0);\n"
               "    fromEye = point - " +
               three(kEye) + ";\n    toLight = " + three(kLight) +
               ";\n"
               "    gl_Position = mat4(" +
               matrix + ") * vec4(point, 1.0);\n}\n";
    }
    // The view ray of a pixel, counted from below, where it meets the polygon's plane; nullopt outside the polygon.
    struct View {
        ViewRay ray;
        glm::dvec3 fromEye;
    };
    std::optional<View> viewOf(int x, int y) const {
        const glm::dvec4 far =
            inverse(view_) * glm::dvec4(2.0 * (x + 0.5) / kWidth - 1, 2.0 * (y + 0.5) / kHeight - 1, 1, 1);
        const glm::dvec3 along = glm::dvec3(far) / far.w - kEye;
        if (along.z >= 0) return std::nullopt;
        const glm::dvec3 fromEye = along * (-kEye.z / along.z);
        const glm::dvec3 point = kEye + fromEye;
        if (point.x < 0 || point.y < 0 || point.x > 1 || point.y > 1) return std::nullopt;
        const double slab = field_.slabTexels();
        return View{{point.x * kSide, point.y * kSide, fromEye.x / -fromEye.z * slab, fromEye.y / -fromEye.z * slab},
                    fromEye};
    }
    Hit exactHit(const ViewRay& ray) {
        RayBlock rays;
        rays.push(ray);
        HitBlock hits;
        NullSink sink;
        exact_->trace(rays, hits, sink, work_);
        return hits[0];
    }
    // Returns whether the surface covers a point of the ray over the map, above the depth `last`. By points, because
    // methods begin at the top of the slab, where a ray that enters through the map's side is outside.
    bool isCovered(const ViewRay& ray, double last) const {
        constexpr int kPoints = 800;
        for (int n = 0; n <= kPoints; ++n) {
            const double lambda = last * n / kPoints, s = ray.s0 + lambda * ray.a, t = ray.t0 + lambda * ray.b;
            const bool inside = s >= 0 && t >= 0 && s <= kSide && t <= kSide;
            if (inside && field_.at(s, t) >= 1 - lambda) return true;
        }
        return false;
    }

    static constexpr int kSide = 64;
    HeightField field_{share(makeRelief("bricks", kSide, kSide, 1)), Surface::Bilinear, Address::Border, 0.15};
    std::unique_ptr<Tracer> exact_ = makeTracer({"exact", {}}, field_, maps_, work_);
    glm::dmat4 view_ = glm::perspective(0.9, double{kWidth} / kHeight, kNear, kFar) *
                       glm::lookAt(kEye, glm::dvec3(0.5, 0.45, 0), glm::dvec3(0, 0, 1));
};

TEST_F(ShaderPicture, ShowsThePlaceSilhouetteAndDepthOfTheHit) {
    const ShaderUniforms uniforms{1, 0, static_cast<float>(kFar / (kFar - kNear)),
                                  static_cast<float>(-kFar * kNear / (kFar - kNear))};
    for (const char* tracer : {"max-pyramid", "cone"}) {
        const Gl::Picture picture = draw(tracer, uniforms, places());
        int hits = 0, misses = 0, wrong = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto view = viewOf(x, y);
                if (!view) continue;
                const auto at = static_cast<std::size_t>(y * kWidth + x);
                const float* const color = &picture.color[4 * at];
                const Hit hit = exactHit(view->ray);
                if (hit.outcome != Outcome::Hit) {
                    ++misses;
                    wrong += color[3] > 0;
                    continue;
                }
                ++hits;
                const double farther = 1 + hit.lambda * field_.reliefDepth() / -view->fromEye.z;
                const glm::dvec4 clip = view_ * glm::dvec4(kEye + view->fromEye * farther, 1);
                constexpr double kPlace = 0.02, kDepth = 1e-5;  // texels (rounding of the camera); of the depth buffer
                const auto off = [&](float found, double place) {
                    const double inside = std::clamp(place, 0.5, kSide - 0.5);  // the colours are clamped at the rim
                    return std::abs(static_cast<double>(found) * kSide - inside) > kPlace;
                };
                wrong += color[3] < 1 || off(color[0], hit.s) || off(color[1], hit.t) ||
                         std::abs(static_cast<double>(picture.depth[at]) - (clip.z / clip.w * 0.5 + 0.5)) > kDepth;
            }
        }
        EXPECT_GT(hits, 4000) << tracer;
        EXPECT_GT(misses, 100) << tracer;
        // Edges, at which the camera's rounding decides.
        EXPECT_LE(wrong, (hits + misses) / 200) << tracer << " of " << hits << " hits and " << misses << " misses";
    }
}

// The level of the colours is that of the polygon's smooth derivatives, at the distance of the hit.
TEST_F(ShaderPicture, ColoursAreSampledByTheDerivativesOfThePolygon) {
    // So deep that hits are up to three times as far as the polygon.
    field_ = HeightField(share(makeRelief("bricks", kSide, kSide, 1)), Surface::Bilinear, Address::Border, 2);
    exact_ = makeTracer({"exact", {}}, field_, maps_, work_);
    constexpr int kColors = 512;
    const Gl::Picture picture = draw("max-pyramid", {1, 0, 1, -0.1F}, levels(kColors));
    int compared = 0, wrong = 0;
    for (int y = 0; y + 1 < kHeight; ++y) {
        for (int x = 0; x + 1 < kWidth; ++x) {
            const auto view = viewOf(x, y), right = viewOf(x + 1, y), above = viewOf(x, y + 1);
            if (!view || !right || !above) continue;
            const Hit hit = exactHit(view->ray);
            if (hit.outcome != Outcome::Hit) continue;
            const auto length = [&](const View& other) {
                return std::hypot(other.ray.s0 - view->ray.s0, other.ray.t0 - view->ray.t0) / kSide * kColors;
            };
            const double farther = 1 + hit.lambda * field_.reliefDepth() / -view->fromEye.z;
            const double level = std::log2(std::max(length(*right), length(*above)) * farther);
            constexpr double kLevels = 0.4;  // llvmpipe rounds levels towards whole ones
            const double found = static_cast<double>(picture.color[4 * static_cast<std::size_t>(y * kWidth + x)]);
            ++compared;
            wrong += std::abs(found - std::max(level, 0.0)) > kLevels;
        }
    }
    EXPECT_GT(compared, 4000);
    EXPECT_LE(wrong, compared / 100);
}

TEST_F(ShaderPicture, ReliefShadowsItself) {
    field_ = HeightField(share(makeRelief("fractal", kSide, kSide, 1)), Surface::Bilinear, Address::Border, 0.3);
    exact_ = makeTracer({"exact", {}}, field_, maps_, work_);
    const Gl::Picture picture = draw("max-pyramid", {0, 1, 1, -0.1F}, places());
    const glm::dvec3 light = glm::normalize(kLight);
    int shadowed = 0, lit = 0, wrong = 0, throughSide = 0, wrongThroughSide = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto view = viewOf(x, y);
            if (!view) continue;
            const Hit hit = exactHit(view->ray);
            const float found = picture.color[4 * static_cast<std::size_t>(y * kWidth + x) + 2];
            if (hit.outcome != Outcome::Hit) continue;
            const double alongS = field_.at(hit.s + 0.5, hit.t) - field_.at(hit.s - 0.5, hit.t);
            const double alongT = field_.at(hit.s, hit.t + 0.5) - field_.at(hit.s, hit.t - 0.5);
            const double slab = field_.slabTexels();
            const double cosine = glm::dot(glm::normalize(glm::dvec3(-alongS * slab, -alongT * slab, 1)), light);
            ViewRay down{0, 0, -light.x / light.z * slab, -light.y / light.z * slab};
            down.s0 = hit.s - hit.lambda * down.a, down.t0 = hit.t - hit.lambda * down.b;
            constexpr double kBias = 0.01;
            if (down.s0 < 0 || down.t0 < 0 || down.s0 > kSide || down.t0 > kSide) {
                const bool dark = cosine < 0 || isCovered(down, hit.lambda - kBias);
                throughSide += dark;
                wrongThroughSide += dark != (found <= 0);
                continue;
            }
            const Hit blocker = exactHit(down);
            const bool dark = cosine < 0 || (blocker.outcome == Outcome::Hit && blocker.lambda < hit.lambda - kBias);
            ++(dark ? shadowed : lit);
            wrong += dark != (found <= 0);
        }
    }
    EXPECT_GT(shadowed, 300);
    EXPECT_GT(lit, 3000);
    EXPECT_LE(wrong, 10) << "of " << shadowed << " dark and " << lit << " lit pixels";
    EXPECT_GT(throughSide, 200);
    EXPECT_LE(wrongThroughSide, 3) << "of " << throughSide << " that are dark, their light entering through the side";
}

}  // namespace
}  // namespace relief::test
