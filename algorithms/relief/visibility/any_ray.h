// Segments within the slab in any direction, for visibility queries (shadows, footprints traced back). They have
// another type than view rays, so that a map which is valid only for view rays cannot be used for them.
//
// Frame: texel coordinates (s, t), heights z; the segment is (s, t, z) + mu (ds, dt, dz), mu in [0, 1].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "relief/ray.h"

namespace relief {

// A segment that may rise, fall or run level. s, t, ds, dt in texels, z and dz in heights (slab thicknesses); all
// finite.
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
    // The projection of the segment onto the map as a ray; mu takes the place of lambda.
    ViewRay course() const { return {s, t, ds, dt}; }
    double heightAt(double mu) const { return z + mu * dz; }
    bool operator==(const AnyRay&) const = default;
};

// Result of a visibility query. Clear: the segment is not blocked (also outside the picture under border). Limit: the
// segment was too long to be followed to its end.
enum class Visibility : std::uint8_t { Clear, Blocked, Limit };

// Height by which the surface must rise above a segment to block it. So neither the surface point at which a segment
// starts nor a plateau along which it runs blocks it.
inline constexpr double kVisibilityClearance = 0x1p-30;

// Segments as a structure of arrays of equal length.
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

// Results in the order of the segments. steps: number of decision records; reads: number of stored values fetched.
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
