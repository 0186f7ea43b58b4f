#include "relief/maps/cone_map.h"

#include <array>

#include "relief/maps/cone_builders.h"
#include "relief/maps/map_field.h"
#include "relief/maps/map_memory.h"
#include "relief/maps/robust_cones.h"
#include "relief/maps/surface_cones.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, kConeKinds> kKindNames{"cone", "cone-dummer", "cone-robust", "relaxed-cone",
                                                              "relaxed-cone-robust"};

std::size_t valuesOf(const ConeShape& shape) {
    return static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny);
}

}  // namespace

std::string_view coneKindName(ConeKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

ConeShape coneMapShape(ConeKind kind, const ConeParameters& parameters, const HeightField& field) {
    if (kind != ConeKind::Conservative) return {field.width(), field.height(), 1};
    const CellGrid grid(field);
    return {grid.x.cells, grid.y.cells, parameters.sectors};
}

std::size_t coneMapBytes(ConeKind kind, const ConeParameters& parameters, const HeightField& field) {
    const ConeShape shape = coneMapShape(kind, parameters, field);
    return valuesOf(shape) * static_cast<std::size_t>(shape.sectors + 1) * bytesEach(parameters.precision);
}

namespace {

// Estimated memory for building. All values are floats until the last is known; conservative cones need planes over the
// cells in addition, relaxed ones a strip of heights per thread.
std::uint64_t coneBuildBytes(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                             std::size_t threads) {
    const ConeShape shape = coneMapShape(kind, parameters, field);
    const std::size_t codes = parameters.precision == Precision::Float ? 0 : bytesEach(parameters.precision);
    constexpr std::uint64_t kPlanes = 28, kStrips = 4;  // bytes per texel
    const bool ofCells = kind == ConeKind::Conservative || kind == ConeKind::Robust;
    return byteSum(
        {byteProduct({valuesOf(shape), static_cast<std::uint64_t>(shape.sectors) + 1, sizeof(float) + codes}),
         bytesForTexels(field, ofCells ? kPlanes : kStrips),
         kind == ConeKind::Relaxed ? relaxedStripBytes(field, parameters.radius, threads) : 0});
}

}  // namespace

ConeMap buildConeMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field, Work& work) {
    const ConeShape shape = coneMapShape(kind, parameters, field);
    ConeMap map;
    map.kind = kind;
    map.parameters = parameters;
    setField(map, field);
    UnfilledVector<float> slopes(valuesOf(shape) * static_cast<std::size_t>(shape.sectors), 0.0F);
    UnfilledVector<float> apex;
    switch (kind) {
        case ConeKind::Conservative:
            conservativeCones(field, parameters.sectors, kConeSlack, apex, slopes, work);
            break;
        case ConeKind::Dummer:
            dummerCones(field, slopes, work);
            break;
        case ConeKind::Robust:
        case ConeKind::RelaxedRobust: {
            const FloatImage cones = kind == ConeKind::Robust ? surfaceCones(field, work)
                                                              : robustRelaxedCones(field, parameters.radius, work);
            slopes.assign(cones.pixels().begin(), cones.pixels().end());
            break;
        }
        case ConeKind::Relaxed:
            relaxedCones(field, parameters.directions, parameters.radius, slopes, work);
            break;
    }
    if (apex.empty()) apex.assign(field.heights().pixels().begin(), field.heights().pixels().end());
    map.apex = StoredValues(shape.nx, shape.ny, 1, std::move(apex), parameters.precision, Rounding::Up);
    map.slopes = StoredValues(shape.nx, shape.ny, shape.sectors, std::move(slopes), parameters.precision, Rounding::Up);
    return map;
}

MapKey coneMapKey(ConeKind kind, const ConeParameters& parameters, const HeightField& field) {
    std::string key(coneKindName(kind));
    for (const std::string_view name : {surfaceName(field.surface()), addressName(field.address())}) {
        key.append("/").append(name);
    }
    for (const int number : {parameters.sectors, parameters.radius, parameters.directions}) {
        key.append("/").append(std::to_string(number));
    }
    key.append("/").append(precisionName(parameters.precision));
    return {key, field.sharedHeights()};
}

std::shared_ptr<const ConeMap> coneMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                                       MapCache& cache, Work& work) {
    const bool robust = kind == ConeKind::Robust || kind == ConeKind::RelaxedRobust;
    if (robust && field.surface() != Surface::Bilinear) {
        throw InputError("--surface", Message(MessageId::ConesBilinear, {{"kind", std::string(coneKindName(kind))}}));
    }
    checkMapMemory(std::string(coneKindName(kind)), coneMapBytes(kind, parameters, field), cache);
    return cache.get<ConeMap>(coneMapKey(kind, parameters, field),
                              coneBuildBytes(kind, parameters, field, work.threads().size()), work,
                              [&](Work& w) { return buildConeMap(kind, parameters, field, w); });
}

}  // namespace relief
