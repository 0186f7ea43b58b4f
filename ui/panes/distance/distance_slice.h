// Slices of distance maps, and cone maps seen from above, as grids of values.
//
// Place: texels (x, y, h), h = height times the slab's thickness D; x and y unwrapped. In a slice: u to the right, v
// downwards, both texels: (y, D - h) of a slice at constant x, (x, D - h) at constant y, (x, y) at constant height.
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

// Voxels or texels along one axis of a map. Voxel i reaches from start + i * side to the next, or to the period's end.
struct VoxelAxis {
    int count = 0;
    double start = 0;
    double side = 1;
    double period = 0;  // texels
    bool wraps = false;

    // Of the voxel that holds the place, in [0, count).
    int index(double place) const;
    double center(int index) const;
};

// A map that is looked at: any kind behind one face.
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
    // Voxels that a slice is chosen among.
    int slices(SliceAxis axis) const;
    int sliceAt(SliceAxis axis, const Place3& place) const;
    // The middle of the slice, in the period of `near`.
    double planeOf(SliceAxis axis, int slice, const Place3& near) const;

    // Texels, or heights a texel; StoredValues::kBuried and kSurface are marks: no distance to go by. Of maps whose
    // values lie at centres, a distance of 0 is buried.
    float value(int bx, int by, int layer, int sector) const;
    float at(const Place3& place, int sector) const;
    // Of all values of the sector; 0 if there are only marks. Takes a while: looked up once.
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

// What is shown of one map, or of the difference of two.
struct SliceOrder {
    SliceAxis axis = SliceAxis::Y;
    double plane = 0;  // texels along the axis; of height: h
    int sector = 0;
    int secondSector = 0;
};

// One period of the slice, in the voxels of the finer map; NaN: buried. Rows from the top (greatest height) or the
// least y.
struct MapSlice {
    std::shared_ptr<const relief::FloatImage> values;
    Point start;  // (u, v) of the first cell's corner
    double cellWidth = 1;
    double cellHeight = 1;
    double periodU = 0;  // texels
    double periodV = 0;
    bool wrapsU = false;
    bool wrapsV = false;
    double low = 0;  // of the map in all its slices, or of the difference
    double high = 1;
    std::shared_ptr<const ValueSpread> spread;  // of the slice, without marks
};
// second: null for one map alone. A voxel that either map has no distance for counts as 0; buried is what both bury.
MapSlice mapSlice(SlicedMap& first, SlicedMap* second, const SliceOrder& order);

// (u, v) of a place, and how far it lies off the plane.
Point toSlice(SliceAxis axis, double slabTexels, const Place3& place);
double offPlane(SliceAxis axis, double plane, const Place3& place);
// The place in the plane.
Place3 fromSlice(SliceAxis axis, double slabTexels, double plane, Point at);

}  // namespace reliefui
