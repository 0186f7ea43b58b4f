#include "panes/distance/distance_slice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "relief/cell_grid.h"

namespace reliefui {

namespace {

using relief::StoredValues;

std::size_t index(SliceAxis axis) {
    return static_cast<std::size_t>(axis);
}

// Axis of voxels that each span `footprint` cells of the grid.
VoxelAxis overCells(const relief::GridAxis& grid, int count, int footprint) {
    VoxelAxis axis;
    axis.count = count;
    axis.start = -grid.shift;
    axis.side = footprint;
    axis.period = grid.cells;
    axis.wraps = grid.wraps;
    return axis;
}

VoxelAxis overTexels(int texels, int count, bool wraps) {
    VoxelAxis axis;
    axis.count = count;
    axis.side = static_cast<double>(texels) / count;
    axis.period = texels;
    axis.wraps = wraps;
    return axis;
}

}  // namespace

int VoxelAxis::index(double place) const {
    double along = place - start;
    if (wraps) along -= std::floor(along / period) * period;
    return static_cast<int>(std::clamp(std::floor(along / side), 0.0, count - 1.0));
}

double VoxelAxis::center(int i) const {
    return start + (i * side + std::min((i + 1) * side, period)) / 2;
}

SlicedMap::SlicedMap(relief::StoredMap map, const relief::HeightField& field)
    : kind_(relief::mapKindName(map)), map_(std::move(map)), slab_(field.slabTexels()) {
    const relief::CellGrid grid(field);
    const bool wraps = field.address() == relief::Address::Repeat;
    if (const auto* distances = std::get_if<std::shared_ptr<const relief::DistanceMap>>(&map_)) {
        distances_ = distances->get();
        const int footprint = distances_->parameters.footprint;
        const bool boxes = relief::ofBoxes(distances_->kind);
        x_ =
            boxes ? overCells(grid.x, distances_->nx(), footprint) : overTexels(field.width(), distances_->nx(), wraps);
        y_ = boxes ? overCells(grid.y, distances_->ny(), footprint)
                   : overTexels(field.height(), distances_->ny(), wraps);
    } else {
        cones_ = std::get<std::shared_ptr<const relief::ConeMap>>(map_).get();
        const bool cells = cones_->kind == relief::ConeKind::Conservative;
        x_ = cells ? overCells(grid.x, cones_->nx(), 1) : overTexels(field.width(), cones_->nx(), wraps);
        y_ = cells ? overCells(grid.y, cones_->ny(), 1) : overTexels(field.height(), cones_->ny(), wraps);
    }
    largest_.resize(static_cast<std::size_t>(sectors()));
}

int SlicedMap::sectors() const {
    if (cones_ != nullptr) return cones_->slopes.layers();
    return distances_->kind == relief::DistanceKind::Refined ? distances_->parameters.sectors : 1;
}

int SlicedMap::layerOf(double h) const {
    // A descending ray at a layer's lower side belongs to the layer below.
    const double k = slab_ > 0 ? std::ceil(h / slab_ * layers()) - 1 : 0;
    return static_cast<int>(std::clamp(k, 0.0, layers() - 1.0));
}

int SlicedMap::slices(SliceAxis axis) const {
    if (axis == SliceAxis::X) return x_.count;
    return axis == SliceAxis::Y ? y_.count : layers();
}

int SlicedMap::sliceAt(SliceAxis axis, const Place3& place) const {
    if (axis == SliceAxis::X) return x_.index(place[0]);
    return axis == SliceAxis::Y ? y_.index(place[1]) : layerOf(place[2]);
}

double SlicedMap::planeOf(SliceAxis axis, int slice, const Place3& near) const {
    if (axis == SliceAxis::Z) return (slice + 0.5) / layers() * slab_;
    const VoxelAxis& along = axis == SliceAxis::X ? x_ : y_;
    const double center = along.center(slice);
    if (!along.wraps) return center;
    return center + std::round((near[index(axis)] - center) / along.period) * along.period;
}

float SlicedMap::value(int bx, int by, int layer, int sector) const {
    if (cones_ != nullptr) return cones_->slopes(bx, by, sector);
    const float distance = distances_->at(bx, by, layer, sector);
    return distance == 0 && !relief::ofBoxes(distances_->kind) ? StoredValues::kBuried : distance;
}

float SlicedMap::at(const Place3& place, int sector) const {
    return value(x_.index(place[0]), y_.index(place[1]), layerOf(place[2]), sector);
}

double SlicedMap::largest(int sector) {
    auto& known = largest_.at(static_cast<std::size_t>(sector));
    if (known) return *known;
    float most = 0;
    for (int k = 0; k < layers(); ++k) {
        for (int y = 0; y < y_.count; ++y) {
            for (int x = 0; x < x_.count; ++x) most = std::max(most, value(x, y, k, sector));
        }
    }
    known = static_cast<double>(most);
    return *known;
}

Point toSlice(SliceAxis axis, double slabTexels, const Place3& place) {
    if (axis == SliceAxis::Z) return {place[0], place[1]};
    return {axis == SliceAxis::X ? place[1] : place[0], slabTexels - place[2]};
}

double offPlane(SliceAxis axis, double plane, const Place3& place) {
    return place[index(axis)] - plane;
}

Place3 fromSlice(SliceAxis axis, double slabTexels, double plane, Point at) {
    if (axis == SliceAxis::Z) return {at.x, at.y, plane};
    if (axis == SliceAxis::X) return {plane, at.x, slabTexels - at.y};
    return {at.x, plane, slabTexels - at.y};
}

namespace {

// Columns and rows of the slice.
struct SliceGrid {
    VoxelAxis u;
    VoxelAxis v;  // for heights, counted from the top
};

SliceGrid gridOf(const SlicedMap& map, SliceAxis axis) {
    SliceGrid grid;
    grid.u = axis == SliceAxis::X ? map.y() : map.x();
    grid.v = map.y();
    if (axis != SliceAxis::Z) {
        grid.v = {};
        grid.v.count = map.layers();
        grid.v.side = map.slabTexels() / map.layers();
        grid.v.period = map.slabTexels();
    }
    return grid;
}

// Difference of two distances or slopes. Marks are negative numbers that a difference could also equal, so NaN stands
// for buried voxels.
float shownValue(float value) {
    return value == StoredValues::kBuried ? std::numeric_limits<float>::quiet_NaN() : value;
}
float difference(float a, float b) {
    if (a == StoredValues::kBuried && b == StoredValues::kBuried) return shownValue(a);
    return std::max(a, 0.0F) - std::max(b, 0.0F);
}

}  // namespace

MapSlice mapSlice(SlicedMap& first, SlicedMap* second, const SliceOrder& order) {
    const SliceAxis axis = first.slopes() ? SliceAxis::Z : order.axis;
    SliceGrid grid = gridOf(first, axis);
    if (second != nullptr) {
        const SliceGrid other = gridOf(*second, axis);
        if (other.u.count > grid.u.count) grid.u = other.u;
        if (other.v.count > grid.v.count) grid.v = other.v;
    }
    auto values = std::make_shared<relief::FloatImage>(grid.u.count, grid.v.count);
    float most = 0;
    constexpr std::size_t kMostSorted = std::size_t{1} << 20;
    ValueSpread spread(kMostSorted);
    for (int j = 0; j < grid.v.count; ++j) {
        for (int i = 0; i < grid.u.count; ++i) {
            const Place3 place = fromSlice(axis, first.slabTexels(), order.plane, {grid.u.center(i), grid.v.center(j)});
            const float a = first.at(place, order.sector);
            const float value =
                second != nullptr ? difference(a, second->at(place, order.secondSector)) : shownValue(a);
            (*values)(i, j) = value;
            most = std::fmax(most, std::abs(value));
            if (second != nullptr || value >= 0) spread.add(value);
        }
    }
    MapSlice slice;
    spread.finish();
    slice.spread = std::make_shared<const ValueSpread>(std::move(spread));
    slice.values = std::move(values);
    slice.start = {grid.u.start, grid.v.start};
    slice.cellWidth = grid.u.side;
    slice.cellHeight = grid.v.side;
    slice.periodU = grid.u.period;
    slice.periodV = grid.v.period;
    slice.wrapsU = grid.u.wraps;
    slice.wrapsV = grid.v.wraps;
    // All slices of one map share a range, so that their colours have the same meaning.
    slice.high = second != nullptr ? static_cast<double>(most) : first.largest(order.sector);
    slice.low = second != nullptr ? -slice.high : 0;
    return slice;
}

}  // namespace reliefui
