// Inside elliptical_lanes.cpp, compiled once, not for others: what all instruction sets are given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "filtering/elliptical_options.h"
#include "filtering/footprint_log.h"
#include "filtering/lane_levels.h"

namespace relief {

inline constexpr std::size_t kMostLanes = 16;
inline constexpr std::size_t kLanePixels = 64;

// 2^x on [-1/2, 1/2]: minimax, relative error 2.6e-6, a third of what 16-bit levels are off by.
inline constexpr std::array<float, 5> kExp2{0.99999926F, 0.69312181F, 0.24024745F, 0.05591786F, 0.0095701F};
// The same, relative error 2e-7: its terms, of which seven suffice.
inline constexpr std::array<float, 7> kPreciseExp2{1.0F,           0.693147181F,   0.240226507F,   0.0555041087F,
                                                   0.00961812911F, 0.00133335581F, 0.000154035304F};
// Of a Gaussian's rim, to the base 2, negative: up to it ratios of neighbouring weights are far from over- and
// underflow.
inline constexpr float kMostRunExponent = 16;

// Texels of level 0, squared: major semi-axes below it are no footprint to speak of.
inline constexpr float kLeastSquare = 1e-12F;
// Texels of level 0: farther places have no fraction left, or no float holds the cells between.
inline constexpr double kFarthest = 1e12;
// Picture sizes: under clamp and border only the rim is seen from there, whatever the distance.
inline constexpr double kBeyond = 16;

struct LaneJob;

// Pixels of a chunk, in float; up to a whole vector of pixels that are not valid after the last.
struct LaneChunk {
    std::size_t count = 0;
    alignas(64) float ux[kLanePixels], vx[kLanePixels], uy[kLanePixels], vy[kLanePixels];  // texels of level 0
    alignas(64) std::int32_t wholeS[kLanePixels], wholeT[kLanePixels];                     // the texel of level 0
    alignas(64) float restS[kLanePixels], restT[kLanePixels];                              // in it
    alignas(64) float valid[kLanePixels];

    // The job's pixels from begin on, those before the from-th left as they are, and what follows the last. The
    // reference of fillChunk.
    void fill(const LaneJob& job, std::size_t begin, std::size_t from = 0);
};

// The settings, and a block's arrays.
struct LaneJob {
    const LaneLevels* levels = nullptr;
    WeightKind weights = WeightKind::Gaussian;
    std::int32_t top = 0;
    double width = 1, height = 1;
    float radius = 1, radiusSquare = 1;
    float exponent = 0;             // 1 / (2 sigma^2), to the base 2
    float perFloorSquare = 1;       //
    float perAnisotropySquare = 1;  //
    float leastMinorSquare = 0;     // texels of a level
    float mostSquare = 0, smallSquare = 0;
    LaneLevels::PerLevel<float> scale{}, texelTerm{};  // 2^-l; what is added to the semi-axes' squares

    const double *s = nullptr, *t = nullptr;
    const double *ux = nullptr, *vx = nullptr, *uy = nullptr, *vy = nullptr;
    std::array<const float*, 4> narrow{};  // the same, where ux is null: texels of level 0
    std::size_t count = 0;
    double perS = 1, perT = 1;
    Color* colors = nullptr;
    std::uint8_t* left = nullptr;
    FootprintLog* log = nullptr;
};

// Of the settings alone.
LaneJob laneJob(const LaneLevels& levels, const EllipticalSettings& settings);

}  // namespace relief
