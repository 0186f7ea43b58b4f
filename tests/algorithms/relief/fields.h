// Height maps and rays for the tests of the relief methods: seeded, the same everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "images/reliefs.h"
#include "relief/tracers.h"

namespace relief::test {

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
    double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

  private:
    std::uint64_t state_;
};

using Heights = std::shared_ptr<const FloatImage>;

inline Heights share(FloatImage image) {
    return std::make_shared<FloatImage>(std::move(image));
}

inline Heights randomHeights(int width, int height, std::uint64_t seed) {
    Random random(seed);
    FloatImage image(width, height);
    for (float& h : image.pixels()) h = static_cast<float>(random.unit());
    return share(std::move(image));
}

inline Heights constantHeights(int width, int height, float value) {
    return share(FloatImage(width, height, value));
}

// Entry uniform over the picture, azimuth uniform, elevation uniform in [lowest, 90] degrees over a slab of
// reliefDepth texture widths.
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

inline const std::vector<Surface>& allSurfaces() {
    static const std::vector<Surface> all{Surface::Bilinear, Surface::Columns};
    return all;
}
inline const std::vector<Address>& allAddresses() {
    static const std::vector<Address> all{Address::Repeat, Address::Clamp, Address::Border};
    return all;
}

inline std::string describe(const HeightField& field) {
    return std::to_string(field.width()) + " x " + std::to_string(field.height()) + " " +
           std::string(surfaceName(field.surface())) + " " + std::string(addressName(field.address())) + " depth " +
           numberText(field.reliefDepth());
}
inline std::string describe(const ViewRay& ray) {
    return numberText(ray.s0) + "," + numberText(ray.t0) + "," + numberText(ray.a) + "," + numberText(ray.b);
}

// A ray traced with everything logged.
struct Logged {
    Hit hit;
    std::vector<Step> steps;
};
inline Logged traceLogged(const Tracer& tracer, const ViewRay& ray) {
    Work work(1);
    RayBlock rays(1);
    rays.set(0, ray);
    HitBlock hits;
    StepLog log;
    tracer.trace(rays, hits, log, work);
    return {hits[0], std::move(log.steps)};
}

// The same bits, where NaN is equal to itself.
inline bool sameBits(const Hit& a, const Hit& b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.outcome == b.outcome && same(a.lambda, b.lambda) && same(a.s, b.s) && same(a.t, b.t);
}

}  // namespace relief::test
