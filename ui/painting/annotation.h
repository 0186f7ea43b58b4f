// Annotations: the user's arrows, labels, brackets and numbers on a view. Their places are in the coordinates of the
// view's data, so that they stay there at any size and zoom of the pane and in every export.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

enum class AnnotationKind : std::uint8_t { Arrow, Label, Bracket, Number };
inline constexpr std::array<std::string_view, 4> kAnnotationKinds{"arrow", "label", "bracket", "number"};

// The views, and the coordinates of their places.
inline constexpr std::array<std::string_view, 7> kAnnotatedViews{
    "result",      // pixels of the picture, y downwards
    "profile",     // the numbers of the axes: texels from the ray's entry (a vertical ray: its descent), height 0 to 1
    "distance-x",  // a slice at constant x: y in texels, height 0 to 1
    "distance-y",  // a slice at constant y: x in texels, height 0 to 1
    "distance-z",  // a horizontal slice, or a cone map: x, y in texels
    "pyramid",     // x, y in texels, on level 0
    "footprint"    // x, y in texels of the height map, unwrapped
};

// Colours of the style's palette, by name; kAnnotationRoles: what else is drawn in them.
inline constexpr std::array<std::string_view, 7> kAnnotationColors{"text", "vermilion", "orange", "green",
                                                                   "blue", "sky-blue",  "purple"};
inline constexpr std::array<Role, 7> kAnnotationRoles{Role::Hit,      Role::Ray,       Role::Tested, Role::Empty,
                                                      Role::Searched, Role::Neighbour, Role::Hidden};

struct Annotation {
    AnnotationKind kind = AnnotationKind::Label;
    std::string view;  // one of kAnnotatedViews
    // Label, number: the centre. Arrow: its tail, where the text stands. Bracket: an end.
    Point at{};
    // Arrow: its tip. Bracket: the other end; it opens to the right of the way from `at` to here, and the text stands
    // at the left. Otherwise unused.
    Point to{};
    std::string text;       // of arrows and brackets it may be empty
    std::string ukrainian;  // empty: as `text`
    std::string color{kAnnotationColors.front()};

    bool hasEnd() const { return kind == AnnotationKind::Arrow || kind == AnnotationKind::Bracket; }
    const std::string& textIn(relief::Language language) const {
        return language == relief::Language::Ukrainian && !ukrainian.empty() ? ukrainian : text;
    }
    bool operator==(const Annotation&) const = default;
};

// How the data of a view lie on its drawing.
struct AnnotationFrame {
    std::string_view view;
    std::function<Point(Point)> toDrawing;
    std::function<Point(Point)> toData;
    Box seen;         // the part of the drawing with data; texts stay within it
    double unit = 1;  // drawing units per point
};

// An annotation as it is drawn, in drawing units.
struct AnnotationShape {
    bool shown = false;  // false: of another view, or what it is about lies outside the part that is seen
    std::vector<Point> line;
    Box plate{};  // of the text; empty: none
    std::string text;
};
AnnotationShape annotationShape(const Annotation& note, const AnnotationFrame& frame, relief::Language language);

// Draws those annotations that belong to the frame's view.
Drawing annotationDrawing(const std::vector<Annotation>& notes, const AnnotationFrame& frame,
                          relief::Language language);

}  // namespace reliefui
