// The mapping from a drawing to the screen, picking of the item under the pointer, and placement of labels.
#pragma once

#include <utility>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// screen = drawing * scale + (dx, dy); screen coordinates are pixels, y downwards.
struct ViewMap {
    double scale = 1;
    double dx = 0;
    double dy = 0;

    Point toScreen(Point p) const { return {p.x * scale + dx, p.y * scale + dy}; }
    Point toDrawing(Point p) const { return {(p.x - dx) / scale, (p.y - dy) / scale}; }
    Box toScreen(const Box& b) const {
        return {b.x0 * scale + dx, b.y0 * scale + dy, b.x1 * scale + dx, b.y1 * scale + dy};
    }
    Box toDrawing(const Box& b) const {
        return {(b.x0 - dx) / scale, (b.y0 - dy) / scale, (b.x1 - dx) / scale, (b.y1 - dy) / scale};
    }
    // Shows all of `bounds`, centred in `screen`.
    static ViewMap fitting(const Box& bounds, const Box& screen);
    // Zooms by `factor` and keeps the point under `at` (screen) fixed.
    ViewMap zoomed(double factor, Point at) const {
        return {scale * factor, at.x + (dx - at.x) * factor, at.y + (dy - at.y) * factor};
    }
    bool operator==(const ViewMap&) const = default;
};

// Box of a rectangle as drawn, in screen pixels: enlarged to minSide, then inset.
Box screenBox(const Rectangle& rectangle, const ViewMap& map, double pixelsPerPoint);

// Range of cell indices [i0, i1) x [j0, j1).
struct CellRange {
    int i0 = 0;
    int j0 = 0;
    int i1 = 0;
    int j1 = 0;
    std::int64_t count() const { return std::int64_t{i1 - i0} * (j1 - j0); }
};
CellRange visibleCells(const Cells& cells, const Box& visible);
// Box of cell (i, j), intersected with the clip box.
Box cellBox(const Cells& cells, int i, int j);

// Returns the id of the topmost item that has one under the screen point; for a grid of cells the id of the texel.
// `tolerance`: pixels.
ItemId pick(const Drawing& drawing, const ViewMap& map, Point at, double pixelsPerPoint, double tolerance = 4);

// Keeps the boxes of placed labels, to avoid overlaps.
class LabelRoom {
  public:
    bool free(const Box& box) const;
    void take(const Box& box) { placed_.push_back(box); }
    // Places the box unless it overlaps one placed before; returns whether it was placed.
    bool place(const Box& box);

  private:
    std::vector<Box> placed_;
};

// Screen box of a label whose text measures width x height pixels; empty if it is not drawn.
Box labelBox(const Label& label, const ViewMap& map, double width, double height, double pixelsPerPoint);

using Segment = std::pair<Point, Point>;

// Clips the segment to the box; returns false if no part lies inside. End points inside the box keep their exact
// values.
bool clip(Segment& segment, const Box& box);
// The parts of a line that lie inside the box. before: receives the length of the line up to the start of each part.
std::vector<std::vector<Point>> clippedTo(const std::vector<Point>& line, const Box& box,
                                          std::vector<double>* before = nullptr);

// Closed polyline of the ellipse with the conjugate half axes a and b; starts at centre - a.
std::vector<Point> ellipseLine(Point centre, Point a, Point b);

// Adds the part of a line that lies inside the plot.
void addLine(Drawing& drawing, const std::vector<Point>& line, const Box& plot, ItemId id, Role role,
             Emphasis emphasis = Emphasis::Normal, LevelTint tint = {});
// Adds the filled area between a line (x ascending) and the horizontal at y, clipped to the plot.
void addFill(Drawing& drawing, const std::vector<Point>& line, double y, const Box& plot, Role role);
// Adds an axis-aligned ellipse, clipped to the plot; filled if the emphasis is strong.
void addEllipse(Drawing& drawing, Point centre, double rx, double ry, const Box& plot, ItemId id, Role role,
                Emphasis emphasis);

// Outline of a marker shape as a closed polygon, in pixels around the origin, y downwards. Empty for Ring and Dot,
// which are round, and for Cross, which consists of two strokes.
std::vector<Point> shapePolygon(Shape shape, double size);
bool shapeFilled(Shape shape);
// Returns true if the item is drawn with a halo, which separates it from the items below.
bool hasHalo(const Item& item);

}  // namespace reliefui
