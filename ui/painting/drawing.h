// A two-dimensional picture as plain data: a display list that the painter puts on a screen, into an SVG or a PDF.
// No Qt, no VTK: items have stable ids (for picking), roles instead of colours, message ids with values instead of
// text. Lengths are in drawing units, y downwards; what must stay readable at any zoom is in points.
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

// Empty where x1 < x0.
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

// What an item stands for, the same from one build of the drawing to the next.
enum class ItemKind : std::uint8_t { None, Level, Texel, Step, Ray, Hit, Legend, Surface, Layer, IsoLine, ColorBar };
struct ItemId {
    ItemKind kind = ItemKind::None;
    int level = 0;
    std::int64_t i = 0;  // of a texel; the number of a step or a layer, from 0
    std::int64_t j = 0;

    explicit operator bool() const { return kind != ItemKind::None; }
    auto operator<=>(const ItemId&) const = default;
};
// "texel/3/1/0", "step/7"; also the id in an SVG.
std::string idText(const ItemId& id);
// Of a step of a run.
inline ItemId stepId(std::size_t step, int run = 0) {
    return {ItemKind::Step, run, static_cast<std::int64_t>(step), 0};
}

// What a thing is; the style turns it into a colour, a width, a dash and a shape (style.h).
enum class Role : std::uint8_t {
    Ray,
    Start,
    Skipped,
    Descended,
    Ascended,
    Advanced,
    Tested,
    Refined,
    Searched,  // whatever was decided: the phase between start and refinement
    Limit,
    Hit,
    Miss,
    Overshoot,
    Footprint,    // of a pixel: all that counts
    PixelCircle,  // of radius 1 pixel
    Neighbour,    // footprints beside it
    Weight,
    Hidden,
    Blocker,
    Empty,  // promised by a map: spheres and cones
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
    Series,        // one of several things compared; which one, its tint says
    SeriesDashed,  // another quantity of the same
    Stream,        // of pixels computed in turn; which one, its tint says
    Count
};
Role roleOf(relief::Decision decision);

// Drawn less (what comes later), as it is, or more (what is chosen).
enum class Emphasis : std::uint8_t { Faint, Normal, Strong };

// Colour is never alone: each decision has a shape, too.
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

// Distance: values from 0; marks below 0 (surface voxels) and NaN (in the relief) have colours of their own.
// Difference: around 0, which is white. Signed: around 0, which is dark: a colour for each sign, lighter with the size.
// Picture: the values are colours, 65536 red + 256 green + blue (whole numbers that a float holds exactly).
enum class ColorMap : std::uint8_t { Height, Level, Count, Distance, Difference, Signed, Picture };

// Outline or fill of a box. inset: points by which the outline lies inside it; minSide: points below which it is not
// drawn smaller, so that single texels of a big map can still be seen.
struct Rectangle {
    Box box;
    bool fill = false;
    double inset = 0;
    double minSide = 0;
};

// A grid of values in colours. The grid starts at (x, y); only what lies in `clip` is seen. Values are printed into
// cells that are large enough on the screen.
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
    double printFrom = 0;     // points: the values of lower cells are not printed
    std::int64_t firstI = 0;  // names of the first column and row, for picking
    std::int64_t firstJ = 0;
};

// What lies between a line (x ascending) and the horizontal at `base`.
struct Area {
    std::vector<Point> line;
    double base = 0;
};

struct Polyline {
    std::vector<Point> points;
    bool arrow = false;  // at its end
};

// A disc of drawing units.
struct Circle {
    Point center;
    double radius = 0;
    bool fill = false;
    bool rim = false;  // a dark one, which sets it off from any ground
};

// A ring of `radius` points with a halo: seen on any ground.
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
// Text of `size` times the style's size. yields: left out where it would cover text placed before it (in the order of
// the items, strong ones first).
struct Label {
    Point at{};
    relief::Message text{};
    Anchor anchor = Anchor::Left;
    double size = 1;
    Point offset{};      // points
    bool plate = false;  // on a plate of its role's colour
    bool yields = false;
    Box room{};            // drawn only if it fits in here (drawing units); empty: always
    bool evades = false;   // drawn beside the room where it does not fit
    int part = -1;         // of what stands between " · " in the text this one alone, from 0; -1: all
    bool formula = false;  // set as one: formula_text.h
};

// What stands between " · ".
std::vector<std::string> textParts(const std::string& text);
// Its words in a language.
std::string labelText(const Label& label, relief::Language language);

using Primitive = std::variant<Rectangle, Cells, Area, Polyline, Circle, Ring, Marker, Hatch, Label>;

// Plateau: the pyramid's level. Series, streams: their number. IsoLine: for a ground that is (kLightLine, kDarkLine).
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
    // All that another one shows; the bounds hold both.
    void append(Drawing other);
};

// A bar of all colours of a map, from the left to the right.
Cells colorBar(const Box& box, ColorMap map, const ColorScale& scale = {});

relief::Message plainText(std::string text);
// Nothing but these words, in the middle: what would fill the drawing, and how.
Drawing messageDrawing(relief::MessageId message);

}  // namespace reliefui
