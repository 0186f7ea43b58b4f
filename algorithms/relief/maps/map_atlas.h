// The contents of a map file: layers as tiles of one picture, and the checksums that detect damage. For map_files.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/maps/stored_values.h"

namespace relief {

// FNV-1a, 64 bits.
class Checksum {
  public:
    template <class Value>
    void add(const Value* values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) add(values[i]);
    }
    void add(std::string_view text) { add(text.data(), text.size()); }
    std::uint64_t value() const { return hash_; }
    // As text, since JSON numbers have only 53 bits.
    std::string text() const {
        std::string digits(16, '0');
        for (std::size_t i = 0; i < digits.size(); ++i) {
            digits[i] = "0123456789abcdef"[hash_ >> (60 - 4 * i) & 15U];
        }
        return digits;
    }
    // Low byte first on every machine.
    void add(float value) { addBits(std::bit_cast<std::uint32_t>(value), sizeof value); }
    void add(std::uint64_t value) { addBits(value, sizeof value); }
    void add(std::uint16_t value) { addBits(value, sizeof value); }
    void add(std::uint8_t value) { addBits(value, sizeof value); }
    void add(char value) { addBits(static_cast<unsigned char>(value), sizeof value); }

  private:
    void addBits(std::uint64_t bits, std::size_t bytes) {
        for (std::size_t b = 0; b < bytes; ++b) hash_ = (hash_ ^ (bits >> (8 * b) & 255U)) * 0x100000001b3ULL;
    }
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

// The arrangement of the layers: tiles of nx x ny, row by row.
struct Atlas {
    int nx = 0;
    int ny = 0;
    int tiles = 0;
    int columns = 0;

    Atlas(int width, int height, int count) : nx(width), ny(height), tiles(count) {
        const double square = std::sqrt(static_cast<double>(count) * height / width);
        columns = std::clamp(static_cast<int>(std::lround(square)), 1, count);
    }
    int rows() const { return (tiles + columns - 1) / columns; }
    int width() const { return columns * nx; }
    int height() const { return rows() * ny; }
    std::size_t pixels() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()); }
    // Index of the first pixel of a tile's row.
    std::size_t at(int tile, int y) const {
        const auto row = static_cast<std::size_t>(tile / columns * ny + y);
        return row * static_cast<std::size_t>(width()) + static_cast<std::size_t>(tile % columns * nx);
    }
};

// The layers of all stacks as one picture.
template <class Code>
std::vector<Code> pictureOfLayers(const std::vector<const StoredValues*>& stacks, const Atlas& atlas) {
    std::vector<Code> pixels(atlas.pixels());
    int tile = 0;
    for (const StoredValues* stack : stacks) {
        const Code* from = std::get<UnfilledVector<Code>>(stack->codes()).data();
        for (int layer = 0; layer < stack->layers(); ++layer, ++tile) {
            for (int y = 0; y < atlas.ny; ++y, from += atlas.nx) {
                std::copy_n(from, atlas.nx, pixels.begin() + static_cast<std::ptrdiff_t>(atlas.at(tile, y)));
            }
        }
    }
    return pixels;
}

// The stack of `layers` layers that begins with tile `first`.
template <class Code>
StoredValues layersOfPicture(const std::vector<Code>& pixels, const Atlas& atlas, int first, int layers, float unit) {
    UnfilledVector<Code> codes;
    codes.reserve(static_cast<std::size_t>(atlas.nx) * static_cast<std::size_t>(atlas.ny) *
                  static_cast<std::size_t>(layers));
    for (int tile = first; tile < first + layers; ++tile) {
        for (int y = 0; y < atlas.ny; ++y) {
            const auto from = pixels.begin() + static_cast<std::ptrdiff_t>(atlas.at(tile, y));
            codes.insert(codes.end(), from, from + atlas.nx);
        }
    }
    return StoredValues(atlas.nx, atlas.ny, layers, std::move(codes), unit);
}

}  // namespace relief
