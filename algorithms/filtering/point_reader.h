// Colours of points with small footprints, for pixels that are the mean of many such: a level by the footprint's minor
// axis, bilinear, a few taps along the major one. Cheaper than an ellipse's texels, and no better than a part of a
// pixel needs.
//
// The footprint's Gaussian has the covariance J J^T, texels^2 of level 0. A bilinear tap on level l has about the
// variance 4^l / 4; what the major axis has beyond that is spread over the taps, evenly spaced and alike.
//
// In lanes of 16-bit levels, one point a lane, where lane levels are given; equal bits on every instruction set and in
// any company. color() is the reference: places that are not finite, and levels with a narrow last texel near it,
// are left to it.
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

// Texels of level 0; all columns of one length, at least kPointSlack longer than there are points.
inline constexpr std::size_t kPointSlack = 16;
struct PointBlock {
    std::vector<double> s, t;
    std::vector<float> ux, vx, uy, vy;

    std::size_t size() const { return count_; }
    // What was there stays; the columns never become shorter.
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

// Red, green, blue, and 1 where something was met; else all 0.
struct alignas(16) PointColor {
    float channel[4] = {0, 0, 0, 0};
};

// What is read for a point: taps at centre + (n - (count - 1) / 2) step.
struct PointTaps {
    int level = 0;
    int count = 1;
    glm::dvec2 step{0};  // texels of level 0

    glm::dvec2 offset(int n) const { return (n - 0.5 * (count - 1)) * step; }
};

class PointReader {
  public:
    // lanes: may be null.
    PointReader(std::shared_ptr<const ColorLevels> levels, Address address, std::shared_ptr<const LaneLevels> lanes)
        : levels_(std::move(levels)), address_(address), lanes_(std::move(lanes)) {}

    const ColorLevels& levels() const { return *levels_; }
    Address address() const { return address_; }
    // Each point's colour into colors[its slot]. counts: texels alone.
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
