// The distance map as a drawing: a slice through it, with the surface, lines of equal distance, the ray, and the
// spheres and cones that the map promises free at the steps, where the slice cuts them. [DIST17] figs. 3 to 8. Cone
// maps are seen from above.
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
    std::string kind;               // of mapKinds(); empty: the method's own, or euclidean
    std::string minus;              // the map that is taken away; empty: none
    std::optional<SliceAxis> axis;  // none: at constant x or y, whichever the ray crosses less
    std::optional<int> slice;       // none: the one that holds the current step, exactly through it
    std::optional<int> sector;      // of a map that has several; none: the ray's
    bool isoLines = true;
    bool nearRay = true;  // only the surroundings of the ray
    ColorRanges ranges;

    bool operator==(const DistanceOptions&) const = default;
};

// What is drawn; referred to, not copied.
struct DistanceSource {
    const relief::HeightField* field = nullptr;
    std::shared_ptr<const relief::MaxPyramidMap> maxima;
    SlicedMap* first = nullptr;
    SlicedMap* second = nullptr;  // null: none
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    relief::Hit exact;  // the first hit; Unset: not known
    const std::vector<relief::Step>* steps = nullptr;
    std::shared_ptr<const PointQuery> point;  // whose distances are shown; null: none
};

// Where what lies on the drawing, whose units are points.
struct DistanceFrame {
    SliceAxis axis = SliceAxis::Y;
    int slices = 1;    // there are
    int slice = 0;     // that is shown
    double plane = 0;  // texels along the axis; of height: h
    double cut = 0;    // where values are looked up: within the voxel that the plane goes through or touches
    double slab = 0;   // D
    int sector = 0;
    int sectors = 1;  // of the first map
    bool slopes = false;
    Box window;  // (u, v) that is shown, texels
    Box plot;
    Box whole;
    double scale = 1;  // points a texel

    Point at(Point uv) const { return {plot.x0 + (uv.x - window.x0) * scale, plot.y0 + (uv.y - window.y0) * scale}; }
    Point uvAt(Point p) const { return {window.x0 + (p.x - plot.x0) / scale, window.y0 + (p.y - plot.y0) / scale}; }
    Point at(const Place3& place) const { return at(toSlice(axis, slab, place)); }
};

// The slice: made anew with the map, the slice or the room.
struct DistancePicture {
    DistanceFrame frame;
    MapSlice slice;
    RangedValues values;   // of the slice; their name is in the drawing's language
    double isoStep = 0;    // of the lines; 0: there are none, or
    int isoPerDecade = 0;  // of a logarithmic scale: 3 (at 1, 2 and 5) or 1
    std::string kind;
    std::string minus;
    Drawing drawing;
};
// width, height: room in points.
// Throws InputError where distances and slopes are to be compared.
DistancePicture distancePicture(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                                double height, relief::Language language);
DistanceFrame distanceFrame(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                            double height);
// Numbers, units and the title; part of the picture.
void addDistanceAxes(DistancePicture& picture, relief::Language language);

// The ray, the steps up to the chosen one, and what the map promised them free; the point with its distances.
Drawing distanceMarks(const DistanceSource& source, const DistanceFrame& frame, int step);

// The slice in the colours that its range makes of it.
RangedValues sliceValues(const DistancePicture& picture, const ColorRanges& ranges, relief::Language language);
// Colours and marks, in at most `width` points. brief: without the histogram.
Drawing distanceLegend(const DistanceSource& source, const DistancePicture& picture, double width,
                       relief::Language language, bool brief = false);

// Where the ray is, and lambda where it ends: its hit, or where it was given up.
Place3 placeOnRay(const DistanceSource& source, double lambda);
double rayEndOf(const DistanceSource& source);
// The place of a step on the ray: the centre of its sphere, or where it is at.
Place3 stepPlace(const DistanceSource& source, int step);

// What is under a point of the drawing.
struct DistanceReading {
    bool inside = false;
    bool onMap = false;  // not beyond the picture's edge
    Place3 place{};
    int bx = 0;  // the voxel or texel of the first map
    int by = 0;
    int layer = 0;
    float first = 0;  // values or marks
    float second = 0;
};
DistanceReading distanceReading(const DistanceSource& source, const DistanceFrame& frame, int secondSector, Point at);
// The sector of the second map that is taken for this order.
int sectorOf(const SlicedMap& map, const DistanceSource& source, const DistanceOptions& options);

// The plane of the slice; refers to the frame.
PointPlane pointPlane(const PointQuery& query, const relief::HeightField& field, const DistanceFrame& frame);

}  // namespace reliefui
