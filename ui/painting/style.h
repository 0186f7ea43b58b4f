// Roles turned into colours, widths and dashes: one meaning per colour in every pane and figure (Okabe-Ito, safe for
// colour-blind eyes), dark and light, on a desk and on a projector.
#pragma once

#include <cstdint>
#include <vector>

#include "painting/drawing.h"
#include "relief/messages.h"

namespace reliefui {

struct Rgba {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;
    bool operator==(const Rgba&) const = default;
};

// Opacity of the plate under a label that is drawn faintly.
inline constexpr std::uint8_t kFaintPlate = 150;

enum class Theme : std::uint8_t { Dark, Light };
enum class HeightColors : std::uint8_t { Grey, Cividis };

struct Stroke {
    Rgba color;
    double width = 1;          // pixels
    std::vector<double> dash;  // on, off, ... in pixels; empty: solid
};

inline constexpr double kPointsPerInch = 72;

struct Style {
    Theme theme = Theme::Dark;
    bool projector = false;
    double projectorScale = 1.8;  // of everything that is measured in points, on a projector
    relief::Language language = relief::Language::English;
    HeightColors heights = HeightColors::Grey;
    double screenPixelsPerPoint = 96.0 / kPointsPerInch;

    bool operator==(const Style&) const = default;

    // A point on this screen; a projector enlarges everything that is measured in points.
    double pixelsPerPoint() const { return screenPixelsPerPoint * scale(); }
    double scale() const { return projector ? projectorScale : 1.0; }
    double textPixels(double size = 1) const { return kTextPoints * size * pixelsPerPoint(); }

    Rgba background() const;
    Rgba text() const;
    Rgba color(Role role) const;
    // Around a disc; it must not cover a small one.
    static constexpr Rgba rim() { return {0, 0, 0, 210}; }
    static constexpr double rimWidth(double width, double radius) { return std::min(width, 0.3 * radius); }
    Rgba halo() const;  // what is drawn around marks, so that they are seen on any ground
    Stroke stroke(Role role, Emphasis emphasis) const;
    Stroke stroke(const Item& item) const;  // with its tint
    Rgba fill(Role role, Emphasis emphasis) const;
    // With its tint.
    Rgba color(const Item& item) const;
    Rgba fill(const Item& item) const;
    // Black or white, whichever is read better on this ground.
    static Rgba textOn(Rgba ground);

    // The colour of a line that stands for a level: the part of the level map that is seen on this background.
    Rgba levelLine(const LevelTint& tint) const;
    // Of a thing compared with others, of a stream of pixels: no colour of one is one of the other.
    Rgba series(int number) const;
    Rgba stream(int number) const;

    // t in [0, 1], clamped; NaN is shown as no colour of the map.
    Rgba mapped(ColorMap map, double t) const;
    // Of a value, or a mark of its map.
    Rgba cell(ColorMap map, double value, const ColorScale& scale) const;
    // Of all values up to a threshold.
    static Rgba under(ColorMap map);

    static constexpr double kTextPoints = 10;
};

}  // namespace reliefui
