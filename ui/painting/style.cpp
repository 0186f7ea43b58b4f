#include "painting/style.h"

#include <array>
#include <cmath>
#include <span>

#include "painting/iso_lines.h"

namespace reliefui {

namespace {

constexpr Rgba kBlack{0, 0, 0, 255};
constexpr Rgba kWhite{255, 255, 255, 255};
// Colour-blind safe palette (Okabe and Ito 2008).
constexpr Rgba kOrange{0xE6, 0x9F, 0x00, 255};
constexpr Rgba kSkyBlue{0x56, 0xB4, 0xE9, 255};
constexpr Rgba kBlueGreen{0x00, 0x9E, 0x73, 255};
constexpr Rgba kYellow{0xF0, 0xE4, 0x42, 255};
constexpr Rgba kVermilion{0xD5, 0x5E, 0x00, 255};
constexpr Rgba kReddishPurple{0xCC, 0x79, 0xA7, 255};
constexpr Rgba kBlue{0x00, 0x72, 0xB2, 255};
constexpr Rgba kMissGrey{0x99, 0x99, 0x99, 255};

// Sample colours of cividis (Nunez, Anderton, Renslow 2018), uniformly spaced.
constexpr std::array<Rgba, 10> kCividis{{{0x00, 0x22, 0x4E, 255},
                                         {0x12, 0x35, 0x70, 255},
                                         {0x3B, 0x49, 0x6C, 255},
                                         {0x57, 0x5D, 0x6D, 255},
                                         {0x70, 0x71, 0x73, 255},
                                         {0x8A, 0x86, 0x78, 255},
                                         {0xA5, 0x9C, 0x74, 255},
                                         {0xC3, 0xB3, 0x69, 255},
                                         {0xE1, 0xCC, 0x55, 255},
                                         {0xFE, 0xE8, 0x38, 255}}};
constexpr std::array<Rgba, 2> kGrey{{{0x10, 0x10, 0x10, 255}, {0xF8, 0xF8, 0xF8, 255}}};
// Pyramid levels: one hue, from fine (light) to coarse (dark blue); the middle has the mean of the ends' lightness.
constexpr std::array<Rgba, 3> kLevels{{{0xDE, 0xEB, 0xF7, 255}, {0x42, 0x92, 0xC6, 255}, {0x08, 0x30, 0x6B, 255}}};

// Diverging around white, safe for colour-blind eyes.
constexpr std::array<Rgba, 5> kAroundZero{
    {{0x7A, 0x43, 0x06, 255}, {0xD9, 0xA4, 0x5B, 255}, kWhite, {0x74, 0xAD, 0xD8, 255}, {0x14, 0x4E, 0x94, 255}}};

// Signed errors, from the smallest to the largest: short of the surface, past it.
constexpr std::array<Rgba, 4> kShortOf{
    {{0x0C, 0x35, 0x66, 255}, {0x1B, 0x6C, 0xAB, 255}, {0x4D, 0xA8, 0xE0, 255}, {0xA8, 0xDC, 0xFF, 255}}};
constexpr std::array<Rgba, 4> kPast{
    {{0x5C, 0x28, 0x06, 255}, {0xA8, 0x4C, 0x08, 255}, {0xE8, 0x8A, 0x1C, 255}, {0xFF, 0xD3, 0x8C, 255}}};
// Colour of values up to a threshold: darker than the first colour of every sequential map.
constexpr Rgba kUnder{0x14, 0x0C, 0x18, 255};

Rgba between(std::span<const Rgba> anchors, double t) {
    const double place = t * static_cast<double>(anchors.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double f = place - static_cast<double>(low);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
    };
    const Rgba& p = anchors[low];
    const Rgba& q = anchors[low + 1];
    return {mix(p.r, q.r), mix(p.g, q.g), mix(p.b, q.b), 255};
}

}  // namespace

Rgba Style::background() const {
    return theme == Theme::Dark ? Rgba{0x1E, 0x20, 0x24, 255} : kWhite;
}

Rgba Style::text() const {
    return theme == Theme::Dark ? Rgba{0xEC, 0xEC, 0xEC, 255} : Rgba{0x18, 0x18, 0x18, 255};
}

Rgba Style::halo() const {
    return theme == Theme::Dark ? Rgba{0, 0, 0, 200} : Rgba{255, 255, 255, 220};
}

Rgba Style::color(Role role) const {
    const bool dark = theme == Theme::Dark;
    switch (role) {
        case Role::Ray:
            return kVermilion;
        case Role::Skipped:
        case Role::Empty:
            return kBlueGreen;
        case Role::Descended:
        case Role::Ascended:
            return kSkyBlue;
        case Role::Tested:
            return kOrange;
        case Role::Refined:
            return kYellow;
        case Role::Searched:
            return kBlue;
        case Role::Neighbour:
            return kSkyBlue;
        case Role::Weight:
            return kYellow;
        case Role::Blocker:
            return kVermilion;
        case Role::Overshoot:
        case Role::Hidden:
            return kReddishPurple;
        case Role::Miss:
            return kMissGrey;
        case Role::Limit:
        case Role::Hit:
        case Role::Highlight:
        case Role::Footprint:
        case Role::PixelCircle:
            return dark ? kWhite : kBlack;
        case Role::Start:
        case Role::Advanced:
            return dark ? Rgba{0xC8, 0xC8, 0xC8, 255} : Rgba{0x50, 0x50, 0x50, 255};
        case Role::Frame:
            return dark ? Rgba{0x70, 0x74, 0x7A, 255} : Rgba{0x90, 0x90, 0x90, 255};
        case Role::Grid:
            return Rgba{0x80, 0x80, 0x80, 110};
        case Role::Surface:
            return dark ? Rgba{0xD2, 0xD2, 0xD2, 255} : Rgba{0x3C, 0x3C, 0x3C, 255};
        case Role::Layer:
            return dark ? Rgba{0xA0, 0xA4, 0xAA, 255} : Rgba{0x70, 0x74, 0x7A, 255};
        case Role::Sample:
            return dark ? Rgba{0xEC, 0xEC, 0xEC, 255} : Rgba{0x20, 0x20, 0x20, 255};
        case Role::IsoLine:
            return dark ? Rgba{0xF4, 0xF4, 0xF4, 255} : Rgba{0x18, 0x18, 0x18, 255};
        case Role::Plateau:
            return levelLine({});
        case Role::Series:
        case Role::SeriesDashed:
            return series(0);
        case Role::Stream:
            return stream(0);
        case Role::Background:
            return background();
        case Role::HeightFill:
            return dark ? Rgba{0x8A, 0x8A, 0x8A, 255} : Rgba{0xB8, 0xB8, 0xB8, 255};
        case Role::Label:
        case Role::Legend:
        case Role::Title:
        case Role::Count:
            return text();
    }
    return text();
}

Stroke Style::stroke(Role role, Emphasis emphasis) const {
    // Lines are tripled on a projector: a factor of 1.8 comes from its larger points, the rest from here.
    const double unit = screenPixelsPerPoint * (projector ? 3.0 : 1.0);
    double width = 1.1;
    std::vector<double> dash;
    switch (role) {
        case Role::Ray:
            width = 1.6;
            break;
        case Role::Highlight:
            width = 2.2;
            break;
        case Role::Hit:
            width = 1.6;
            break;
        case Role::Grid:
        case Role::Frame:
        case Role::Layer:
        case Role::Sample:
        case Role::IsoLine:
            width = 0.6;
            break;
        case Role::Empty:
            width = 1.4;
            break;
        case Role::Footprint:
        case Role::Hidden:
            width = 1.7;
            break;
        case Role::PixelCircle:
            width = 1.2;
            dash = {4, 2.5};
            break;
        case Role::Weight:
            width = 0.8;
            break;
        case Role::Ascended:
        case Role::Miss:
            dash = {3, 2.2};
            break;
        case Role::Plateau:
        case Role::Series:
            width = 1.5;
            break;
        case Role::SeriesDashed:
            width = 1.5;
            dash = {5, 3};
            break;
        case Role::Overshoot:
            dash = {5, 2};
            break;
        default:
            break;
    }
    if (emphasis == Emphasis::Strong) width *= 1.8;
    if (emphasis == Emphasis::Faint) width *= 0.7;
    Stroke stroke{color(role), std::max(1.0, width * unit), {}};
    if (emphasis == Emphasis::Faint) stroke.color.a = static_cast<std::uint8_t>(stroke.color.a * 0.62);
    for (const double part : dash) stroke.dash.push_back(part * unit);
    return stroke;
}

Stroke Style::stroke(const Item& item) const {
    Stroke own = stroke(item.role, item.emphasis);
    if (item.role != Role::Plateau) {
        const std::uint8_t alpha = own.color.a;
        own.color = color(item);
        own.color.a = alpha;
        return own;
    }
    const std::uint8_t alpha = own.color.a;
    own.color = levelLine(item.tint);
    own.color.a = alpha;
    // Coarse levels have wider lines, so that they stay visible under a fine level of the same height.
    constexpr double kWider = 1.0;
    const auto* const patch = std::get_if<Rectangle>(&item.primitive);
    if (patch == nullptr || !patch->fill) own.width *= 1 + kWider * item.tint.level / std::max(item.tint.levels - 1, 1);
    return own;
}

Rgba Style::series(int number) const {
    const std::array<Rgba, 4> colors{kVermilion, kMissGrey, kReddishPurple, theme == Theme::Dark ? kWhite : kBlack};
    return colors[static_cast<std::size_t>(number) % colors.size()];
}

Rgba Style::stream(int number) const {
    const bool dark = theme == Theme::Dark;  // yellow has little contrast on white, blue on black
    const std::array<Rgba, 5> colors{kSkyBlue, kOrange, kBlueGreen, dark ? kYellow : kBlue, dark ? kBlue : kYellow};
    return colors[static_cast<std::size_t>(number) % colors.size()];
}

Rgba Style::color(const Item& item) const {
    if (item.role == Role::Plateau) return levelLine(item.tint);
    if (item.role == Role::Series || item.role == Role::SeriesDashed) return series(item.tint.level);
    if (item.role == Role::Stream) return stream(item.tint.level);
    // The background of iso-lines, a height map, does not change with the theme.
    if (item.role == Role::IsoLine && item.tint.level == kLightLine) return {0xF4, 0xF4, 0xF4, 255};
    if (item.role == Role::IsoLine && item.tint.level == kDarkLine) return {0x18, 0x18, 0x18, 255};
    return color(item.role);
}

Rgba Style::fill(const Item& item) const {
    Rgba own = color(item);
    own.a = fill(item.role, item.emphasis).a;
    return own;
}

Rgba Style::levelLine(const LevelTint& tint) const {
    // The ends of the map are nearly white and nearly black; only the part with enough contrast to the background is
    // used.
    constexpr double kDarkFrom = 0.08;
    constexpr double kDarkTo = 0.62;
    constexpr double kLightFrom = 0.40;
    constexpr double kLightTo = 1.0;
    const double t = tint.levels > 1 ? static_cast<double>(tint.level) / (tint.levels - 1) : 0.0;
    const bool dark = theme == Theme::Dark;
    const double from = dark ? kDarkFrom : kLightFrom;
    return mapped(ColorMap::Level, from + t * ((dark ? kDarkTo : kLightTo) - from));
}

Rgba Style::fill(Role role, Emphasis emphasis) const {
    Rgba fill = color(role);
    if (emphasis == Emphasis::Normal) fill.a = 96;
    if (emphasis == Emphasis::Faint) fill.a = 48;
    return fill;
}

Rgba Style::textOn(Rgba ground) {
    const double luma = 0.299 * ground.r + 0.587 * ground.g + 0.114 * ground.b;
    return luma > 140 ? Rgba{0x10, 0x10, 0x10, 255} : Rgba{0xF4, 0xF4, 0xF4, 255};
}

Rgba Style::under(ColorMap map) {
    return map == ColorMap::Difference ? kWhite : kUnder;
}

Rgba Style::cell(ColorMap map, double value, const ColorScale& scale) const {
    if (map == ColorMap::Picture) {
        const auto code = static_cast<std::uint32_t>(std::clamp(value, 0.0, 16777215.0));
        const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(code >> shift & 0xFFU); };
        return {byte(16), byte(8), byte(0), 255};
    }
    const bool marks = map == ColorMap::Distance || map == ColorMap::Difference;
    if (marks && std::isnan(value)) return color(Role::HeightFill);
    if (map == ColorMap::Distance && value < 0) return color(Role::Tested);
    if (scale.under(value)) return under(map);
    return mapped(map, scale.place(value));
}

Rgba Style::mapped(ColorMap map, double t) const {
    if (std::isnan(t)) return {0xCC, 0x00, 0xCC, 255};
    const double clamped = std::clamp(t, 0.0, 1.0);
    switch (map) {
        case ColorMap::Level:
            return between(kLevels, clamped);
        case ColorMap::Count:
        case ColorMap::Distance:
            return between(kCividis, clamped);
        case ColorMap::Difference:
            return between(kAroundZero, clamped);
        case ColorMap::Signed:
            return clamped < 0.5 ? between(kShortOf, 1 - 2 * clamped) : between(kPast, 2 * clamped - 1);
        case ColorMap::Height:
        case ColorMap::Picture:
            break;
    }
    return heights == HeightColors::Cividis ? between(kCividis, clamped) : between(kGrey, clamped);
}

}  // namespace reliefui
