#include "rendering/display.h"

#include <cassert>
#include <cmath>
#include <vector>

#include "relief/files.h"

namespace relief {

namespace {

// The table is indexed by the square root of the linear value: the sRGB curve is steep at 0, and a table over the value
// itself would need 16 times as many entries.
constexpr int kTableSize = 4096;

std::vector<std::uint8_t> makeTable() {
    std::vector<std::uint8_t> table(kTableSize + 1);
    for (int i = 0; i <= kTableSize; ++i) {
        const float root = static_cast<float>(i) / kTableSize;
        table[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(std::lround(255.0F * srgbFromLinear(root * root)));
    }
    return table;
}

std::uint32_t code(const std::vector<std::uint8_t>& table, float linear) {
    if (!(linear > 0)) return table.front();
    if (linear >= 1) return table.back();
    return table[static_cast<std::size_t>(std::sqrt(linear) * kTableSize + 0.5F)];
}

}  // namespace

void toSrgb32(std::span<const Color> linear, std::span<std::uint32_t> out) {
    assert(linear.size() == out.size());
    static const std::vector<std::uint8_t> table = makeTable();
    for (std::size_t i = 0; i < linear.size(); ++i) {
        const Color& c = linear[i];
        out[i] = 0xff000000U | code(table, c.r) << 16U | code(table, c.g) << 8U | code(table, c.b);
    }
}

}  // namespace relief
