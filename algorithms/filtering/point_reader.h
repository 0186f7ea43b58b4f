// Colours of points with small footprints, for pixels that are the mean of many points: a level chosen by the
// footprint's minor axis, and a few bilinear taps along the major one. Cheaper than all texels of an ellipse, and
// accurate enough for a part of a pixel.
//
// The footprint's Gaussian has the covariance J J^T, in texels^2 of level 0. A bilinear tap on level l has a variance
// of about 4^l / 4; the rest of the major axis' variance is distributed over the taps, which are equally spaced and
// equally weighted.
//
// If LaneLevels are given, one point per lane is processed in SIMD on 16-bit levels; the bits are the same on every
// instruction set and do not depend on the other points. color() is the reference. Points that are not finite, and
// points near the narrow last texel of a level, fall back to it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "filtering/footprint_log.h"
#include "filtering/lane_levels.h"
#include "mapping/footprint.h"

namespace relief {

inline constexpr int kMostTaps = 8;

// Points and their footprints, in texels of level 0. The columns are at least kPointSlack longer than the number of
// points.
inline constexpr std::size_t kPointSlack = 16;
struct PointBlock {
    std::vector<double> s, t;
    std::vector<float> ux, vx, uy, vy;

    std::size_t size() const { return count_; }
    // Keeps the contents; the columns never become shorter.
    void resize(std::size_t count) {
        count_ = count;
        const std::size_t least = count + kPointSlack;
        if (s.size() >= least) return;
        for (auto* column : {&s, &t}) column->resize(least);
        for (auto* column : {&ux, &vx, &uy, &vy}) column->resize(least);
    }
    void set(std::size_t i, glm::dvec2 place, const Jacobian& j) {
        s[i] = place.x, t[i] = place.y;
        ux[i] = static_cast<float>(j.ux), vx[i] = static_cast<float>(j.vx);
        uy[i] = static_cast<float>(j.uy), vy[i] = static_cast<float>(j.vy);
    }
    Jacobian jacobian(std::size_t i) const { return {ux[i], vx[i], uy[i], vy[i]}; }

  private:
    std::size_t count_ = 0;
};

// Red, green, blue and 1 for a point with a hit; otherwise all 0.
struct alignas(16) PointColor {
    float channel[4] = {0, 0, 0, 0};
};

// The taps of a point: at centre + (n - (count - 1) / 2) step for n in [0, count).
struct PointTaps {
    int level = 0;
    int count = 1;
    glm::dvec2 step{0};  // texels of level 0

    glm::dvec2 offset(int n) const { return (n - 0.5 * (count - 1)) * step; }
};

class PointReader {
  public:
    // lanes: may be null; then only the reference is used.
    PointReader(std::shared_ptr<const ColorLevels> levels, Address address, std::shared_ptr<const LaneLevels> lanes)
        : levels_(std::move(levels)), address_(address), lanes_(std::move(lanes)) {}

    const ColorLevels& levels() const { return *levels_; }
    Address address() const { return address_; }
    // Writes the colour of each point to colors[its slot]. counts: only texels. Thread-safe.
    void read(const PointBlock& points, std::span<const std::uint32_t> slots, PointColor* colors,
              FootprintCounts& counts) const;
    Color color(glm::dvec2 place, const PointTaps& taps) const;
    PointTaps taps(const Jacobian& j) const;

  private:
    std::shared_ptr<const ColorLevels> levels_;
    Address address_;
    std::shared_ptr<const LaneLevels> lanes_;
};

}  // namespace relief
