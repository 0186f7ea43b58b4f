// How a drawing lies on a screen, what is under the pointer, and which labels have room.
#pragma once

#include <utility>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

// screen = drawing * scale + (dx, dy); pixels, y downwards.
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
    // The whole of `bounds`, centred in `screen`.
    static ViewMap fitting(const Box& bounds, const Box& screen);
    // Zoomed by `factor`; the point under `at` (screen) stays.
    ViewMap zoomed(double factor, Point at) const {
        return {scale * factor, at.x + (dx - at.x) * factor, at.y + (dy - at.y) * factor};
    }
    bool operator==(const ViewMap&) const = default;
};

// Where a rectangle is really drawn: grown to its smallest side, inset. Screen pixels.
Box screenBox(const Rectangle& rectangle, const ViewMap& map, double pixelsPerPoint);

// The cells of `cells` that are seen in `visible` (drawing units): [i0, i1) x [j0, j1).
struct CellRange {
    int i0 = 0;
    int j0 = 0;
    int i1 = 0;
    int j1 = 0;
    std::int64_t count() const { return std::int64_t{i1 - i0} * (j1 - j0); }
};
CellRange visibleCells(const Cells& cells, const Box& visible);
// Cell (i, j) cut to the clip.
Box cellBox(const Cells& cells, int i, int j);

// The topmost item with an id under the screen point; cells answer with the id of the texel. `tolerance`: pixels.
ItemId pick(const Drawing& drawing, const ViewMap& map, Point at, double pixelsPerPoint, double tolerance = 4);

// Remembers where text stands.
class LabelRoom {
  public:
    bool free(const Box& box) const;
    void take(const Box& box) { placed_.push_back(box); }
    // False if the box covers one placed before; else it is placed.
    bool place(const Box& box);

  private:
    std::vector<Box> placed_;
};

// The box of a text of this size (pixels) at its anchor; empty: it is not drawn.
Box labelBox(const Label& label, const ViewMap& map, double width, double height, double pixelsPerPoint);

using Segment = std::pair<Point, Point>;

// Cuts the segment to the box; false: nothing of it lies within. An end that lies within keeps its bits.
bool clip(Segment& segment, const Box& box);
// The parts of a line that lie within the box; before: the length of the line up to each of them.
std::vector<std::vector<Point>> clippedTo(const std::vector<Point>& line, const Box& box,
                                          std::vector<double>* before = nullptr);

// The ellipse that a and b are half axes of (any two conjugate ones), begun at -a; closed.
std::vector<Point> ellipseLine(Point centre, Point a, Point b);

// What of a line lies in a plot, drawn.
void addLine(Drawing& drawing, const std::vector<Point>& line, const Box& plot, ItemId id, Role role,
             Emphasis emphasis = Emphasis::Normal, LevelTint tint = {});
// What lies between a line (x ascending) and the horizontal at y, in a plot.
void addFill(Drawing& drawing, const std::vector<Point>& line, double y, const Box& plot, Role role);
// An ellipse with upright axes in a plot; a strong one is filled.
void addEllipse(Drawing& drawing, Point centre, double rx, double ry, const Box& plot, ItemId id, Role role,
                Emphasis emphasis);

// Outlines of marker shapes, in pixels around the origin, y downwards; closed polygons. Empty for Ring and Dot, which
// are round, and for Cross, which is two strokes.
std::vector<Point> shapePolygon(Shape shape, double size);
bool shapeFilled(Shape shape);
// Whether a line is set off from what lies under it.
bool hasHalo(const Item& item);

}  // namespace reliefui
