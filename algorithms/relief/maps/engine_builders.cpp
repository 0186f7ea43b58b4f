#include "relief/maps/engine_builders.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/parallel.h"
#include "relief/maps/map_atlas.h"
#include "relief/maps/map_field.h"
#include "relief/maps/surface_cones.h"

namespace relief {

namespace {

// The height as a channel with this role stores it.
float heightCode(float height, EngineRole role, int bits) {
    const double x = static_cast<double>(role == EngineRole::Depth ? 1.0F - height : height);
    return nearestCode(x, bits);
}
// The stored maximum or apex: never lower than the height.
float highCode(float height, EngineRole role, int bits, EngineRounding rounding) {
    if (rounding == EngineRounding::Nearest) return heightCode(height, role, bits);
    if (role == EngineRole::Depth) return lowerCode(static_cast<double>(1.0F - height), bits);
    return higherCode(static_cast<double>(height), bits);
}

EngineRole heightRole(const EngineConventions& conventions) {
    return packs(conventions.channels, EngineRole::Depth) ? EngineRole::Depth : EngineRole::Height;
}

// The field whose heights are those that the picture can hold.
HeightField roundedField(const HeightField& field, const EngineConventions& conventions) {
    if (!conventions.hasHeights()) return field;
    const EngineRole role = heightRole(conventions);
    auto heights = std::make_shared<FloatImage>(field.heights());
    for (float& h : heights->pixels()) {
        const float x = heightCode(h, role, conventions.bits);
        h = role == EngineRole::Depth ? 1.0F - x : x;
    }
    return {heights, field.surface(), field.address(), field.reliefDepth()};
}

// The field of the level above: the maxima of 2 x 2 heights.
HeightField coarser(const HeightField& field, Work& work) {
    const Pyramid pyramid(PyramidKind::Max, field.sharedHeights(), work);
    return {std::make_shared<const FloatImage>(pyramid.level(1)), field.surface(), field.address(),
            field.reliefDepth()};
}

glm::vec3 normalAt(const HeightField& field, int i, int j, bool greenUp) {
    const float slab = static_cast<float>(field.slabTexels());
    const float perS = 0.5F * (field.texel(i + 1, j) - field.texel(i - 1, j));
    const float perT = 0.5F * (field.texel(i, j + 1) - field.texel(i, j - 1));
    return glm::normalize(glm::vec3(-slab * perS, greenUp ? slab * perT : -slab * perT, 1));
}

EngineConventions ofField(EngineConventions conventions, const HeightField& field) {
    conventions.fieldWidth = field.width();
    conventions.fieldHeight = field.height();
    conventions.surface = field.surface();
    conventions.wrap = field.address();
    conventions.reliefDepth = field.reliefDepth();
    return conventions;
}

FloatImage normalChannel(const HeightField& field, EngineRole role, const EngineConventions& c, Work& work) {
    const int axis = static_cast<int>(role) - static_cast<int>(EngineRole::NormalX);
    FloatImage channel(field.width(), field.height());
    parallelFor(work, field.height(), [&](int j) {
        for (int i = 0; i < field.width(); ++i) {
            const glm::vec3 normal = normalAt(field, i, j, c.greenUp);
            channel(i, j) = nearestCode(0.5 + 0.5 * static_cast<double>(normal[axis]), c.bits);
        }
    });
    return channel;
}

FloatImage heightChannel(const HeightField& field, EngineRole role, int bits) {
    FloatImage channel(field.width(), field.height());
    for (std::size_t i = 0; i < channel.size(); ++i) {
        channel.pixels()[i] = heightCode(field.heights().pixels()[i], role, bits);
    }
    return channel;
}

// Apexes and slopes, one for each texel or each cell.
struct Cones {
    FloatImage apex;
    FloatImage slope;
};

FloatImage imageOf(const StoredValues& values) {
    FloatImage image(values.width(), values.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) image(x, y) = values(x, y, 0);
    }
    return image;
}

Cones conesOf(ConeKind kind, ConeParameters parameters, const HeightField& field, const EngineConventions& c, int level,
              Work& work) {
    if (kind == ConeKind::Conservative && !packs(c.channels, EngineRole::Apex)) {
        return {{}, surfaceCones(field, work)};
    }
    parameters.precision = Precision::Float;
    parameters.radius = std::max(1, parameters.radius >> level);
    const ConeMap map = buildConeMap(kind, parameters, field, work);
    return {imageOf(map.apex), imageOf(map.slopes)};
}

EngineLevel levelOf(const HeightField& field, const Cones& cones, const EngineConventions& c, Work& work) {
    EngineLevel level;
    const bool cells = packs(c.channels, EngineRole::Apex);
    const int width = cells ? cones.slope.width() : field.width();
    const int height = cells ? cones.slope.height() : field.height();
    for (const EngineRole role : c.channels) {
        FloatImage channel(width, height);
        switch (role) {
            case EngineRole::Height:
            case EngineRole::Depth:
                channel = heightChannel(field, role, c.bits);
                break;
            case EngineRole::Apex:
                for (std::size_t i = 0; i < channel.size(); ++i) {
                    channel.pixels()[i] = highCode(cones.apex.pixels()[i], role, c.bits, c.rounding);
                }
                break;
            case EngineRole::Cone:
                for (std::size_t i = 0; i < channel.size(); ++i) {
                    channel.pixels()[i] = c.cone.encode(static_cast<double>(cones.slope.pixels()[i]), field.width(),
                                                        field.height(), c.bits, c.rounding);
                }
                break;
            case EngineRole::NormalX:
            case EngineRole::NormalY:
            case EngineRole::NormalZ:
                channel = normalChannel(field, role, c, work);
                break;
            case EngineRole::Zero:
            case EngineRole::Distance:
                break;
        }
        level.channels.push_back(std::move(channel));
    }
    return level;
}

}  // namespace

