// The footprint of a pixel computed from its definition, in long double and independently of the library: the ellipse
// from the eigenvectors of J J^T, membership tested texel by texel, levels as means of the picture's own texels,
// periodic copies one by one.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "filter_cases.h"

namespace relief::test::truth {

using Truth = long double;

struct Vector {
    Truth x = 0, y = 0;
};
inline Truth dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}

using Rgb = std::array<Truth, 3>;

inline int wrapped(long i, int size) {
    return static_cast<int>(((i % size) + size) % size);
}

// A texel of a level within a footprint: its unwrapped position, and its part inside the picture.
struct LevelTexel {
    int i = 0, j = 0;  // indices in its level
    Vector centre;     // in texels of the level
    Vector size;       // in texels of the level; below 1 at the end of a side that is not a multiple of 2^l
};

// A picture's mip levels, computed from their definition.
class Levels {
  public:
    Levels(const ColorImage& picture, Address address) : picture_(picture), address_(address) {}

    int top() const {
        int l = 0;
        while ((std::max(picture_.width(), picture_.height()) - 1) >> l > 0) ++l;
        return l;
    }
    const Rgb& texel(int l, int i, int j) const {
        const auto [found, fresh] = means_.try_emplace({l, i, j});
        if (!fresh) return found->second;
        Truth count = 0;
        for (int y = j << l; y < std::min((j + 1) << l, picture_.height()); ++y) {
            for (int x = i << l; x < std::min((i + 1) << l, picture_.width()); ++x) {
                for (std::size_t k = 0; k < 3; ++k) {
                    found->second[k] += static_cast<Truth>(picture_(x, y)[static_cast<int>(k)]);
                }
                ++count;
            }
        }
        for (Truth& mean : found->second) mean /= count;
        return found->second;
    }
    // Visits all texels of the level whose centres are within `half` of `centre`, row by row. With clamping the sides
    // must be multiples of 2^l; the texels of the rim are repeated without limit.
    template <class Visit>
    void around(int l, Vector centre, Vector half, const Visit& visit) const {
        const auto along = [&](int size, Truth middle, Truth reach) {
            const Truth texels = std::ldexp(Truth{1}, l), extent = size / texels;
            const int count = (size + (1 << l) - 1) >> l;
            std::vector<std::array<Truth, 3>> found;  // index, centre, size
            const auto take = [&](int i, Truth at, Truth width) {
                if (std::abs(at - middle) <= reach) found.push_back({static_cast<Truth>(i), at, width});
            };
            if (address_ == Address::Repeat) {
                const auto first = static_cast<long>(std::floor((middle - reach) / extent)) - 1;
                const auto last = static_cast<long>(std::ceil((middle + reach) / extent)) + 1;
                for (long copy = first; copy <= last; ++copy) {
                    for (int i = 0; i < count; ++i) {
                        const Truth from = i, to = std::min(i + Truth{1}, extent);
                        take(i, copy * extent + (from + to) / 2, to - from);
                    }
                }
            } else {
                const auto first = static_cast<long>(std::floor(middle - reach)) - 1;
                const auto last = static_cast<long>(std::ceil(middle + reach)) + 1;
                for (long i = first; i <= last; ++i) {
                    take(static_cast<int>(std::clamp<long>(i, 0, count - 1)), i + 0.5L, 1);
                }
            }
            return found;
        };
        const auto columns = along(picture_.width(), centre.x, half.x);
        for (const auto& [j, y, height] : along(picture_.height(), centre.y, half.y)) {
            for (const auto& [i, x, width] : columns) {
                visit(LevelTexel{static_cast<int>(i), static_cast<int>(j), {x, y}, {width, height}});
            }
        }
    }
    // Bilinear interpolation of level 0.
    Rgb bilinear(Vector place) const {
        const Truth x = place.x - 0.5L, y = place.y - 0.5L;
        const auto i = static_cast<long>(std::floor(x)), j = static_cast<long>(std::floor(y));
        const Truth u = x - i, v = y - j;
        Rgb sum{};
        for (int dj = 0; dj < 2; ++dj) {
            for (int di = 0; di < 2; ++di) {
                const Truth share = (di == 0 ? 1 - u : u) * (dj == 0 ? 1 - v : v);
                const Rgb& color = texel(0, addressed(i + di, picture_.width()), addressed(j + dj, picture_.height()));
                for (std::size_t k = 0; k < 3; ++k) sum[k] += share * color[k];
            }
        }
        return sum;
    }

  private:
    int addressed(long i, int size) const {
        return address_ == Address::Repeat ? wrapped(i, size) : static_cast<int>(std::clamp<long>(i, 0, size - 1));
    }

    const ColorImage& picture_;
    Address address_;
    mutable std::map<std::array<int, 3>, Rgb> means_;
};

