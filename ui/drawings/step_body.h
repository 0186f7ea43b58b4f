// What a step of a method that walks a distance or cone map knew to be empty: a sphere around a point of the ray, or a
// cone under one. Nothing is traced here: records and maps say it all.
#pragma once

#include <string>

#include "drawings/drawing.h"
#include "relief/describe.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// The map that a method walks, or the method inside it.
struct MapWalk {
    std::string kind;              // as in mapKinds(); empty: none
    bool cones = false;            // of slopes, not of distances
    bool interpolated = false;     // read between the centres, at points of the ray; else voxel by voxel
    int footprint = 1;             // of a voxel, cells a side
    int layers = 1;                // voxels that the slab is high
    int sectors = 1;               // azimuth sectors that have values of their own
    relief::OptionValues options;  // all of the walking method: as given, or its defaults

    explicit operator bool() const { return !kind.empty(); }
};
MapWalk walkedMap(const relief::MethodChoice& choice);

// lambda: of the point of the ray that the sphere is around, or that is over the cone's apex.
struct StepBody {
    enum class Kind : std::uint8_t { None, Sphere, Cone };
    Kind kind = Kind::None;
    double lambda = 0;
    double radius = 0;  // sphere: texels, in the metric (x, y, D z)
    double apex = 0;    // cone: height
    double slope = 0;   // cone: heights a texel of horizontal way
    double from = 0;    // cone: azimuths of (x, y) that it holds for, radians; all of them: 0 to 2 pi
    double to = 0;

    explicit operator bool() const { return kind != Kind::None; }
    // Whether the cone holds in that direction.
    bool holds(double x, double y) const;
    bool whole() const;
};
// maxima: over the cells of the field.
StepBody stepBody(const MapWalk& walk, const relief::HeightField& field, const relief::MaxPyramidMap& maxima,
                  const relief::ViewRay& ray, const relief::Step& step);

// Whether the value of such a record is a height (of an apex), which drawings can show as one.
bool valueIsHeight(const MapWalk& walk, const relief::Step& step);

// The voxel that a step of a walk from voxel to voxel is about: its sides (unwrapped texels) and heights.
struct VoxelBox {
    Box sides;
    double low = 0;
    double high = 0;
};
VoxelBox voxelBox(const MapWalk& walk, const relief::HeightField& field, const relief::Step& step);
// Whether the record's place is a voxel's, as of all records of such a walk but those that test a cell.
bool liesInVoxel(const MapWalk& walk, const relief::Step& step);
// Where a record's texel, cell or voxel lies in the texture's plane; unwrapped texels. baseLevel: see stepBox.
Box placeOf(const MapWalk& walk, const relief::HeightField& field, const relief::Step& step, int baseLevel = 0);
// Whether the record is about a voxel and its distance, not a cell or a point.
bool namesVoxel(const MapWalk& walk, const relief::Step& step);

}  // namespace reliefui
