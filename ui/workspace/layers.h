// What the result view can show beside the colour, as pictures: steps, error against the exact tracer, outcome, depth,
// normals, texture coordinates, how oblong the pixels' footprints are and how much of them the relief hides.
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

// values: of the layers of numbers (steps; texels, of the error below 0 where the answer is short of the exact hit;
// texture widths; ratio of the axes; percent), NaN where there is none; spread: the same numbers, but of the error's
// those alone that are not exact; ends: what all of them span. range: how they are shown, scale: what it comes to.
// outcomes: pixels that are sky, hit, miss, step limit. error: of the error layer only.
// planes: of the footprint's layers, for reading values out. applies: false where the filter knows nothing of what the
// layer shows.
struct LayerPicture {
    Layer layer = Layer::Color;
    QImage image;
    std::shared_ptr<const relief::FloatImage> values;
    std::shared_ptr<const ValueSpread> spread;
    ScaleEnds ends;
    ColorRange range;
    ColorScale scale;
    int hatch = 0;  // pixels between the lines of hatches
    std::array<std::int64_t, 4> outcomes{};
    std::shared_ptr<const relief::ErrorLayer> error;
    std::shared_ptr<const std::vector<relief::NamedPlane>> planes;
    bool applies = true;
};
// The range that a layer of numbers has; none: the layer is one of colours.
std::optional<RangeOf> rangeOf(Layer layer);
ColorMap colorMapOf(Layer layer);

// Colours of the outcomes, in the order of relief::Outcome; misses and limits carry a hatch as well.
inline constexpr std::array<std::uint32_t, 4> kOutcomeColors{0xff2b3038, 0xfff4f4f4, 0xff999999, 0xff000000};
// Hatches have a line every so many pixels; more in pictures that are enlarged for a page, where they would be grey.
inline constexpr int kHatch = 6;
// Whether the hatch of this outcome covers the pixel.
bool outcomeHatched(relief::Outcome outcome, int x, int y, int hatch = kHatch);

// The error's colours: no error at all, an answer of another kind (with a hatch). Errors short of the exact hit and
// past it have the two sides of ColorMap::Signed.
inline constexpr std::uint32_t kNoError = 0xff0a0b0e;
inline constexpr std::uint32_t kWrongOutcome = 0xfff4f4f4;
// Texels below which errors are not told apart.
inline constexpr double kLeastError = 1e-3;
// Larger ratios of the axes share a colour.
inline constexpr double kLargestAnisotropy = 1024;
// Of the planes of an anisotropy layer; NaN where nothing was hit.
double anisotropy(const std::vector<relief::NamedPlane>& planes, int x, int y);
bool wrongOutcomeMarked(int x, int y, int hatch = kHatch);

// Frames are big: to be called on the worker's thread. The error traces the frame once more; throws Cancelled.
// enlarged: how many times as large as on the screen the picture is: hatches are as much coarser.
LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work, double enlarged = 1);
// Paints a layer of numbers anew; of any other layer nothing changes.
void colorLayer(LayerPicture& layer, const ColorRange& range);

}  // namespace reliefui
