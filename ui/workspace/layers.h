// Layers that the result view can show instead of the colour, as pictures: steps, error against the exact tracer,
// outcome, depth, normals, texture coordinates, anisotropy of the footprints, share of the footprints hidden by the
// relief.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>

#include "painting/drawing.h"
#include "relief/files.h"
#include "rendering/error_layer.h"

namespace reliefui {

enum class Layer : std::uint8_t { Color, Steps, Error, Outcome, Depth, Normals, TexturePlace, Anisotropy, Hidden };
inline constexpr int kLayers = 9;

// A rendered layer.
// values: of numeric layers; NaN where a pixel has no value. Units: steps; texels for the error, negative if the result
// is short of the exact hit; texture widths; ratio of the axes; percent.
// spread: statistics of the values; for the error layer only of the inexact ones. ends: full range of the values.
// range: how the user wants them shown; scale: the resulting mapping.
// outcomes: numbers of pixels that are sky, hit, miss, step limit. error: set for the error layer only.
// planes: of the footprint layers, for reading out values. applies: false if the filter does not provide what the layer
// shows.
struct LayerPicture {
    Layer layer = Layer::Color;
    QImage image;
    std::shared_ptr<const relief::FloatImage> values;
    std::shared_ptr<const ValueSpread> spread;
    ScaleEnds ends;
    ColorRange range;
    ColorScale scale;
    int hatch = 0;  // distance between hatch lines, in pixels
    std::array<std::int64_t, 4> outcomes{};
    std::shared_ptr<const relief::ErrorLayer> error;
    std::shared_ptr<const std::vector<relief::NamedPlane>> planes;
    bool applies = true;
};
// The colour range used by a numeric layer; std::nullopt for layers of colours.
std::optional<RangeOf> rangeOf(Layer layer);
ColorMap colorMapOf(Layer layer);

// Colours of the outcomes, in the order of relief::Outcome. Misses and step limits are hatched as well.
inline constexpr std::array<std::uint32_t, 4> kOutcomeColors{0xff2b3038, 0xfff4f4f4, 0xff999999, 0xff000000};
// Distance between hatch lines, in pixels. It is larger in pictures enlarged for a page, where fine hatches would look
// grey.
inline constexpr int kHatch = 6;
// Returns true if a hatch line of this outcome covers the pixel.
bool outcomeHatched(relief::Outcome outcome, int x, int y, int hatch = kHatch);

// Special colours of the error layer: no error, and a wrong outcome (hatched). Other errors use ColorMap::Signed, one
// side for results short of the exact hit, the other for those past it.
inline constexpr std::uint32_t kNoError = 0xff0a0b0e;
inline constexpr std::uint32_t kWrongOutcome = 0xfff4f4f4;
// Errors below this, in texels, have the same colour.
inline constexpr double kLeastError = 1e-3;
// Ratios of the axes above this have the same colour.
inline constexpr double kLargestAnisotropy = 1024;
// Anisotropy (ratio of the footprint's axes) from the planes of an anisotropy layer; NaN for pixels without a hit.
double anisotropy(const std::vector<relief::NamedPlane>& planes, int x, int y);
bool wrongOutcomeMarked(int x, int y, int hatch = kHatch);

// Renders a layer. Call this on the worker's thread, because frames are large; the error layer traces the frame again.
// Throws Cancelled. enlarged: size of the picture relative to the screen; hatches are coarser by the same factor.
LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work, double enlarged = 1);
// Recolours a numeric layer by another range; other layers stay unchanged.
void colorLayer(LayerPicture& layer, const ColorRange& range);

}  // namespace reliefui
