// A frame is stages, each a buffer keyed by its inputs. This one table serves caching, light-only redraws, the layers
// of the result view and the ledger of what was not computed again.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "relief/messages.h"

namespace relief {

// What a frame depends on.
enum class Input : std::uint8_t {
    Size,            // of the picture
    Camera,          //
    Scene,           //
    HeightSize,      // of the height map (the polygon's aspect, texel units)
    Heights,         //
    Surface,         // bilinear or columns
    Address,         //
    Depth,           // relief_depth
    Method,          // and its options
    ColorPicture,    //
    Filter,          //
    NormalPicture,   //
    LightDirection,  //
    Light,           // its strength
    Shadows,         // whether they are wanted
    Sky,             //
    Mapping,         // how coordinates are made along rows
    Skip,            // whether lossless skipping is on
    Bounded,         // how much may be wrong by skipping
    Count
};
inline constexpr std::size_t kInputs = static_cast<std::size_t>(Input::Count);
inline constexpr std::array<std::string_view, kInputs> kInputNames{
    "size",    "camera", "scene",         "height size", "heights",        "surface",         "address",
    "depth",   "method", "color picture", "filter",      "normal picture", "light direction", "light",
    "shadows", "sky",    "mapping",       "skip",        "bounded"};

// Rays: which polygon covers the pixel, where the view ray enters its slab. Hits: where it meets the relief. Color:
// filtered colour at the hit, of what the pixel's footprint on the texture holds. Shadows: whether the light reaches
// it. Light: the picture.
enum class Stage : std::uint8_t { Rays, Hits, Color, Shadows, Light, Count };
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Count);
inline constexpr std::array<MessageId, kStages> kStageNames{
    MessageId::StageRays, MessageId::StageHits, MessageId::StageColor, MessageId::StageShadows, MessageId::StageLight};

struct StageRow {
    std::uint32_t inputs;  // bits of Input, read by this stage itself
    std::uint32_t stages;  // bits of Stage, whose buffers it reads
};

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

// All inputs on which a stage depends, through the stages before it, too.
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