int mostMipLevels(int width, int height) {
    int levels = 1;
    while ((width > 1 || height > 1) && (width % 2 == 0 || width == 1) && (height % 2 == 0 || height == 1)) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        ++levels;
    }
    return levels;
}

EngineMap buildEngineCones(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                           EngineConventions conventions, int levels, Work& work) {
    EngineMap map;
    map.conventions = ofField(std::move(conventions), field);
    EngineConventions& c = map.conventions;
    std::vector<HeightField> fields;
    std::vector<Cones> cones;
    double steepest = 0;  // heights per unit of length
    for (int l = 0; l < levels; ++l) {
        fields.push_back(l == 0 ? roundedField(field, c) : coarser(fields.back(), work));
        const HeightField& at = fields.back();
        cones.push_back(conesOf(kind, parameters, at, c, l, work));
        for (const float slope : cones.back().slope.pixels()) {
            steepest = std::max(steepest, static_cast<double>(slope) * c.cone.texels(at.width(), at.height()));
        }
    }
    // Codes must reach the steepest slope.
    if (c.cone.unit == ConeUnit::Slope && c.bits != 32) {
        c.cone.scale = std::max(1e-6, steepest * (1 + 4 * kEngineMargin));
    }
    for (std::size_t l = 0; l < fields.size(); ++l) map.levels.push_back(levelOf(fields[l], cones[l], c, work));
    return map;
}

EngineMap buildEngineNormals(const HeightField& field, EngineConventions conventions, int levels, Work& work) {
    EngineMap map;
    map.conventions = ofField(std::move(conventions), field);
    map.conventions.rounding = EngineRounding::Nearest;
    HeightField at = roundedField(field, map.conventions);
    for (int l = 0; l < levels; ++l) {
        if (l > 0) at = coarser(at, work);
        map.levels.push_back(levelOf(at, {}, map.conventions, work));
    }
    return map;
}

EngineMap buildEnginePyramid(PyramidKind kind, const HeightField& field, EngineConventions conventions, Work& work) {
    EngineMap map;
    map.conventions = ofField(std::move(conventions), field);
    const EngineConventions& c = map.conventions;
    const EngineRounding rounding = kind == PyramidKind::Max ? c.rounding : EngineRounding::Nearest;
    map.conventions.rounding = rounding;
    const Pyramid pyramid(kind, field.sharedHeights(), work);
    for (int l = 0; l < pyramid.levels(); ++l) {
        const FloatImage& values = pyramid.level(l);
        EngineLevel level;
        for (const EngineRole role : c.channels) {
            FloatImage channel(values.width(), values.height());
            for (std::size_t i = 0; i < channel.size() && role != EngineRole::Zero; ++i) {
                channel.pixels()[i] = highCode(values.pixels()[i], role, c.bits, rounding);
            }
            level.channels.push_back(std::move(channel));
        }
        map.levels.push_back(std::move(level));
    }
    return map;
}

