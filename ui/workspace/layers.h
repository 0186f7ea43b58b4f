// What the result view can show beside the colour, as pictures: steps, error against the exact tracer, outcome, depth,
// normals, texture coordinates, how oblong the pixels' footprints are and how much of them the relief hides.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <QImage>

#include "relief/files.h"
#include "rendering/error_layer.h"

namespace reliefui {

enum class Layer : std::uint8_t { Color, Steps, Error, Outcome, Depth, Normals, TexturePlace, Anisotropy, Hidden };
inline constexpr int kLayers = 9;

// low and high: the values at the ends of the colour map (steps; texels; texture widths; ratio of the
// axes; share). The scales of error and anisotropy are logarithmic above `low`; of the error what is smaller, above all
// zero, has a colour of its own. outcomes: pixels that are sky, hit, miss, step limit. error: of the error layer only.
// planes: of the footprint's layers, for reading values out. applies: false where the filter knows nothing of what the
// layer shows.
struct LayerPicture {
    Layer layer = Layer::Color;
    QImage image;
    double low = 0;
    double high = 0;
    std::array<std::int64_t, 4> outcomes{};
    std::shared_ptr<const relief::ErrorLayer> error;
    std::shared_ptr<const std::vector<relief::NamedPlane>> planes;
    bool applies = true;
};

// Colours of the outcomes, in the order of relief::Outcome; misses and limits carry a hatch as well.
inline constexpr std::array<std::uint32_t, 4> kOutcomeColors{0xff2b3038, 0xfff4f4f4, 0xff999999, 0xff000000};
// Hatches have a line every so many pixels; more in pictures that are enlarged for a page, where they would be grey.
inline constexpr int kHatch = 6;
// Whether the hatch of this outcome covers the pixel.
bool outcomeHatched(relief::Outcome outcome, int x, int y, int hatch = kHatch);

// The error's colours: no error at all, an answer of another kind, the hatch of overshoots.
inline constexpr std::uint32_t kNoError = 0xff10243a;
inline constexpr std::uint32_t kWrongOutcome = 0xfff4f4f4;
inline constexpr std::uint32_t kOvershoot = 0xffcc79a7;
// Texels below which errors are not told apart.
inline constexpr double kLeastError = 1e-3;
// The darkest colours of the map are left to what has no error.
inline constexpr double kErrorFloor = 0.15;
// Place of an error on its map, in [0, 1].
double errorShare(const LayerPicture& layer, double texels);
// Larger ratios of the axes share a colour.
inline constexpr double kLargestAnisotropy = 1024;
// Of the planes of an anisotropy layer; NaN where nothing was hit.
double anisotropy(const std::vector<relief::NamedPlane>& planes, int x, int y);
bool overshootHatched(int x, int y, int hatch = kHatch);
bool wrongOutcomeMarked(int x, int y, int hatch = kHatch);

// Frames are big: to be called on the worker's thread. The error traces the frame once more; throws Cancelled.
// enlarged: how many times as large as on the screen the picture is: hatches are as much coarser.
LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work, double enlarged = 1);

}  // namespace reliefui
