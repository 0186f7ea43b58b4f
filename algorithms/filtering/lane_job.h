// Data that is common to all instruction sets: settings, constants and pixel buffers. Private to the SIMD code of this
// folder.
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

// 2^x on [-1/2, 1/2]: minimax polynomial with a relative error of 2.6e-6, a third of the error of 16-bit levels.
inline constexpr std::array<float, 5> kExp2{0.99999926F, 0.69312181F, 0.24024745F, 0.05591786F, 0.0095701F};
// 2^x on [-1/2, 1/2] with a relative error of 2e-7 (seven terms).
inline constexpr std::array<float, 7> kPreciseExp2{1.0F,           0.693147181F,   0.240226507F,   0.0555041087F,
                                                   0.00961812911F, 0.00133335581F, 0.000154035304F};
// Largest negative base-2 exponent at a Gaussian's rim for which the ratios of neighbouring weights are far from
// overflow and underflow.
inline constexpr float kMostRunExponent = 16;

// Texels of level 0, squared: footprints with a smaller major semi-axis count as degenerate.
inline constexpr float kLeastSquare = 1e-12F;
// Texels of level 0: coordinates farther out have no fractional bits left, or their cell numbers do not fit.
inline constexpr double kFarthest = 1e12;
// In picture sizes. Under clamp and border only the rim is visible at this distance, so farther coordinates are
// clamped.
inline constexpr double kBeyond = 16;

struct LaneJob;

// Pixels of a chunk in float. Behind the last pixel the arrays are padded with invalid pixels up to a whole vector.
struct LaneChunk {
    std::size_t count = 0;
    alignas(64) float ux[kLanePixels], vx[kLanePixels], uy[kLanePixels], vy[kLanePixels];  // texels of level 0
    alignas(64) std::int32_t wholeS[kLanePixels], wholeT[kLanePixels];                     // texel of level 0
    alignas(64) float restS[kLanePixels], restT[kLanePixels];                              // position in that texel
    alignas(64) float valid[kLanePixels];

    // Fills the chunk with the job's pixels from `begin` on, and the padding behind the last. Entries before `from` are
    // left unchanged. This is the reference of fillChunk().
    void fill(const LaneJob& job, std::size_t begin, std::size_t from = 0);
};

// The settings, and the arrays of a block.
struct LaneJob {
    const LaneLevels* levels = nullptr;
    WeightKind weights = WeightKind::Gaussian;
    std::int32_t top = 0;
    double width = 1, height = 1;
    float radius = 1, radiusSquare = 1;
    float exponent = 0;             // 1 / (2 sigma^2), to the base 2
    float perFloorSquare = 1;       //
    float perAnisotropySquare = 1;  //
    float leastMinorSquare = 0;     // texels of the level
    float mostSquare = 0, smallSquare = 0;
    LaneLevels::PerLevel<float> scale{}, texelTerm{};  // 2^-l; term added to the semi-axes' squares

    const double *s = nullptr, *t = nullptr;
    const double *ux = nullptr, *vx = nullptr, *uy = nullptr, *vy = nullptr;
    std::array<const float*, 4> narrow{};  // the same if ux is null: texels of level 0
    std::size_t count = 0;
    double perS = 1, perT = 1;
    Color* colors = nullptr;
    std::uint8_t* fallback = nullptr;
    FootprintLog* log = nullptr;
};

// Initialises the members that depend on the settings alone.
LaneJob laneJob(const LaneLevels& levels, const EllipticalSettings& settings);

}  // namespace relief
