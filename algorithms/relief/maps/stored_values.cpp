#include "relief/maps/stored_values.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "relief/errors.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 3> kNames{"float", "u16", "u8"};

}  // namespace

std::string_view precisionName(Precision precision) {
    return kNames[static_cast<std::size_t>(precision)];
}

Precision parsePrecision(std::string_view text) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == text) return static_cast<Precision>(i);
    }
    throw InputError("--set", unknownName({"what", MessageId::WordPrecision}, std::string(text), "float, u16, u8"));
}

std::size_t bytesEach(Precision precision) {
    constexpr std::array<std::size_t, 3> kBytes{4, 2, 1};
    return kBytes[static_cast<std::size_t>(precision)];
}

template <class Code>
UnfilledVector<Code> StoredValues::encode(const UnfilledVector<float>& values, Rounding rounding) const {
    constexpr int kLast = std::numeric_limits<Code>::max();
    UnfilledVector<Code> codes(values.size());
    std::transform(values.begin(), values.end(), codes.begin(), [&](float value) {
        if (value < 0) return static_cast<Code>(value == kSurface ? 0 : 1);
        if (unit_ == 0) return static_cast<Code>(kMarks);
        const double steps = static_cast<double>(value) / static_cast<double>(unit_);
        int code = kMarks + static_cast<int>(rounding == Rounding::Down ? std::floor(steps) : std::ceil(steps));
        // The decoded value must be on the safe side to the last bit.
        code = std::min(code, kLast);
        if (rounding == Rounding::Down) {
            while (code > kMarks && decode(code) > value) --code;
        } else {
            while (code < kLast && decode(code) < value) ++code;
        }
        return static_cast<Code>(code);
    });
    return codes;
}

StoredValues::StoredValues(int width, int height, int layers, UnfilledVector<float> values, Precision precision,
                           Rounding rounding)
    : width_(width), height_(height), layers_(layers) {
    assert(values.size() == count());
    if (precision == Precision::Float) {
        codes_ = std::move(values);
        return;
    }
    const float largest = values.empty() ? 0.0F : std::max(0.0F, *std::max_element(values.begin(), values.end()));
    const int last = precision == Precision::U16 ? 65535 : 255;
    unit_ = largest / static_cast<float>(last - kMarks);
    // When rounding up, the largest value needs a code that is not below it.
    while (rounding == Rounding::Up && decode(last) < largest) {
        unit_ = std::nextafter(unit_, std::numeric_limits<float>::infinity());
    }
    if (precision == Precision::U16) {
        codes_ = encode<std::uint16_t>(values, rounding);
    } else {
        codes_ = encode<std::uint8_t>(values, rounding);
    }
}

StoredValues::StoredValues(int width, int height, int layers, Codes codes, float unit)
    : width_(width), height_(height), layers_(layers), unit_(unit), codes_(std::move(codes)) {
    assert(std::visit([](const auto& all) { return all.size(); }, codes_) == count());
}

}  // namespace relief