EngineMap buildEngineDistances(const DistanceMap& distances, const HeightField& field, EngineConventions conventions,
                               Work& work) {
    EngineMap map;
    map.conventions = ofField(std::move(conventions), field);
    EngineConventions& c = map.conventions;
    const StoredValues& values = distances.values;
    const Atlas atlas(values.width(), values.height(), values.layers());
    float longest = 0;
    for (int k = 0; k < values.layers(); ++k) {
        for (int y = 0; y < values.height(); ++y) {
            for (int x = 0; x < values.width(); ++x) longest = std::max(longest, values(x, y, k));
        }
    }
    const double widths = static_cast<double>(longest) / field.width();
    c.volume = EngineVolume{distances.kind,   distances.parameters, distances.slabTexels,
                            distances.maxRun, distances.cap,        c.bits == 32 || !(widths > 0) ? 1.0 : widths,
                            values.width(),   values.height(),      atlas.columns};
    FloatImage picture(atlas.width(), atlas.height());
    const double unit = c.volume->scale * field.width();
    parallelFor(work, values.layers(), [&](int k) {
        for (int y = 0; y < values.height(); ++y) {
            for (int x = 0; x < values.width(); ++x) {
                // Marks are negative: what a shader must search itself has distance 0.
                const double exact = std::max(0.0, static_cast<double>(values(x, y, k)));
                const float code = c.rounding == EngineRounding::Nearest
                                       ? nearestCode(exact / unit, c.bits)
                                       : lowerCode(exact / unit * (1 - kEngineMargin), c.bits);
                picture.pixels()[atlas.at(k, y) + static_cast<std::size_t>(x)] = code;
            }
        }
    });
    EngineLevel level;
    for (const EngineRole role : c.channels) {
        level.channels.push_back(role == EngineRole::Distance ? picture
                                                              : FloatImage(picture.width(), picture.height()));
    }
    map.levels.push_back(std::move(level));
    return map;
}

std::optional<DistanceMap> distancesOfEngine(const EngineMap& map, const HeightField& field, const std::string& path) {
    const FloatImage* picture = map.channel(EngineRole::Distance);
    if (picture == nullptr || !map.conventions.volume) return std::nullopt;
    const EngineVolume& volume = *map.conventions.volume;
    const DistanceShape shape = distanceMapShape(volume.kind, volume.parameters, field);
    Atlas atlas(shape.nx, shape.ny, shape.planes);
    atlas.columns = volume.columns;
    requireSize(path, *picture, atlas.width(), atlas.height());
    DistanceMap distances;
    distances.kind = volume.kind;
    distances.parameters = volume.parameters;
    distances.parameters.precision = Precision::Float;
    setField(distances, field);
    distances.slabTexels = field.slabTexels();
    distances.maxRun = volume.maxRun;
    distances.cap = volume.cap;
    UnfilledVector<float> values;
    values.reserve(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                   static_cast<std::size_t>(shape.planes));
    const double unit = volume.scale * field.width();
    for (int k = 0; k < shape.planes; ++k) {
        for (int y = 0; y < shape.ny; ++y) {
            for (int x = 0; x < shape.nx; ++x) {
                const float code = picture->pixels()[atlas.at(k, y) + static_cast<std::size_t>(x)];
                const bool mark = ofBoxes(volume.kind) && code == 0;
                values.push_back(mark ? StoredValues::kSurface : static_cast<float>(static_cast<double>(code) * unit));
            }
        }
    }
    distances.values =
        StoredValues(shape.nx, shape.ny, shape.planes, std::move(values), Precision::Float, Rounding::Down);
    return distances;
}

std::optional<ConeMap> cellConesOfEngine(const EngineMap& map, const HeightField& field, const std::string& path) {
    const FloatImage* apexes = map.channel(EngineRole::Apex);
    const FloatImage* codes = map.channel(EngineRole::Cone);
    if (apexes == nullptr || codes == nullptr) return std::nullopt;
    ConeMap cones;
    const ConeShape shape = coneMapShape(ConeKind::Conservative, cones.parameters, field);
    requireSize(path, *codes, shape.nx, shape.ny);
    setField(cones, field);
    UnfilledVector<float> slopes(codes->size());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double slope =
            map.conventions.cone.slope(static_cast<double>(codes->pixels()[i]), field.width(), field.height());
        // Stored values are finite; no ray advances by such a cone.
        constexpr double kNarrowest = 1e30;
        slopes[i] = static_cast<float>(std::min(slope, kNarrowest));
    }
    cones.apex = StoredValues(shape.nx, shape.ny, 1, {apexes->pixels().begin(), apexes->pixels().end()},
                              Precision::Float, Rounding::Up);
    cones.slopes = StoredValues(shape.nx, shape.ny, 1, std::move(slopes), Precision::Float, Rounding::Up);
    return cones;
}

}  // namespace relief
