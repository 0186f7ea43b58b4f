#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "images/picture_input.h"

namespace relief {

namespace {

constexpr std::size_t kGrain = std::size_t{1} << 14;

using Channels = std::array<int, 3>;

template <class T>
double scaled(T number) {
    if constexpr (std::is_floating_point_v<T>)
        return static_cast<double>(number);
    else
        return static_cast<double>(number) / static_cast<double>(std::numeric_limits<T>::max());
}

// Selects red, green and blue (or x, y, z) where the file has them; otherwise the first three channels. Files with a
// channel Y, or with fewer than three channels, give one channel three times.
Channels colorChannels(const PictureInput& input) {
    for (const std::array<const char*, 3>& names : {std::array{"R", "G", "B"}, std::array{"X", "Y", "Z"}}) {
        const Channels named{input.channelIndex(names[0]), input.channelIndex(names[1]), input.channelIndex(names[2])};
        if (named[0] >= 0 && named[1] >= 0 && named[2] >= 0) return named;
    }
    const int grey = input.channelIndex("Y");
    if (grey >= 0) return {grey, grey, grey};
    if (input.info().channels.size() < 3) return {0, 0, 0};
    return {0, 1, 2};
}

bool isLinear(std::string_view colorSpace) {
    return colorSpace == "Linear" || colorSpace == "linear" || colorSpace == "lin_srgb" || colorSpace == "scene_linear";
}

// Table of the linear light of every value of an 8- or 16-bit type, indexed by the value's bits.
template <class T>
std::vector<float> lightTable(bool linear) {
    using Unsigned = std::make_unsigned_t<T>;
    std::vector<float> table(std::size_t{std::numeric_limits<Unsigned>::max()} + 1);
    for (std::size_t code = 0; code < table.size(); ++code) {
        const auto value = static_cast<float>(scaled(static_cast<T>(static_cast<Unsigned>(code))));
        table[code] = linear ? value : linearFromSrgb(value);
    }
    return table;
}

// Stores light(value) of every sample of one plane in component c of the colours.
template <class T, class Light>
void fill(const T* numbers, std::size_t stride, int c, ColorImage& image, Work& work, const Light& light) {
    const std::span<Color> out = image.pixels();
    parallelRanges(work, out.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) out[i][c] = light(numbers[i * stride]);
    });
}

template <class T>
void fillLight(const T* numbers, std::size_t stride, int c, bool linear, ColorImage& image, Work& work) {
    if constexpr (std::is_floating_point_v<T>) {
        fill(numbers, stride, c, image, work, [](T v) { return static_cast<float>(v); });
    } else if constexpr (sizeof(T) <= 2) {
        const std::vector<float> table = lightTable<T>(linear);
        fill(numbers, stride, c, image, work, [&](T v) { return table[static_cast<std::make_unsigned_t<T>>(v)]; });
    } else {
        fill(numbers, stride, c, image, work, [linear](T v) {
            const auto value = static_cast<float>(scaled(v));
            return linear ? value : linearFromSrgb(value);
        });
    }
}

// Components up to this size may be zero, quantised to 8 bits (half a step, and a margin for rounding).
constexpr float kZeroNormal = 0.51F / 127.5F;

glm::vec3 unitNormal(const glm::vec3& encoded) {
    const glm::vec3 n = 2.0F * encoded - 1.0F;
    const float length = glm::length(n);
    const bool zero = std::abs(n.x) <= kZeroNormal && std::abs(n.y) <= kZeroNormal && std::abs(n.z) <= kZeroNormal;
    // Written as a negation so that NaN is caught as well.
    if (zero || !(length > 0) || !std::isfinite(length)) return {0, 0, 1};
    return n / length;
}

}  // namespace

ColorImage readColor(const std::string& path, Work& work, std::int64_t maxPixels) {
    PictureInput input(path, maxPixels);
    const Channels channels = colorChannels(input);
    const RawPlanes raw = input.read(channels, work, sizeof(Color));
    const bool linear = isLinear(input.info().colorSpace);
    ColorImage image(input.info().width, input.info().height);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const RawPlane& plane = raw.planes[c];
        withNumbers(plane, [&](const auto* numbers) {
            fillLight(numbers, plane.stride, static_cast<int>(c), linear, image, work);
        });
    }
    return image;
}

Image<glm::vec3> readNormals(const std::string& path, Work& work, std::int64_t maxPixels) {
    PictureInput input(path, maxPixels);
    const std::size_t count = input.info().channels.size();
    if (count < 3) throw InputError(path, Message(MessageId::NormalsNeedThree, {{"count", count}}));
    const Channels channels = colorChannels(input);
    const RawPlanes raw = input.read(channels, work, sizeof(glm::vec3));
    Image<glm::vec3> image(input.info().width, input.info().height);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const RawPlane& plane = raw.planes[c];
        withNumbers(plane, [&](const auto* numbers) {
            fill(numbers, plane.stride, static_cast<int>(c), image, work,
                 [](auto v) { return static_cast<float>(scaled(v)); });
        });
    }
    const std::span<glm::vec3> out = image.pixels();
    parallelRanges(work, out.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) out[i] = unitNormal(out[i]);
    });
    return image;
}

}  // namespace relief
