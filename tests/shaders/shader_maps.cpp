#include "shaders/shader_maps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <regex>

#include "images/pyramid.h"
#include "relief/maps/cone_map.h"
#include "relief/maps/distance_map.h"

namespace relief::test {

namespace {

TextureData textureOf(const FloatImage& image) {
    return {image.width(), image.height(), 1, 1, {{image.pixels().begin(), image.pixels().end()}}, true};
}

// The number that stands for a slope of heights per texel.
float coneNumber(float slope, const ShaderChoice& choice, int width) {
    if (choice.texelSlopes) return slope;
    const double ratio = 1.0 / (std::max(static_cast<double>(slope), 1e-6) * width);
    switch (choice.cones.unit) {
        case ConeUnit::Ratio:
            return static_cast<float>(ratio / choice.cones.scale);
        case ConeUnit::SqrtRatio:
            return static_cast<float>(std::sqrt(ratio / choice.cones.scale));
        case ConeUnit::Slope:
            break;
    }
    return static_cast<float>(1 / (ratio * choice.cones.scale));
}

// Heights, or apexes of cells, in red and cones in green.
TextureData conesTexture(const ShaderChoice& choice, const FloatImage& heights, const ConeMap& cones, bool ofCells) {
    TextureData data{cones.nx(), cones.ny(), 1, 2, {{}}, !ofCells};
    for (int y = 0; y < cones.ny(); ++y) {
        for (int x = 0; x < cones.nx(); ++x) {
            data.levels[0].push_back(ofCells ? cones.apex(x, y, 0) : heights(x, y));
            data.levels[0].push_back(coneNumber(cones.slopes(x, y, 0), choice, heights.width()));
        }
    }
    return data;
}

TextureData distanceTexture(const DistanceMap& map) {
    TextureData data{map.nx(), map.ny(), map.layers(), 1, {{}}, true};
    for (int k = 0; k < map.layers(); ++k) {
        for (int y = 0; y < map.ny(); ++y) {
            for (int x = 0; x < map.nx(); ++x) data.levels[0].push_back(map.at(x, y, k, 0));
        }
    }
    return data;
}

}  // namespace

// The levels in a texture whose sides are multiples of the smallest level's texels.
TextureData levelsTexture(const std::vector<FloatImage>& levels) {
    const int step = 1 << (levels.size() - 1);
    const int width = levels[0].width(), height = levels[0].height();
    TextureData data{(width + step - 1) / step * step, (height + step - 1) / step * step, 1, 1, {}, false};
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const FloatImage& level = levels[l];
        const auto row = static_cast<std::size_t>(data.width >> l);
        // What must not be read is a wall that would stop every ray.
        std::vector<float>& texels = data.levels.emplace_back(row * static_cast<std::size_t>(data.height >> l), 9.0F);
        for (int y = 0; y < level.height(); ++y) {
            for (int x = 0; x < level.width(); ++x) {
                texels[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x)] = level(x, y);
            }
        }
    }
    return data;
}

ShaderRays shaderRays(const RayBlock& rays) {
    ShaderRays all;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ViewRay ray = rays[i];
        for (double* const number : {&ray.s0, &ray.t0, &ray.a, &ray.b}) {
            all.numbers.push_back(static_cast<float>(*number));
            *number = static_cast<double>(all.numbers.back());
        }
        all.rounded.push(ray);
    }
    return all;
}

double texelsOf(const ViewRay& ray) {
    return std::max(1.0, std::hypot(ray.a, ray.b));
}

std::string computeText(const std::string& shader) {
    const std::string kCompute = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) writeonly buffer Hits { vec4 hits[]; };
void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= rays.length()) return;
    Hit hit = TRACE(Ray(rays[n].xy, rays[n].zw, 0.0));
    hits[n] = vec4(hit.found ? 1.0 : 0.0, hit.lambda, float(hit.steps), 0.0);
}
)";
    std::smatch name;
    EXPECT_TRUE(std::regex_search(shader, name, std::regex("Hit (trace\\w+)\\(Ray")));
    const std::size_t pixel = shader.find(kShaderPixelPart);
    EXPECT_NE(pixel, std::string::npos);
    return shader.substr(0, pixel) + std::regex_replace(kCompute, std::regex("TRACE"), name[1].str());
}

void bindMaps(Gl& gl, const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms,
              Work& work) {
    const std::string& tracer = choice.method.name;
    float more = 1 / static_cast<float>(field.width());  // distances in texels
    TextureData relief = textureOf(field.heights());
    if (readsCones(tracer) && tracer != "cone") {
        // Maps have the names of their tracers.
        int kind = 0;
        while (coneKindName(static_cast<ConeKind>(kind)) != tracer) ++kind;
        relief =
            conesTexture(choice, field.heights(), buildConeMap(static_cast<ConeKind>(kind), {}, field, work), false);
    } else if (tracer == "cone") {
        gl.setTexture(
            3, conesTexture(choice, field.heights(), buildConeMap(ConeKind::Conservative, {}, field, work), true),
            choice.address);
    } else if (tracer == "distance") {
        gl.setTexture(3, distanceTexture(buildDistanceMap(DistanceKind::Euclidean, {}, field, work)), choice.address);
    } else if (tracer == "max-pyramid") {
        const Pyramid pyramid(PyramidKind::Max, field.heights(), work);
        std::vector<FloatImage> levels;
        for (int l = 0; l < pyramid.levels(); ++l) levels.push_back(pyramid.level(l));
        gl.setTexture(3, levelsTexture(levels), choice.address);
        const std::int32_t count = pyramid.levels();
        more = std::bit_cast<float>(count);
    }
    gl.setTexture(1, relief, choice.address);
    // std140: vec2 size, depth, ambient; intensity, a gap, vec2 depthOfDistance; the tracer's own.
    gl.setUniforms({static_cast<float>(field.width()), static_cast<float>(field.height()),
                    static_cast<float>(field.reliefDepth()), uniforms.ambient, uniforms.intensity, 0,
                    uniforms.depthConstant, uniforms.depthPerDistance, more, 0, 0, 0});
}

}  // namespace relief::test
