// What the result view can show beside the colour, as pictures: steps, error against the exact tracer, outcome, depth,
// normals and texture coordinates of a frame.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <QImage>

#include "rendering/error_layer.h"

namespace reliefui {

enum class Layer : std::uint8_t { Color, Steps, Error, Outcome, Depth, Normals, TexturePlace };
inline constexpr int kLayers = 7;

// low and high: the values at the ends of the colour map (steps; texels; texture widths). The error's scale is
// logarithmic above `low`; what is smaller, above all zero, has a colour of its own. outcomes: pixels that are sky,
// hit, miss, step limit. error: of the error layer only.
struct LayerPicture {
    Layer layer = Layer::Color;
    QImage image;
    double low = 0;
    double high = 0;
    std::array<std::int64_t, 4> outcomes{};
    std::shared_ptr<const relief::ErrorLayer> error;
};

// Colours of the outcomes, in the order of relief::Outcome; misses and limits carry a hatch as well.
inline constexpr std::array<std::uint32_t, 4> kOutcomeColors{0xff2b3038, 0xfff4f4f4, 0xff999999, 0xff000000};
// Whether the hatch of this outcome covers the pixel.
bool outcomeHatched(relief::Outcome outcome, int x, int y);

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
bool overshootHatched(int x, int y);
bool wrongOutcomeMarked(int x, int y);

// Frames are big: to be called on the worker's thread. The error traces the frame once more; throws Cancelled.
LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work);

}  // namespace reliefui
