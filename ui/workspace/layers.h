// What the result view can show beside the colour: steps, outcome, depth and normals of a frame as pictures.
#pragma once

#include <array>
#include <cstdint>

#include <QImage>

#include "rendering/frame.h"

namespace reliefui {

enum class Layer : std::uint8_t { Color, Steps, Outcome, Depth, Normals };
inline constexpr int kLayers = 5;

// low and high: the values at the ends of the colour map (steps; texture widths). outcomes: pixels that are sky, hit,
// miss, step limit.
struct LayerPicture {
    Layer layer = Layer::Color;
    QImage image;
    double low = 0;
    double high = 0;
    std::array<std::int64_t, 4> outcomes{};
};

// Colours of the outcomes, in the order of relief::Outcome; misses and limits carry a hatch as well.
inline constexpr std::array<std::uint32_t, 4> kOutcomeColors{0xff2b3038, 0xfff4f4f4, 0xff999999, 0xff000000};
// Whether the hatch of this outcome covers the pixel.
bool outcomeHatched(relief::Outcome outcome, int x, int y);

// Frames are big: to be called on the worker's thread.
LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request);

}  // namespace reliefui