// The filter's options, interpreted independently of the library (elliptical_options.h, level_footprint.h).
struct Settings {
    Truth radius = 2.5L * 0.53L, sigma = 0.53L, floor = 1.25L, anisotropy = 16;
    bool exhaustive = false, texelSize = true, shaped = false;
    // semi-axis on the level, in texels, below which the footprint is widened, or read as a shape
    Truth leastMinor = 0;
};
// A circle of radius sqrt(1/2) texels, plus a margin for rounding, contains a texel's centre wherever it lies.
inline constexpr Truth kCovering = 0.7072L;
// Semi-axis of the Gaussian, in texels, below which level 0 is read bilinearly.
inline constexpr Truth kSmallMajor = 0.4L;
// Variances of the bilinear reconstruction, in squared texels of level 0, and of a texel's own box, in squared texels
// of the level.
inline constexpr Truth kReconstruction = 0.25L, kBox = 1 / 12.0L;

enum class Kind { Ellipse, Bilinear, Shape, Top };

// A pixel's footprint on its level.
struct Footprint {
    Kind kind = Kind::Ellipse;
    int level = 0;
    bool tie = false;      // rounding may choose another level or kind
    Vector centre;         // in texels of the level
    Vector along, across;  // unit vectors of the major and minor axis
    Truth major, minor;    // of the circle of radius 1 pixel, in texels of the level, after widening
    Vector toPixel[2];     // directions of the axes in the pixel

    // Converts an offset in texels of the level to pixels from the centre.
    Vector pixel(Vector offset) const {
        const Truth p = dot(offset, along) / major, q = dot(offset, across) / minor;
        return {p * toPixel[0].x + q * toPixel[1].x, p * toPixel[0].y + q * toPixel[1].y};
    }
    // Returns r^2, in squared pixels.
    Truth square(Vector offset) const {
        const Truth p = dot(offset, along) / major, q = dot(offset, across) / minor;
        return p * p + q * q;
    }
    Vector halfExtents(Truth radius) const {
        return {radius * std::hypot(major * along.x, minor * across.x),
                radius * std::hypot(major * along.y, minor * across.y)};
    }
};

// j, place: in texels of level 0.
inline Footprint footprintOf(const Jacobian& j, glm::dvec2 place, const Settings& settings, int top) {
    constexpr Truth kTie = 1e-9L;
    const Truth ux = j.ux, vx = j.vx, uy = j.uy, vy = j.vy;
    const Truth uu = ux * ux + uy * uy, uv = ux * vx + uy * vy, vv = vx * vx + vy * vy;
    const Truth largest = (uu + vv) / 2 + std::sqrt((uu - vv) * (uu - vv) / 4 + uv * uv);
    Footprint f;
    f.along = uu >= vv ? Vector{largest - vv, uv} : Vector{uv, largest - uu};
    const Truth length = std::sqrt(dot(f.along, f.along));
    f.along = length > 0 ? Vector{f.along.x / length, f.along.y / length} : Vector{1, 0};
    f.across = {-f.along.y, f.along.x};
    const Truth major = std::sqrt(largest), minor = std::abs(ux * vy - uy * vx) / major;
    // J^T (axis), normalised: the direction of the axis in the pixel.
    const Vector axes[2] = {f.along, f.across};
    const Truth lengths[2] = {major, minor};
    for (int n = 0; n < 2; ++n) {
        f.toPixel[n] = {(ux * axes[n].x + vx * axes[n].y) / lengths[n], (uy * axes[n].x + vy * axes[n].y) / lengths[n]};
    }
    const Truth wide = settings.exhaustive ? minor : std::max(minor, major / settings.anisotropy);
    if (!settings.exhaustive && wide > settings.floor) {
        const Truth level = std::log2(wide / settings.floor);
        f.tie = std::abs(level - std::round(level)) < kTie;
        f.level = static_cast<int>(std::min<Truth>(top, std::floor(level)));
    }
    const Truth texels = std::ldexp(Truth{1}, f.level);
    f.centre = {place.x / texels, place.y / texels};
    if (f.level == top) {
        f.kind = Kind::Top;
        return f;
    }
    const auto onLevel = [&](Truth axis) {
        const Truth scaled = axis / texels;
        if (!settings.texelSize) return scaled;
        const Truth added = (kReconstruction / (texels * texels) - kBox) / (settings.sigma * settings.sigma);
        return std::sqrt(std::max(Truth{0}, scaled * scaled + added));
    };
    const Truth small = settings.texelSize ? kSmallMajor : kCovering / settings.radius;
    f.minor = onLevel(wide);
    f.major = onLevel(major);
    if (settings.shaped && f.minor < settings.leastMinor) {
        f.kind = Kind::Shape;
    } else if (!settings.shaped && f.level == 0 && major < small) {
        f.kind = Kind::Bilinear;
    } else {
        f.minor = std::max(f.minor, settings.leastMinor);
        f.major = std::max(f.major, f.minor);
    }
    f.tie = f.tie || std::abs(major - small) < kTie || std::abs(f.minor - settings.leastMinor) < kTie * f.minor;
    return f;
}

}  // namespace relief::test::truth
