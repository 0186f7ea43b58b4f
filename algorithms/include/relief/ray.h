// View rays in the relief slab and their hits, as single values and in blocks.
//
// Frame: texel coordinates (s, t), where texel (i, j) has its centre at (i + 1/2, j + 1/2); height z in [0, 1], where z
// = 1 is the top plane. A ray is parametrised by its descent lambda = 1 - z: s = s0 + lambda a, t = t0 + lambda b.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace relief {

// Largest horizontal run, hypot(a, b) in texels, for which tracers are exact. Rays with a longer run keep the step
// bound but may answer Limit.
inline constexpr double kMaxRun = 1048576.0;

// A descending ray: enters the top plane at (s0, t0) and runs (a, b) texels from the top to the bottom of the slab;
// vertical: a = b = 0. All four numbers must be finite. Only maps made for view rays from above, or for any rays, may
// be used with it.
struct ViewRay {
    double s0 = 0;
    double t0 = 0;
    double a = 0;
    double b = 0;

    bool finite() const { return std::isfinite(s0) && std::isfinite(t0) && std::isfinite(a) && std::isfinite(b); }
    bool operator==(const ViewRay&) const = default;
};

// The lambda interval of a ray that an outer method passes to an inner one. It is closed at `in`: a hit at `in` counts.
struct Segment {
    double in = 0;
    double out = 1;
};

// Unset: the ray was never traced (a pixel without polygon). Limit: a step limit was reached.
enum class Outcome : std::uint8_t { Unset, Hit, Miss, Limit };

// The result of tracing a ray. lambda in [0, 1]; s, t: the ray's coordinates there, texels, not wrapped. For Miss and
// Limit, lambda, s and t are NaN.
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

// Rays as a structure of arrays of equal length.
struct RayBlock {
    std::vector<double> s0, t0, a, b;

    static constexpr std::size_t kBytes = 4 * sizeof(double);  // per ray

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

// Hits as a structure of arrays, in the order of the rays. steps: number of decision records; reads: number of stored
// values fetched.
struct HitBlock {
    std::vector<Outcome> outcome;
    std::vector<double> lambda, s, t;
    std::vector<std::uint32_t> steps, reads;

    static constexpr std::size_t kBytes = sizeof(Outcome) + 3 * sizeof(double) + 2 * sizeof(std::uint32_t);  // per hit

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

// Answers closer than this, texels, count as equal: an error of texture coordinates that is not visible.
inline constexpr double kSameAnswer = 1.0 / 256;

}  // namespace relief
