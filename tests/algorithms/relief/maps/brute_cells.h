// The cells of a height map computed independently, for the tests of maps: their heights, and their periodic copies.
#pragma once

#include <algorithm>

#include "algorithms/relief/fields.h"

namespace relief::test {

struct BruteCells {
    int nx;
    int ny;
    bool wraps;
    bool bounded;  // true: nothing outside the picture
    double shift;  // cell coordinate = texel coordinate + shift
    FloatImage highest;
    FloatImage lowest;
    int width;
    int height;

    explicit BruteCells(const HeightField& field)
        : wraps(field.address() == Address::Repeat),
          bounded(field.address() == Address::Border),
          width(field.width()),
          height(field.height()) {
        const bool bilinear = field.surface() == Surface::Bilinear;
        const int more = bilinear && !wraps ? 1 : 0;
        nx = width + more;
        ny = height + more;
        shift = !bilinear ? 0 : (wraps ? -0.5 : 0.5);
        highest = FloatImage(nx, ny);
        lowest = highest;
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                float high = 0;
                float low = 1;
                for (int j = 0; j < (bilinear ? 2 : 1); ++j) {
                    for (int i = 0; i < (bilinear ? 2 : 1); ++i) {
                        const float h = field.texel(x - more + i, y - more + j);
                        high = std::max(high, h);
                        low = std::min(low, h);
                    }
                }
                highest(x, y) = high;
                lowest(x, y) = low;
            }
        }
    }

    // Calls body(i, j, highest) for every cell and, under repeat, for its copies in the neighbouring periods.
    template <class Body>
    void each(const Body& body) const {
        const int around = wraps ? 1 : 0;
        for (int j = -around * ny; j < ny * (1 + around); ++j) {
            for (int i = -around * nx; i < nx * (1 + around); ++i) {
                body(i, j, static_cast<double>(highest((i + nx) % nx, (j + ny) % ny)));
            }
        }
    }

    // Returns true if there is a surface at (s, t), in texels.
    bool holds(double s, double t) const { return !bounded || (s >= 0 && s <= width && t >= 0 && t <= height); }
};

}  // namespace relief::test
