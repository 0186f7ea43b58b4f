// A two-dimensional picture that owns its pixels: rows top-down, the pixels of a row contiguous.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "relief/memory.h"

namespace relief {

// width, height >= 0; pixel (x, y) has x to the right and y downwards. The constructor throws MemoryError if there is
// not enough memory for a large picture.
template <class T>
class Image {
  public:
    using Value = T;

    Image() = default;
    Image(int width, int height, T value = T{})
        : width_(width), height_(height), pixels_(checkedCount(width, height), value) {}

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return pixels_.empty(); }
    std::size_t size() const { return pixels_.size(); }
    std::size_t bytes() const { return pixels_.size() * sizeof(T); }

    T& operator()(int x, int y) { return pixels_[index(x, y)]; }
    const T& operator()(int x, int y) const { return pixels_[index(x, y)]; }

    std::span<T> row(int y) { return {pixels_.data() + index(0, y), static_cast<std::size_t>(width_)}; }
    std::span<const T> row(int y) const { return {pixels_.data() + index(0, y), static_cast<std::size_t>(width_)}; }

    T* data() { return pixels_.data(); }
    const T* data() const { return pixels_.data(); }
    std::span<T> pixels() { return pixels_; }
    std::span<const T> pixels() const { return pixels_; }

    bool operator==(const Image&) const = default;

  private:
    static std::size_t checkedCount(int width, int height) {
        assert(width >= 0 && height >= 0);
        const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const std::uint64_t bytes = byteProduct({count, sizeof(T)});
        if (bytes >= kCheckedBytes) requireMemory(bytes, std::to_string(width) + " x " + std::to_string(height));
        return count;
    }

    std::size_t index(int x, int y) const {
        assert(x >= 0 && x < width_ && y >= 0 && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0;
    int height_ = 0;
    std::vector<T> pixels_;
};

// Linear light with Rec. 709 primaries; not clamped.
using Color = glm::vec3;
using ColorImage = Image<Color>;
using FloatImage = Image<float>;

}  // namespace relief
