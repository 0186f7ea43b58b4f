// Segments in the slab in any direction, for shadows and back-tracing: is anything in the way? Another type than view
// rays, so that a map which is valid only for view rays cannot be asked about them.
//
// Frame: texel coordinates (s, t), heights z; the segment is (s, t, z) + mu (ds, dt, dz), mu in [0, 1].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "relief/ray.h"

namespace relief {

// A segment; may rise, fall, run level. s, t, ds, dt in texels, z and dz in heights (slab thicknesses); all finite.
struct AnyRay {
    double s = 0;
    double t = 0;
    double z = 1;
    double ds = 0;
    double dt = 0;
    double dz = 0;

    bool finite() const {
        return std::isfinite(s) && std::isfinite(t) && std::isfinite(z) && std::isfinite(ds) && std::isfinite(dt) &&
               std::isfinite(dz);
    }
    // The way over the map; mu takes the place of lambda.
    ViewRay course() const { return {s, t, ds, dt}; }
    double heightAt(double mu) const { return z + mu * dz; }
    bool operator==(const AnyRay&) const = default;
};

// Clear: nothing in the way (also under border, outside the picture). Limit: the segment was too long to be followed.
enum class Visibility : std::uint8_t { Clear, Blocked, Limit };

// By how much, in heights, the surface must rise above the segment to block it: so that the surface point from which a
// segment starts, and a plateau along which it runs, do not.
inline constexpr double kVisibilityClearance = 0x1p-30;

// Segments as a structure of arrays, all of one length.
struct AnyRayBlock {
    std::vector<double> s, t, z, ds, dt, dz;

    AnyRayBlock() = default;
    explicit AnyRayBlock(std::size_t count) { resize(count); }
    std::size_t size() const { return s.size(); }
    void resize(std::size_t count) {
        for (auto* column : {&s, &t, &z, &ds, &dt, &dz}) column->resize(count);
    }
    AnyRay operator[](std::size_t i) const { return {s[i], t[i], z[i], ds[i], dt[i], dz[i]}; }
    void set(std::size_t i, const AnyRay& ray) {
        s[i] = ray.s;
        t[i] = ray.t;
        z[i] = ray.z;
        ds[i] = ray.ds;
        dt[i] = ray.dt;
        dz[i] = ray.dz;
    }
    void push(const AnyRay& ray) {
        resize(size() + 1);
        set(size() - 1, ray);
    }
};

// Answers in the order of the segments. steps: decision records; reads: stored values fetched.
struct VisibilityBlock {
    std::vector<Visibility> visibility;
    std::vector<std::uint32_t> steps, reads;

    std::size_t size() const { return visibility.size(); }
    void resize(std::size_t count) {
        visibility.resize(count, Visibility::Clear);
        steps.resize(count, 0);
        reads.resize(count, 0);
    }
};

}  // namespace relief
