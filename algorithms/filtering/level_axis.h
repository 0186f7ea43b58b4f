// One axis of one level of a mean pyramid: which texel contains a coordinate, and where the texel's true centre is.
//
// Level l of a picture W texels wide has n = ceil(W / 2^l) texels over an extent of W / 2^l texels of that level. Where
// 2^l does not divide W, the last texel is narrower than one, with its centre and its share accordingly; under repeat
// the next copy of the picture begins at the extent, not at n.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "relief/addressing.h"

namespace relief {

struct LevelAxis {
    int size = 1;
    double extent = 1;
    Address address = Address::Repeat;

    static LevelAxis of(int size0, int level, Address address) {
        const int size = static_cast<int>((static_cast<std::int64_t>(size0) + (std::int64_t{1} << level) - 1) >> level);
        return {size, std::ldexp(size0, -level), address};
    }

    double lastShare() const { return extent - (size - 1); }
    // Centre of texel i in [0, size).
    double centre(int i) const { return i + 1 < size ? i + 0.5 : size - 1 + 0.5 * lastShare(); }
    // The equivalent coordinate in [0, extent) under repeat; unchanged otherwise.
    double reduced(double x) const {
        if (address != Address::Repeat || (x >= 0 && x < extent)) return x;
        const double rest = std::fmod(x, extent);
        return rest < 0 ? std::min(rest + extent, std::nextafter(extent, 0.0)) : rest;
    }

    // Calls visit(i, centre, share) for every texel whose centre lies in [low, high], in order; centres are unwrapped.
    // Under clamp and border the rim repeats without end. The interval may hold at most 2^31 texels.
    template <class Visit>
    void over(double low, double high, const Visit& visit) const {
        if (address != Address::Repeat) {
            const double last = centre(size - 1);
            for (double c = std::ceil(low - 0.5) + 0.5; c <= std::min(high, -0.5); c += 1) visit(0, c, 1.0F);
            overOne(low, high, 0, visit);
            const double from = last + std::max(1.0, std::ceil(low - last));
            for (double c = from; c <= high; c += 1) visit(size - 1, c, 1.0F);
            return;
        }
        for (double start = std::floor(low / extent) * extent; start <= high; start += extent) {
            overOne(low, high, start, visit);
        }
    }

    // The two texels whose centres enclose x, and the weight of the second one in [0, 1].
    BilinearSupport support(double x) const {
        const double in = address == Address::Repeat ? reduced(x) : std::clamp(x, -1.0, extent + 1.0);
        const double last = centre(size - 1);
        if (address != Address::Repeat) {
            if (in <= centre(0)) return {0, 0, 0};
            if (in >= last) return {size - 1, size - 1, 0};
        } else if (in < 0.5 || in >= last) {
            // Across the seam: from the last centre to the first one of the next copy.
            const double from = in >= last ? in - last : in + extent - last;
            const double width = extent - last + centre(0);
            return {size - 1, 0, static_cast<float>(std::clamp(from / width, 0.0, 1.0))};
        }
        const int first = std::min(static_cast<int>(in - 0.5), size - 2);
        const double width = centre(first + 1) - centre(first);
        return {first, first + 1, static_cast<float>(std::clamp((in - centre(first)) / width, 0.0, 1.0))};
    }

  private:
    template <class Visit>
    void overOne(double low, double high, double start, const Visit& visit) const {
        const double from = std::max(0.0, std::ceil(low - start - 0.5));
        if (from >= size) {
            // The narrow last texel's centre lies before the centre of a whole texel in its place.
            const double last = start + centre(size - 1);
            if (last >= low && last <= high) visit(size - 1, last, static_cast<float>(lastShare()));
            return;
        }
        const double to = std::min(size - 2.0, std::floor(high - start - 0.5));
        for (int i = static_cast<int>(from); i <= static_cast<int>(to); ++i) visit(i, start + (i + 0.5), 1.0F);
        const double last = start + centre(size - 1);
        if (last >= low && last <= high) visit(size - 1, last, static_cast<float>(lastShare()));
    }
};

}  // namespace relief
