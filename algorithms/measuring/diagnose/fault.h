// The faults of a relief tracer that `relief diagnose` recognises, with their names in output and their descriptions.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "relief/messages.h"

namespace relief {

// Of the search along the ray:
// - MissedSpike: samples at points of the ray passed a thin feature.
// - StairSteps: the layers are so coarse that their steps show in the answers.
// - NoRefinement: the answer is the point where the search stopped, up to a step behind the surface.
// - UnsafeMap: a step of a distance or cone map led through the surface.
// - StepLimit: the tracer stopped after its largest number of steps, in front of the surface.
// - NoSearch: the height was read at the ray's entry alone (parallax offset).
// - OffsetLimiting: the ray's run was not divided by the view direction's height.
// - SelfShadowBias: the answers lie in front of the surface by a constant.
// Of conventions: the ray's direction (SwappedAxes, DirectionSign, TangentFrame, ReliefDepth), the place at which
// heights are read (HalfTexelShift, YFlipped, WrapAgainstClamp), or the heights (InvertedHeights, ZeroLevel, Terraces,
// MipLevel, HeightCurve: the values of an sRGB picture were converted, or not).
enum class Fault : std::uint8_t {
    MissedSpike,
    StairSteps,
    NoRefinement,
    UnsafeMap,
    SwappedAxes,
    DirectionSign,
    InvertedHeights,
    ZeroLevel,
    ReliefDepth,
    HalfTexelShift,
    YFlipped,
    WrapAgainstClamp,
    Terraces,
    MipLevel,
    OffsetLimiting,
    TangentFrame,
    StepLimit,
    SelfShadowBias,
    NoSearch,
    HeightCurve
};
inline constexpr std::array<std::string_view, 20> kFaultNames{
    "missed-spike",   "stair-steps",        "no-refinement",    "unsafe-map",   "swapped-axes",
    "direction-sign", "inverted-heights",   "zero-level",       "relief-depth", "half-texel-shift",
    "y-flipped",      "wrap-against-clamp", "8-bit-terraces",   "mip-level",    "offset-limiting",
    "tangent-frame",  "step-limit",         "self-shadow-bias", "no-search",    "height-curve"};
constexpr std::string_view faultName(Fault fault) {
    return kFaultNames[static_cast<std::size_t>(fault)];
}

// Returns a sentence with the likely cause, and one with the cure.
Message faultCause(Fault fault);
Message faultCure(Fault fault);

}  // namespace relief
