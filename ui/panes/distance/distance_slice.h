// Slices of distance maps, and cone maps seen from above, as grids of values.
//
// Place: (x, y, h) in texels, h = height times the slab's thickness D; x and y are unwrapped. Slice coordinates: u to
// the right, v downwards, both in texels: (y, D - h) at constant x, (x, D - h) at constant y, (x, y) at constant
// height.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "painting/drawing.h"
#include "panes/ray_geometry.h"
#include "relief/maps/map_files.h"

namespace reliefui {

enum class SliceAxis : std::uint8_t { X, Y, Z };

// Voxels or texels along one axis of a map. Voxel i extends from start + i * side to the start of the next, or to the
// end of the period.
struct VoxelAxis {
    int count = 0;
    double start = 0;
    double side = 1;
    double period = 0;  // in texels
    bool wraps = false;

    // Index of the voxel that contains the place, in [0, count).
    int index(double place) const;
    double center(int index) const;
};

// A map of any kind with a common interface.
class SlicedMap {
  public:
    SlicedMap(relief::StoredMap map, const relief::HeightField& field);

    const std::string& kind() const { return kind_; }
    bool slopes() const { return cones_ != nullptr; }
    int sectors() const;
    int layers() const { return slopes() ? 1 : distances_->layers(); }
    const VoxelAxis& x() const { return x_; }
    const VoxelAxis& y() const { return y_; }
    double slabTexels() const { return slab_; }
    int layerOf(double h) const;
    // Number of slices along the axis.
    int slices(SliceAxis axis) const;
    int sliceAt(SliceAxis axis, const Place3& place) const;
    // Centre of the slice, in the periodic copy that contains `near`.
    double planeOf(SliceAxis axis, int slice, const Place3& near) const;

    // Value in texels, or for cones in heights per texel. StoredValues::kBuried and kSurface are marks without a
    // distance. In maps whose values apply at voxel centres, a distance of 0 is returned as buried.
    float value(int bx, int by, int layer, int sector) const;
    float at(const Place3& place, int sector) const;
    // Largest value of the sector; 0 if there are only marks. Slow at the first call; then cached.
    double largest(int sector);

  private:
    std::string kind_;
    relief::StoredMap map_;
    const relief::DistanceMap* distances_ = nullptr;
    const relief::ConeMap* cones_ = nullptr;
    double slab_ = 0;
    VoxelAxis x_;
    VoxelAxis y_;
    std::vector<std::optional<double>> largest_;
};

// What to show of one map, or of the difference of two.
struct SliceOrder {
    SliceAxis axis = SliceAxis::Y;
    double plane = 0;  // position along the axis, in texels; for horizontal slices h
    int sector = 0;
    int secondSector = 0;
};

// One period of the slice, at the resolution of the finer map; NaN: buried. Rows start at the top (greatest height), or
// at the smallest y.
struct MapSlice {
    std::shared_ptr<const relief::FloatImage> values;
    Point start;  // (u, v) of the first cell's corner
    double cellWidth = 1;
    double cellHeight = 1;
    double periodU = 0;  // in texels
    double periodV = 0;
    bool wrapsU = false;
    bool wrapsV = false;
    double low = 0;  // range over all slices of the map, or of the difference
    double high = 1;
    std::shared_ptr<const ValueSpread> spread;  // of this slice, without marks
};
// second: null for a single map. In a difference, a mark of either map counts as 0, and only voxels buried in both maps
// are buried.
MapSlice mapSlice(SlicedMap& first, SlicedMap* second, const SliceOrder& order);

// toSlice(): (u, v) of a place. offPlane(): its signed distance from the plane.
Point toSlice(SliceAxis axis, double slabTexels, const Place3& place);
double offPlane(SliceAxis axis, double plane, const Place3& place);
// The place at (u, v) in the plane.
Place3 fromSlice(SliceAxis axis, double slabTexels, double plane, Point at);

}  // namespace reliefui
