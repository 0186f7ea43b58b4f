// The distance map as a drawing: a slice through it, with the surface, lines of equal distance, the ray, and the
// cross-sections of the spheres and cones that the map guarantees to be empty at the steps. [DIST17] figs. 3 to 8. Cone
// maps are drawn from above.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "painting/range_legend.h"
#include "painting/step_body.h"
#include "panes/distance/distance_slice.h"
#include "panes/point_query.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

struct DistanceOptions {
    std::string kind;               // one of mapKinds(); empty: the method's own map, or the Euclidean one
    std::string minus;              // kind of the map to subtract; empty: none
    std::optional<SliceAxis> axis;  // default: constant x or y, whichever the ray traverses less
    std::optional<int> slice;       // default: the slice that contains the current step, at the step's exact position
    std::optional<int> sector;      // for maps with several sectors; default: the ray's
    bool isoLines = true;
    bool nearRay = true;  // show only the surroundings of the ray
    ColorRanges ranges;

    bool operator==(const DistanceOptions&) const = default;
};

// Input of the drawing; holds references, not copies.
struct DistanceSource {
    const relief::HeightField* field = nullptr;
    std::shared_ptr<const relief::MaxPyramidMap> maxima;
    SlicedMap* first = nullptr;
    SlicedMap* second = nullptr;  // null: none
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    relief::Hit exact;  // first hit of the ray; Unset: not known
    const std::vector<relief::Step>* steps = nullptr;
    std::shared_ptr<const PointQuery> point;  // point whose distances are shown; null: none
};

// Layout of the drawing, whose unit is the point.
struct DistanceFrame {
    SliceAxis axis = SliceAxis::Y;
    int slices = 1;    // number of slices
    int slice = 0;     // index of the slice shown
    double plane = 0;  // position along the axis, in texels; for horizontal slices h
    double cut = 0;    // position at which values are looked up: inside the voxel that the plane intersects or touches
    double slab = 0;   // thickness D of the slab
    int sector = 0;
    int sectors = 1;  // of the first map
    bool slopes = false;
    Box window;  // visible range of (u, v), in texels
    Box plot;
    Box whole;
    double scale = 1;  // points per texel

    Point at(Point uv) const { return {plot.x0 + (uv.x - window.x0) * scale, plot.y0 + (uv.y - window.y0) * scale}; }
    Point uvAt(Point p) const { return {window.x0 + (p.x - plot.x0) / scale, window.y0 + (p.y - plot.y0) / scale}; }
    Point at(const Place3& place) const { return at(toSlice(axis, slab, place)); }
};

// The slice; built again if the map, the slice or the size changes.
struct DistancePicture {
    DistanceFrame frame;
    MapSlice slice;
    RangedValues values;   // of the slice; the name is in the drawing's language
    double isoStep = 0;    // between iso-lines; 0: there are no lines, or isoPerDecade is used
    int isoPerDecade = 0;  // on a logarithmic scale: 3 (at 1, 2 and 5) or 1
    double isoValue = 0;   // of the longest iso-line
    std::string kind;
    std::string minus;
    Drawing drawing;
};
// Tint of an iso-line at this value, which must be visible on the map's colour for it.
LevelTint isoTint(const RangedValues& values, double value);
// width, height: available room in points. Throws InputError if a distance map and a cone map would be subtracted.
DistancePicture distancePicture(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                                double height, relief::Language language);
DistanceFrame distanceFrame(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                            double height);
// Adds numbers, units and the title to the picture.
void addDistanceAxes(DistancePicture& picture, relief::Language language);

// The ray, the steps up to the chosen one with the space that the map guarantees to be empty, and the queried point
// with its distances.
Drawing distanceMarks(const DistanceSource& source, const DistanceFrame& frame, int step);

// The slice's values with the colours given by its range.
RangedValues sliceValues(const DistancePicture& picture, const ColorRanges& ranges, relief::Language language);
// Legend of colours and marks, at most `width` points wide. brief: without the histogram.
Drawing distanceLegend(const DistanceSource& source, const DistancePicture& picture, double width,
                       relief::Language language, bool brief = false);

// placeOnRay(): position on the ray. rayEndOf(): lambda at the ray's end: its hit, or where the tracer gave up.
Place3 placeOnRay(const DistanceSource& source, double lambda);
double rayEndOf(const DistanceSource& source);
// Position of a step: the centre of its sphere, otherwise the point of the ray.
Place3 stepPlace(const DistanceSource& source, int step);

// What is under a point of the drawing.
struct DistanceReading {
    bool inside = false;
    bool onMap = false;  // not beyond the edge of the height map
    Place3 place{};
    int bx = 0;  // voxel or texel of the first map
    int by = 0;
    int layer = 0;
    float first = 0;  // values or marks of the two maps
    float second = 0;
};
DistanceReading distanceReading(const DistanceSource& source, const DistanceFrame& frame, int secondSector, Point at);
// The sector of this map that is used with these options.
int sectorOf(const SlicedMap& map, const DistanceSource& source, const DistanceOptions& options);

// The slice's plane for point queries; holds a reference to the frame.
PointPlane pointPlane(const PointQuery& query, const relief::HeightField& field, const DistanceFrame& frame);

}  // namespace reliefui
