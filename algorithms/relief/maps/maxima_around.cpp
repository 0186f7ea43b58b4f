#include "relief/maps/maxima_around.h"

#include <algorithm>

#include "base/parallel.h"

namespace relief {

FloatImage maximaAround(const FloatImage& values, Address address, Work& work) {
    const int width = values.width();
    const int height = values.height();
    FloatImage rows(width, height);
    FloatImage all(width, height);
    parallelFor(work, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            rows(x, y) = std::max({values(addressIndex(x - 1, width, address), y), values(x, y),
                                   values(addressIndex(x + 1, width, address), y)});
        }
    });
    parallelFor(work, height, [&](int y) {
        const int above = addressIndex(y - 1, height, address);
        const int below = addressIndex(y + 1, height, address);
        for (int x = 0; x < width; ++x) all(x, y) = std::max({rows(x, above), rows(x, y), rows(x, below)});
    });
    return all;
}

}  // namespace relief
