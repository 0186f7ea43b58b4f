// Random numbers and rays for measurements and tests: seeded, and the same on every machine and compiler.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// splitmix64 (Steele, Lea, Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }
    // Uniform in [0, 1).
    double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    // Uniform in [0, n), n > 0.
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

  private:
    std::uint64_t state_;
};

// Returns a seed that depends on both arguments: streams for different purposes do not overlap in practice.
inline std::uint64_t seedFor(std::uint64_t seed, std::uint64_t purpose) {
    Random random(seed ^ (purpose * 0xd1342543de82ef95ULL));
    return random.bits();
}

// Returns a ray whose entry is uniform over the picture, with uniform azimuth and with elevation uniform in
// [lowestElevation, 90] degrees over a slab of reliefDepth texture widths.
inline ViewRay randomRay(Random& random, const HeightField& field, double lowestElevation) {
    const double azimuth = random.between(0, 2 * std::numbers::pi);
    const double elevation = random.between(lowestElevation, 90) * std::numbers::pi / 180;
    const double run = field.slabTexels() / std::tan(elevation);
    return {random.between(0, field.width()), random.between(0, field.height()), run * std::cos(azimuth),
            run * std::sin(azimuth)};
}

inline RayBlock randomRays(std::uint64_t seed, const HeightField& field, std::size_t count, double lowestElevation) {
    Random random(seed);
    RayBlock rays(count);
    for (std::size_t i = 0; i < count; ++i) rays.set(i, randomRay(random, field, lowestElevation));
    return rays;
}

}  // namespace relief
