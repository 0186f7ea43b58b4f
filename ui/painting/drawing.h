// A two-dimensional drawing as plain data: a display list that the painter renders to the screen, an SVG or a PDF. It
// uses neither Qt nor VTK: items have stable ids (for picking), roles instead of colours, and message ids with values
// instead of text. Lengths are in drawing units, y downwards; sizes that must stay legible at any zoom are in points.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "painting/color_range.h"
#include "relief/image.h"
#include "relief/messages.h"
#include "relief/step_log.h"

namespace reliefui {

struct Point {
    double x = 0;
    double y = 0;
    bool operator==(const Point&) const = default;
};

// Axis-aligned box; empty if x1 < x0.
struct Box {
    double x0 = 0;
    double y0 = 0;
    double x1 = -1;
    double y1 = -1;

    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    Point center() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
    bool empty() const { return x1 < x0 || y1 < y0; }
    bool contains(Point p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
    bool overlaps(const Box& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
    Box grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
    Box moved(Point by) const { return {x0 + by.x, y0 + by.y, x1 + by.x, y1 + by.y}; }
    Box cut(const Box& o) const {
        return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
    }
    Box joined(const Box& o) const {
        if (empty()) return o;
        if (o.empty()) return *this;
        return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
    }
    bool operator==(const Box&) const = default;
};

// The object that an item represents. Ids are stable from one build of the drawing to the next.
enum class ItemKind : std::uint8_t { None, Level, Texel, Step, Ray, Hit, Legend, Surface, Layer, IsoLine, ColorBar };
struct ItemId {
    ItemKind kind = ItemKind::None;
    int level = 0;
    std::int64_t i = 0;  // column of a texel, or zero-based number of a step or layer
    std::int64_t j = 0;

    explicit operator bool() const { return kind != ItemKind::None; }
    auto operator<=>(const ItemId&) const = default;
};
// Text form, e.g. "texel/3/1/0" or "step/7"; used as the id in SVG files.
std::string idText(const ItemId& id);
// Id of a step of a run.
inline ItemId stepId(std::size_t step, int run = 0) {
    return {ItemKind::Step, run, static_cast<std::int64_t>(step), 0};
}

// What an item depicts; the style maps it to a colour, line width, dash pattern and shape (style.h).
enum class Role : std::uint8_t {
    Ray,
    Start,
    Skipped,
    Descended,
    Ascended,
    Advanced,
    Tested,
    Refined,
    Searched,  // search phase, between start and refinement, whatever its decision
    Limit,
    Hit,
    Miss,
    Overshoot,
    Footprint,    // all texels that contribute to a pixel
    PixelCircle,  // circle of radius 1 pixel, on the texture
    Neighbour,    // footprints of neighbouring pixels
    Weight,
    Hidden,
    Blocker,
    Empty,  // space that a map guarantees to be empty: spheres and cones
    IsoLine,
    Surface,
    Plateau,
    Layer,
    Sample,
    Background,
    HeightFill,
    Grid,
    Frame,
    Label,
    Title,
    Legend,
    Highlight,
    Series,        // one of several compared objects; the tint gives its number
    SeriesDashed,  // another quantity of the same object
    Stream,        // one of several streams of pixels computed in turn; the tint gives its number
    Count
};
Role roleOf(relief::Decision decision);

// Faint: items that come later. Strong: chosen items.
enum class Emphasis : std::uint8_t { Faint, Normal, Strong };

// Marker shapes. Each decision has a shape as well as a colour, so that colour is never the only cue.
enum class Shape : std::uint8_t {
    Dot,
    Bar,
    TriangleRight,
    TriangleDown,
    TriangleUpHollow,
    Diamond,
    DotSmall,
    Cross,
    Ring,
    SquareHollow
};
Shape shapeOf(relief::Decision decision);

// Distance: values from 0; marks below 0 (surface voxels) and NaN (inside the relief) have colours of their own.
// Difference: diverging around 0, which is white. Signed: diverging around 0, which is dark; lightness grows with
// magnitude.
// Picture: the values are colours, 65536 red + 256 green + blue (whole numbers, exact in float).
enum class ColorMap : std::uint8_t { Height, Level, Count, Distance, Difference, Signed, Picture };

// Outline or fill of a box. inset: distance in points by which the outline lies inside the box. minSide: smallest side
// in points; smaller boxes are enlarged, so that single texels of a large map stay visible.
struct Rectangle {
    Box box;
    bool fill = false;
    double inset = 0;
    double minSide = 0;
};

// A grid of values shown in colours. The grid starts at (x, y); only the part inside `clip` is visible. If `print` is
// set, values are printed into cells that are large enough on the screen.
struct Cells {
    std::shared_ptr<const relief::FloatImage> values{};
    double x = 0;
    double y = 0;
    double cellWidth = 1;
    double cellHeight = 1;
    Box clip{};
    ColorMap map = ColorMap::Height;
    ColorScale scale{};
    bool print = false;
    double printFrom = 0;     // cell height in points below which values are not printed
    std::int64_t firstI = 0;  // column and row numbers of the first cell, for picking
    std::int64_t firstJ = 0;
};

// Filled area between a line (x ascending) and the horizontal at `base`.
struct Area {
    std::vector<Point> line;
    double base = 0;
};

struct Polyline {
    std::vector<Point> points;
    bool arrow = false;  // at the last point
};

// Circle or disc; the radius is in drawing units.
struct Circle {
    Point center;
    double radius = 0;
    bool fill = false;
    bool rim = false;  // adds a dark outline, visible on any background
};

// Ring with a halo, visible on any background; the radius is in points.
struct Ring {
    Point center;
    double radius = 5;
};

struct Marker {
    Point at;
    Shape shape = Shape::Dot;
    double size = 8;  // points
};

struct Hatch {
    Box box;
};

enum class Anchor : std::uint8_t { TopLeft, Left, BottomLeft, Center, Top, Bottom, Right };
// Text; `size` is relative to the style's text size. yields: the label is left out if it would cover text placed before
// it (in the order of the items, strong ones first).
struct Label {
    Point at{};
    relief::Message text{};
    Anchor anchor = Anchor::Left;
    double size = 1;
    Point offset{};      // points
    bool plate = false;  // on a background plate in its role's colour
    bool yields = false;
    Box room{};            // if not empty (drawing units), the label is drawn only if it fits into this box
    bool evades = false;   // drawn next to `room` instead if it does not fit
    int part = -1;         // of what stands between " · " in the text this one alone, from 0; -1: all
    bool formula = false;  // typeset as a formula, see formula_text.h
};

// Splits a text at " · ".
std::vector<std::string> textParts(const std::string& text);
// The label's text in a language.
std::string labelText(const Label& label, relief::Language language);

using Primitive = std::variant<Rectangle, Cells, Area, Polyline, Circle, Ring, Marker, Hatch, Label>;

// Number that selects the colour within a role. Plateau: pyramid level. Series and Stream: their number. IsoLine:
// brightness of the background (kLightLine, kDarkLine).
struct LevelTint {
    int level = 0;
    int levels = 1;
};

struct Item {
    ItemId id;
    Role role = Role::Frame;
    Emphasis emphasis = Emphasis::Normal;
    Primitive primitive;
    LevelTint tint{};
};

struct Drawing {
    Box bounds;
    std::vector<Item> items;

    void add(ItemId id, Role role, Primitive primitive, Emphasis emphasis = Emphasis::Normal, LevelTint tint = {}) {
        items.push_back({id, role, emphasis, std::move(primitive), tint});
    }
    // Appends all items of another drawing and extends the bounds to enclose both.
    void append(Drawing other);
};

// Colour bar: all colours of a map, from left to right.
Cells colorBar(const Box& box, ColorMap map, const ColorScale& scale = {});

relief::Message plainText(std::string text);
// Drawing that consists of one centred message, such as an explanation of why there is nothing to show yet.
Drawing messageDrawing(relief::MessageId message);

}  // namespace reliefui
