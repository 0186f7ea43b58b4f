// Turns roles into colours, line widths and dashes: one meaning per colour in every pane and figure (Okabe-Ito, safe
// for colour-blind eyes), for dark and light themes, on a desk and on a projector.
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

// Opacity of the plate behind a label with faint emphasis.
inline constexpr std::uint8_t kFaintPlate = 150;

enum class Theme : std::uint8_t { Dark, Light };
enum class HeightColors : std::uint8_t { Grey, Cividis };

struct Stroke {
    Rgba color;
    double width = 1;          // pixels
    std::vector<double> dash;  // alternating on and off lengths, in pixels; empty: solid
};

inline constexpr double kPointsPerInch = 72;

struct Style {
    Theme theme = Theme::Dark;
    bool projector = false;
    double projectorScale = 1.8;  // factor for all sizes in points on a projector
    relief::Language language = relief::Language::English;
    HeightColors heights = HeightColors::Grey;
    double screenPixelsPerPoint = 96.0 / kPointsPerInch;

    bool operator==(const Style&) const = default;

    // Pixels per point on this screen, enlarged on a projector.
    double pixelsPerPoint() const { return screenPixelsPerPoint * scale(); }
    double scale() const { return projector ? projectorScale : 1.0; }
    double textPixels(double size = 1) const { return kTextPoints * size * pixelsPerPoint(); }

    Rgba background() const;
    Rgba text() const;
    Rgba color(Role role) const;
    // Colour of the outline of a disc, and its width, limited so that it does not cover a small disc.
    static constexpr Rgba rim() { return {0, 0, 0, 210}; }
    static constexpr double rimWidth(double width, double radius) { return std::min(width, 0.3 * radius); }
    Rgba halo() const;  // drawn around marks, so that they are visible on any background
    Stroke stroke(Role role, Emphasis emphasis) const;
    Stroke stroke(const Item& item) const;  // takes the item's tint into account
    Rgba fill(Role role, Emphasis emphasis) const;
    // As color(role), but takes the item's tint into account.
    Rgba color(const Item& item) const;
    Rgba fill(const Item& item) const;
    // Black or white, whichever has more contrast to this background.
    static Rgba textOn(Rgba ground);

    // Line colour of a pyramid level, from the part of the level map that is visible on this background.
    Rgba levelLine(const LevelTint& tint) const;
    // Colours of compared objects (series) and of pixel streams (stream); the two palettes have no colour in common.
    Rgba series(int number) const;
    Rgba stream(int number) const;

    // Colour at position t of the map, clamped to [0, 1]; NaN gives a colour that is not in the map.
    Rgba mapped(ColorMap map, double t) const;
    // Colour of a value, or of a mark of its map.
    Rgba cell(ColorMap map, double value, const ColorScale& scale) const;
    // Common colour of all values up to a threshold.
    static Rgba under(ColorMap map);

    static constexpr double kTextPoints = 10;
};

}  // namespace reliefui
