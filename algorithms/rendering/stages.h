// A frame consists of stages, each a buffer that depends on certain inputs. This one table controls caching, redraws
// that change only the light, the layers of the result view and the ledger of skipped work.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "relief/messages.h"

namespace relief {

// The inputs of a frame.
enum class Input : std::uint8_t {
    Size,  // of the picture
    Camera,
    Scene,
    HeightSize,  // of the height map (determines the polygon's aspect and texel units)
    Heights,
    Surface,  // bilinear or columns
    Address,
    Depth,   // relief_depth
    Method,  // and its options
    ColorPicture,
    Filter,
    NormalPicture,
    LightDirection,
    Light,    // intensity and ambient part
    Shadows,  // on or off
    Sky,
    Mapping,  // how coordinates are computed along rows
    Skip,     // whether lossless skipping is on
    Bounded,  // error bound of approximate skipping
    Count
};
inline constexpr std::size_t kInputs = static_cast<std::size_t>(Input::Count);
inline constexpr std::array<std::string_view, kInputs> kInputNames{
    "size",    "camera", "scene",         "height size", "heights",        "surface",         "address",
    "depth",   "method", "color picture", "filter",      "normal picture", "light direction", "light",
    "shadows", "sky",    "mapping",       "skip",        "bounded"};

// Rays: the polygon that covers the pixel, and where the view ray enters its slab. Hits: where the ray meets the
// relief. Color: the colour at the hit, filtered over the pixel's footprint on the texture. Shadows: whether the light
// reaches the hit. Light: the picture.
enum class Stage : std::uint8_t { Rays, Hits, Color, Shadows, Light, Count };
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Count);
inline constexpr std::array<MessageId, kStages> kStageNames{
    MessageId::StageRays, MessageId::StageHits, MessageId::StageColor, MessageId::StageShadows, MessageId::StageLight};

struct StageRow {
    std::uint32_t inputs;  // bits of Input, read by this stage itself
    std::uint32_t stages;  // bits of Stage, whose buffers it reads
};

// Returns the bit of an input or stage in a set.
constexpr std::uint32_t bit(Input input) {
    return 1u << static_cast<unsigned>(input);
}
constexpr std::uint32_t bit(Stage stage) {
    return 1u << static_cast<unsigned>(stage);
}

inline constexpr std::array<StageRow, kStages> kStageTable{{
    {bit(Input::Size) | bit(Input::Camera) | bit(Input::Scene) | bit(Input::HeightSize) | bit(Input::Depth) |
         bit(Input::Mapping) | bit(Input::Skip),
     0},
    {bit(Input::Heights) | bit(Input::Surface) | bit(Input::Address) | bit(Input::Method) | bit(Input::Bounded),
     bit(Stage::Rays)},
    {bit(Input::ColorPicture) | bit(Input::Filter) | bit(Input::Address), bit(Stage::Rays) | bit(Stage::Hits)},
    {bit(Input::LightDirection) | bit(Input::Shadows) | bit(Input::NormalPicture) | bit(Input::Heights) |
         bit(Input::Surface) | bit(Input::Address) | bit(Input::Depth),
     bit(Stage::Rays) | bit(Stage::Hits)},
    {bit(Input::LightDirection) | bit(Input::Light) | bit(Input::Sky) | bit(Input::NormalPicture) |
         bit(Input::Heights) | bit(Input::Depth),
     bit(Stage::Rays) | bit(Stage::Hits) | bit(Stage::Color) | bit(Stage::Shadows)},
}};

// Returns all inputs on which a stage depends, including those of the stages before it.
constexpr std::uint32_t allInputs(Stage stage) {
    std::uint32_t inputs = 0;
    std::uint32_t stages = bit(stage);
    for (std::size_t s = kStages; s-- > 0;) {
        if ((stages & (1u << s)) == 0) continue;
        inputs |= kStageTable[s].inputs;
        stages |= kStageTable[s].stages;
    }
    return inputs;
}

}  // namespace relief
