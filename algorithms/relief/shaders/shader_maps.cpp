#include "relief/shaders/shader_maps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <regex>
#include <type_traits>

#include "images/pyramid.h"
#include "relief/memory.h"
#include "relief/methods/cone.h"
#include "relief/methods/cone_dummer.h"
#include "relief/methods/cone_robust.h"
#include "relief/methods/distance.h"
#include "relief/methods/distance_options.h"
#include "relief/methods/relaxed_cone.h"
#include "relief/methods/relaxed_cone_robust.h"

namespace relief {

namespace {

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
ShaderTexture conesTexture(const ShaderChoice& choice, const FloatImage& heights, const ConeMap& cones, bool ofCells) {
    ShaderTexture data{cones.nx(), cones.ny(), 1, 2, {{}}, !ofCells};
    for (int y = 0; y < cones.ny(); ++y) {
        for (int x = 0; x < cones.nx(); ++x) {
            data.levels[0].push_back(ofCells ? cones.apex(x, y, 0) : heights(x, y));
            data.levels[0].push_back(coneNumber(cones.slopes(x, y, 0), choice, heights.width()));
        }
    }
    return data;
}

ShaderTexture distanceTexture(const DistanceMap& map) {
    ShaderTexture data{map.nx(), map.ny(), map.layers(), 1, {{}}, true};
    for (int k = 0; k < map.layers(); ++k) {
        for (int y = 0; y < map.ny(); ++y) {
            for (int x = 0; x < map.nx(); ++x) data.levels[0].push_back(map.at(x, y, k, 0));
        }
    }
    return data;
}

// The options of the method, of which the map depends on some.
template <class Tracer>
typename Tracer::Options optionsOf(const ShaderChoice& choice) {
    return parseOptions<typename Tracer::Options>(choice.method.name, choice.method.options);
}

}  // namespace

ShaderTexture shaderTexture(const FloatImage& image) {
    return {image.width(), image.height(), 1, 1, {{image.pixels().begin(), image.pixels().end()}}, true};
}

// The sides are multiples of the smallest level's texels.
ShaderTexture levelsTexture(const std::vector<FloatImage>& levels) {
    const int step = 1 << (levels.size() - 1);
    const int width = levels[0].width(), height = levels[0].height();
    ShaderTexture data{(width + step - 1) / step * step, (height + step - 1) / step * step, 1, 1, {}, false};
    constexpr std::uint64_t kWithLevels = 2 * sizeof(float);  // more than 4/3 floats per texel
    requireMemory(
        byteProduct({static_cast<std::uint64_t>(data.width), static_cast<std::uint64_t>(data.height), kWithLevels}),
        "max-pyramid");
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const FloatImage& level = levels[l];
        const auto row = static_cast<std::size_t>(data.width >> l);
        // What must not be read is a wall that would stop every ray.
        std::vector<float>& texels = data.levels.emplace_back(row * static_cast<std::size_t>(data.height >> l), 9.0F);
        for (int y = 0; y < level.height(); ++y) {
            std::ranges::copy(level.row(y),
                              texels.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row));
        }
    }
    return data;
}

ShaderInputs shaderInputs(const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms,
                          MapCache& cache, Work& work) {
    const std::string& tracer = choice.method.name;
    ShaderInputs inputs;
    float more = 1 / static_cast<float>(field.width());  // distances in texels
    inputs.textures[1] = shaderTexture(field.heights());
    const auto cones = [&]<class Tracer>(std::type_identity<Tracer>) {
        const auto marched = Tracer::make(field, optionsOf<Tracer>(choice), cache, work);
        inputs.textures[1] = conesTexture(choice, field.heights(), *marched.coneMap(), false);
    };
    if (tracer == "cone-dummer") {
        cones(std::type_identity<ConeDummerTracer>());
    } else if (tracer == "cone-robust") {
        cones(std::type_identity<ConeRobustTracer>());
    } else if (tracer == "relaxed-cone") {
        cones(std::type_identity<RelaxedConeTracer>());
    } else if (tracer == "relaxed-cone-robust") {
        cones(std::type_identity<RelaxedConeRobustTracer>());
    } else if (tracer == "cone") {
        const auto map = ConeTracer::makeMap(field, optionsOf<ConeTracer>(choice), cache, work);
        inputs.textures[3] = conesTexture(choice, field.heights(), *map, true);
    } else if (tracer == "distance") {
        const auto options = optionsOf<DistanceTracer>(choice);
        inputs.textures[3] = distanceTexture(*distanceMapOf(DistanceKind::Euclidean, options, field, cache, work));
    } else if (tracer == "max-pyramid") {
        const Pyramid pyramid(PyramidKind::Max, field.heights(), work);
        std::vector<FloatImage> levels;
        for (int l = 0; l < pyramid.levels(); ++l) levels.push_back(pyramid.level(l));
        inputs.textures[3] = levelsTexture(levels);
        const std::int32_t count = pyramid.levels();
        more = std::bit_cast<float>(count);
    }
    // std140: vec2 size, depth, ambient; intensity, a gap, vec2 depthOfDistance; the tracer's own.
    inputs.uniforms = {static_cast<float>(field.width()),
                       static_cast<float>(field.height()),
                       static_cast<float>(field.reliefDepth()),
                       uniforms.ambient,
                       uniforms.intensity,
                       0,
                       uniforms.depthConstant,
                       uniforms.depthPerDistance,
                       more,
                       0,
                       0,
                       0};
    return inputs;
}

ShaderRays shaderRays(const RayBlock& rays) {
    ShaderRays all;
    all.numbers.reserve(4 * rays.size());
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

std::string rayPassText(const std::string& shader) {
    const std::string kPass = R"(
layout(local_size_x = GROUP) in;
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
    std::regex_search(shader, name, std::regex("Hit (trace\\w+)\\(Ray"));
    const std::string pass = std::regex_replace(kPass, std::regex("TRACE"), name[1].str());
    return shader.substr(0, shader.find(kShaderPixelPart)) +
           std::regex_replace(pass, std::regex("GROUP"), std::to_string(kRaysPerGroup));
}

}  // namespace relief
