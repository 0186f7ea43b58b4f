#include "shaders/shader_maps.h"

#include <bit>
#include <cmath>

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
    if (choice.coneUnit == ShaderConeUnit::TexelSlope) return slope;
    const double ratio = 1.0 / (std::max(static_cast<double>(slope), 1e-6) * width);
    switch (choice.coneUnit) {
        case ShaderConeUnit::Ratio:
            return static_cast<float>(ratio / choice.coneScale);
        case ShaderConeUnit::SqrtRatio:
            return static_cast<float>(std::sqrt(ratio / choice.coneScale));
        default:
            return static_cast<float>(1 / (ratio * choice.coneScale));
    }
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

// The levels of maxima in a texture whose sides are multiples of its smallest level's texels.
TextureData pyramidTexture(const Pyramid& pyramid) {
    const int step = 1 << (pyramid.levels() - 1);
    const FloatImage& base = pyramid.level(0);
    TextureData data{
        (base.width() + step - 1) / step * step, (base.height() + step - 1) / step * step, 1, 1, {}, false};
    for (int l = 0; l < pyramid.levels(); ++l) {
        const FloatImage& level = pyramid.level(l);
        const int width = data.width >> l, height = data.height >> l;
        // What must not be read is a wall that would stop every ray.
        std::vector<float>& texels =
            data.levels.emplace_back(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 9.0F);
        for (int y = 0; y < level.height(); ++y) {
            for (int x = 0; x < level.width(); ++x) {
                texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                    level(x, y);
            }
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

void bindMaps(Gl& gl, const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms,
              Work& work) {
    const std::string& tracer = choice.method.name;
    float more = 1 / static_cast<float>(field.width());  // distances in texels
    TextureData relief = textureOf(field.heights());
    if (tracer == "cone-dummer" || tracer == "relaxed-cone") {
        const ConeKind kind = tracer == "relaxed-cone" ? ConeKind::Relaxed : ConeKind::Dummer;
        relief = conesTexture(choice, field.heights(), buildConeMap(kind, {}, field, work), false);
    } else if (tracer == "cone") {
        gl.setTexture(
            3, conesTexture(choice, field.heights(), buildConeMap(ConeKind::Conservative, {}, field, work), true),
            choice.address);
    } else if (tracer == "distance") {
        gl.setTexture(3, distanceTexture(buildDistanceMap(DistanceKind::Euclidean, {}, field, work)), choice.address);
    } else if (tracer == "max-pyramid") {
        const Pyramid pyramid(PyramidKind::Max, field.heights(), work);
        gl.setTexture(3, pyramidTexture(pyramid), choice.address);
        const std::int32_t levels = pyramid.levels();
        more = std::bit_cast<float>(levels);
    }
    gl.setTexture(1, relief, choice.address);
    // std140: vec2 size, depth, ambient; intensity, a gap, vec2 depthOfDistance; the tracer's own.
    gl.setUniforms({static_cast<float>(field.width()), static_cast<float>(field.height()),
                    static_cast<float>(field.reliefDepth()), uniforms.ambient, uniforms.intensity, 0,
                    uniforms.depthConstant, uniforms.depthPerDistance, more, 0, 0, 0});
}

}  // namespace relief::test
