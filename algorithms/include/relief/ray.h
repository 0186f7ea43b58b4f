// View rays in the relief slab, alone and in blocks, and what becomes of them.
//
// Frame: texel coordinates (s, t), texel (i, j) centred at (i + 1/2, j + 1/2); height z in [0, 1], z = 1 the top
// plane. A ray is parametrised by descent lambda = 1 - z: s = s0 + lambda a, t = t0 + lambda b.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace relief {

// Horizontal run, hypot(a, b) in texels, up to which tracers are exact; flatter rays keep the step bound and may answer
// Limit.
inline constexpr double kMaxRun = 1048576.0;

// A ray that descends: enters the top plane at (s0, t0), runs (a, b) texels a unit of descent; vertical: a = b = 0.
// Valid only for maps made for view rays from above or for any ray. All four finite.
struct ViewRay {
    double s0 = 0;
    double t0 = 0;
    double a = 0;
    double b = 0;

    bool finite() const { return std::isfinite(s0) && std::isfinite(t0) && std::isfinite(a) && std::isfinite(b); }
    bool operator==(const ViewRay&) const = default;
};

// A stretch of a ray that an outer method has left to an inner one: begins at, and tests, `in`.
struct Segment {
    double in = 0;
    double out = 1;
};

// Unset: this ray was never asked for (pixel without polygon).
enum class Outcome : std::uint8_t { Unset, Hit, Miss, Limit };

// lambda in [0, 1]; s, t unwrapped. Miss and Limit leave lambda, s, t NaN.
struct Hit {
    Outcome outcome = Outcome::Miss;
    double lambda = std::numeric_limits<double>::quiet_NaN();
    double s = std::numeric_limits<double>::quiet_NaN();
    double t = std::numeric_limits<double>::quiet_NaN();

    static Hit at(const ViewRay& ray, double lambda) {
        return {Outcome::Hit, lambda, ray.s0 + lambda * ray.a, ray.t0 + lambda * ray.b};
    }
    static Hit none(Outcome outcome) {
        Hit hit;
        hit.outcome = outcome;
        return hit;
    }
};

// Rays as a structure of arrays, all of one length.
struct RayBlock {
    std::vector<double> s0, t0, a, b;

    static constexpr std::size_t kBytes = 4 * sizeof(double);  // of a ray

    RayBlock() = default;
    explicit RayBlock(std::size_t count) { resize(count); }
    std::size_t size() const { return s0.size(); }
    void resize(std::size_t count) {
        for (auto* column : {&s0, &t0, &a, &b}) column->resize(count);
    }
    ViewRay operator[](std::size_t i) const { return {s0[i], t0[i], a[i], b[i]}; }
    void set(std::size_t i, const ViewRay& ray) {
        s0[i] = ray.s0;
        t0[i] = ray.t0;
        a[i] = ray.a;
        b[i] = ray.b;
    }
    void push(const ViewRay& ray) {
        resize(size() + 1);
        set(size() - 1, ray);
    }
};

// Hits as a structure of arrays, in the order of the rays. steps: decision records; reads: stored values fetched.
struct HitBlock {
    std::vector<Outcome> outcome;
    std::vector<double> lambda, s, t;
    std::vector<std::uint32_t> steps, reads;

    static constexpr std::size_t kBytes = sizeof(Outcome) + 3 * sizeof(double) + 2 * sizeof(std::uint32_t);  // of a hit

    HitBlock() = default;
    explicit HitBlock(std::size_t count) { resize(count); }
    std::size_t size() const { return outcome.size(); }
    void resize(std::size_t count) {
        outcome.resize(count, Outcome::Unset);
        for (auto* column : {&lambda, &s, &t}) column->resize(count, std::numeric_limits<double>::quiet_NaN());
        steps.resize(count, 0);
        reads.resize(count, 0);
    }
    Hit operator[](std::size_t i) const { return {outcome[i], lambda[i], s[i], t[i]}; }
    void set(std::size_t i, const Hit& hit) {
        outcome[i] = hit.outcome;
        lambda[i] = hit.lambda;
        s[i] = hit.s;
        t[i] = hit.t;
    }
};

// Answers that lie closer are one answer, texels: what texture coordinates may be wrong by without being seen.
inline constexpr double kSameAnswer = 1.0 / 256;

}  // namespace relief
