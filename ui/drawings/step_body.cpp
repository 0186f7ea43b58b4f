#include "drawings/step_body.h"

#include <cmath>
#include <numbers>

#include "drawings/ray_geometry.h"
#include "drawings/slice.h"
#include "relief/cell_grid.h"
#include "relief/maps/distance_map.h"
#include "relief/maps/map_choice.h"
#include "relief/tracers.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Phase;

bool contains(const std::vector<std::string>& all, const std::string& wanted) {
    return std::find(all.begin(), all.end(), wanted) != all.end();
}

int optionOf(const relief::MethodDescription& method, const relief::OptionValues& given, const char* name) {
    const auto standard = method.defaults.find(name);
    if (standard == method.defaults.end()) return 1;
    const auto chosen = given.find(name);
    return static_cast<int>(
        relief::parseNumber(chosen == given.end() ? standard->second : chosen->second, std::string(name)));
}

// The highest of the 3 x 3 cells around: where a conservative cone stands.
double apexOf(const relief::HeightField& field, const relief::FloatImage& cells, const relief::Step& step) {
    const relief::CellGrid grid(field);
    float highest = 0;
    for (int v = -1; v <= 1; ++v) {
        for (int u = -1; u <= 1; ++u) {
            const std::int64_t i = step.i - grid.x.firstName + u;
            const std::int64_t j = step.j - grid.y.firstName + v;
            const bool inside = i >= 0 && j >= 0 && i < cells.width() && j < cells.height();
            if (!inside && !grid.x.wraps) continue;
            highest = std::max(highest, cells(relief::addressIndex(i, cells.width(), relief::Address::Repeat),
                                              relief::addressIndex(j, cells.height(), relief::Address::Repeat)));
        }
    }
    return static_cast<double>(highest);
}

}  // namespace

MapWalk walkedMap(const relief::MethodChoice& choice) {
    MapWalk walk;
    const auto known = std::find_if(relief::tracerList().begin(), relief::tracerList().end(),
                                    [&](const relief::MethodDescription& m) { return m.name == choice.name; });
    if (known == relief::tracerList().end()) return walk;
    for (const std::string& kind : relief::mapKinds()) {
        if (!contains(known->maps, kind)) continue;
        walk.kind = kind;
        walk.cones = kind == "cone" || kind == "cone-dummer" || kind == "relaxed-cone";
        walk.interpolated = kind != "cone" && kind != "euclidean-conservative" && kind != "refined";
        walk.footprint = optionOf(*known, choice.options, "footprint");
        walk.layers = optionOf(*known, choice.options, "layers");
        walk.sectors = optionOf(*known, choice.options, "sectors");
        walk.options = choice.options;
        walk.options.insert(known->defaults.begin(), known->defaults.end());
        return walk;
    }
    for (const relief::OptionDescription& option : known->options) {
        if (option.kind != relief::OptionKind::Method) continue;
        const auto given = choice.options.find(option.name);
        relief::MethodChoice inner{given == choice.options.end() ? known->defaults.at(option.name) : given->second, {}};
        for (const auto& [name, text] : choice.options) {
            if (name.starts_with(relief::kInnerPrefix)) {
                inner.options[name.substr(relief::kInnerPrefix.size())] = text;
            }
        }
        return walkedMap(inner);
    }
    return walk;
}

bool StepBody::whole() const {
    return to - from > 2 * std::numbers::pi - 1e-9;
}

bool StepBody::holds(double x, double y) const {
    if (whole()) return true;
    constexpr double kTurn = 2 * std::numbers::pi;
    double azimuth = std::atan2(y, x);
    if (azimuth < 0) azimuth += kTurn;
    return azimuth >= from && azimuth <= to;
}

StepBody stepBody(const MapWalk& walk, const relief::HeightField& field, const relief::MaxPyramidMap& maxima,
                  const relief::ViewRay& ray, const relief::Step& step) {
    StepBody body;
    const bool ofWalk = (step.primitive == relief::Primitive::Point) == walk.interpolated;
    if (!walk || !ofWalk || step.phase != Phase::Search || step.decision != Decision::Advance) return body;
    // A walk from voxel to voxel goes on from where it leaves the voxel; a march from where it is.
    body.lambda = walk.interpolated ? step.lambdaIn : step.lambdaOut;
    if (!walk.cones) {
        body.kind = StepBody::Kind::Sphere;
        body.radius = step.value;
        return body;
    }
    body.kind = StepBody::Kind::Cone;
    body.slope = step.value;
    body.apex = walk.interpolated ? surfaceAt(field, ray, body.lambda) : apexOf(field, maxima.pyramid.level(0), step);
    const int sector = relief::azimuthSector(ray.a, ray.b, walk.sectors);
    body.from = 2 * std::numbers::pi * sector / walk.sectors;
    body.to = 2 * std::numbers::pi * (sector + 1) / walk.sectors;
    return body;
}

bool valueIsHeight(const MapWalk& walk, const relief::Step& step) {
    if (!walk || step.level > 0) return true;
    if (step.decision == Decision::Start || step.decision == Decision::Miss) return true;
    if (step.decision == Decision::Refine) return true;
    return walk.cones && step.decision != Decision::Advance;
}

bool namesVoxel(const MapWalk& walk, const relief::Step& step) {
    const bool voxel = step.decision == Decision::Advance && step.phase == Phase::Search;
    return walk && !walk.cones && !walk.interpolated && step.primitive == relief::Primitive::Texel && voxel;
}

bool liesInVoxel(const MapWalk& walk, const relief::Step& step) {
    const bool cell = step.decision == Decision::Test || step.decision == Decision::Hit ||
                      step.decision == Decision::Refine || step.level > 0;
    return walk && !walk.cones && !walk.interpolated && step.primitive == relief::Primitive::Texel && !cell;
}

Box placeOf(const MapWalk& walk, const relief::HeightField& field, const relief::Step& step, int baseLevel) {
    return liesInVoxel(walk, step) ? voxelBox(walk, field, step).sides : stepBox(field, step, baseLevel);
}

VoxelBox voxelBox(const MapWalk& walk, const relief::HeightField& field, const relief::Step& step) {
    const relief::CellGrid grid(field);
    const auto side = [&](const relief::GridAxis& axis, std::int64_t index, std::int64_t period, double& low,
                          double& high) {
        const auto first = static_cast<int>(index) * walk.footprint;
        const int last = std::min(first + walk.footprint, axis.cells);
        low = axis.edge(first, period * axis.cells) - axis.shift;
        high = axis.edge(last, period * axis.cells) - axis.shift;
    };
    VoxelBox box;
    side(grid.x, step.i, step.periodX, box.sides.x0, box.sides.x1);
    side(grid.y, step.j, step.periodY, box.sides.y0, box.sides.y1);
    box.low = static_cast<double>(step.k) / walk.layers;
    box.high = static_cast<double>(step.k + 1) / walk.layers;
    return box;
}

}  // namespace reliefui
