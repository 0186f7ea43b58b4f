// A stack of layers of values as maps store them: float, or 16 or 8 bits rounded to the safe side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/large_memory.h"

namespace relief {

// How values are stored: as floats, or as codes of 16 or 8 bits.
enum class Precision : std::uint8_t { Float, U16, U8 };
// Rounding of a value without exact code: distances down, cone slopes up.
enum class Rounding : std::uint8_t { Down, Up };

std::string_view precisionName(Precision precision);
// Parses "float", "u16" or "u8". Throws InputError("--set", ...).
Precision parsePrecision(std::string_view text);
std::size_t bytesEach(Precision precision);

// width x height x layers values. A value is 0 or more, or one of two marks, which every precision preserves.
class StoredValues {
  public:
    static constexpr float kSurface = -1;
    static constexpr float kBuried = -2;

    StoredValues() = default;
    // values: layer by layer, row by row; each finite, or a mark.
    StoredValues(int width, int height, int layers, UnfilledVector<float> values, Precision precision,
                 Rounding rounding);
    // The codes as stored in a file.
    using Codes = std::variant<UnfilledVector<float>, UnfilledVector<std::uint16_t>, UnfilledVector<std::uint8_t>>;
    StoredValues(int width, int height, int layers, Codes codes, float unit);

    int width() const { return width_; }
    int height() const { return height_; }
    int layers() const { return layers_; }
    Precision precision() const { return static_cast<Precision>(codes_.index()); }
    // Value of one code step; 0 for float.
    float unit() const { return unit_; }
    const Codes& codes() const { return codes_; }
    std::size_t bytes() const { return count() * bytesEach(precision()); }

    float operator()(int x, int y, int layer) const {
        const std::size_t i =
            (static_cast<std::size_t>(layer) * static_cast<std::size_t>(height_) + static_cast<std::size_t>(y)) *
                static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x);
        switch (codes_.index()) {
            case 0:
                return std::get<0>(codes_)[i];
            case 1:
                return decode(std::get<1>(codes_)[i]);
            default:
                return decode(std::get<2>(codes_)[i]);
        }
    }

  private:
    static constexpr int kMarks = 2;
    std::size_t count() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * static_cast<std::size_t>(layers_);
    }
    float decode(int code) const {
        return code < kMarks ? static_cast<float>(-1 - code) : static_cast<float>(code - kMarks) * unit_;
    }
    template <class Code>
    UnfilledVector<Code> encode(const UnfilledVector<float>& values, Rounding rounding) const;

    int width_ = 0;
    int height_ = 0;
    int layers_ = 0;
    float unit_ = 0;
    Codes codes_;
};

}  // namespace relief
