#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/parallel.h"
#include "images/described_tiff.h"
#include "images/picture_bands.h"
#include "images/picture_layout.h"
#include "images/picture_library.h"

namespace relief {

namespace {

struct Format {
    std::string_view extension;
    std::string_view library;
    bool light;    // stores floats of any size, meant for linear light
    bool sixteen;  // stores 16-bit integers without loss
    bool floats;
};

constexpr std::array kFormats{
    Format{"png", "png", false, true, false},    Format{"exr", "openexr", true, false, true},
    Format{"tif", "tiff", false, true, true},    Format{"tiff", "tiff", false, true, true},
    Format{"jpg", "jpeg", false, false, false},  Format{"jpeg", "jpeg", false, false, false},
    Format{"hdr", "hdr", true, false, false},    Format{"bmp", "bmp", false, false, false},
    Format{"tga", "targa", false, false, false}, Format{"ppm", "pnm", false, false, false},
};

template <class Predicate>
std::string extensions(const Predicate& predicate) {
    std::string list;
    for (const Format& format : kFormats)
        if (predicate(format)) list += (list.empty() ? "" : ", ") + std::string(format.extension);
    return list;
}

std::string extensionOf(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return lowerCase(extension.empty() ? extension : extension.substr(1));
}

const Format& formatOf(const std::string& path) {
    const std::string extension = extensionOf(path);
    for (const Format& format : kFormats)
        if (format.extension == extension) return format;
    throw InputError(path,
                     Message(MessageId::FormatUnknown,
                             {{"extension", extension}, {"known", extensions([](const Format&) { return true; })}}));
}

using Attributes = std::vector<std::pair<std::string, std::string>>;

void writeBlock(const std::string& path, const Format& format, PictureBlock block, const void* numbers) {
    if (block.width < 1 || block.height < 1)
        throw InputError(path, Message(MessageId::PictureEmpty, {{"width", block.width}, {"height", block.height}}));
    block.numbers = numbers;
    pictureLibrary().write(path, std::string(format.library), block);
}

// For TIFF this attribute would create an EXIF directory, which OpenImageIO 2.4 writes over the picture's own.
void setColorSpace(Attributes& attributes, const Format& format, const std::string& name) {
    if (format.library != "tiff" && !name.empty()) attributes.emplace_back("oiio:ColorSpace", name);
}

// Sets the text of a band if the format has a place for it.
void setBandText(Attributes& attributes, const Format& format, const std::string& text) {
    if (text.empty()) return;
    attributes.emplace_back(format.library == "tiff" ? "ImageDescription" : kBandAttribute, text);
}

// Encodes 8-bit sRGB by binary search among the light values at which the code changes: no power function per pixel,
// and the same bits on every platform.
class SrgbCodes {
  public:
    SrgbCodes() {
        for (std::size_t k = 0; k < thresholds_.size(); ++k)
            thresholds_[k] = linearFromSrgb((static_cast<float>(k) + 0.5F) / 255.0F);
    }
    std::uint8_t operator()(float linear) const {
        if (std::isnan(linear)) return 0;
        return static_cast<std::uint8_t>(std::upper_bound(thresholds_.begin(), thresholds_.end(), linear) -
                                         thresholds_.begin());
    }

  private:
    std::array<float, 255> thresholds_{};
};

std::uint16_t sixteenBit(float height) {
    if (!(height > 0)) return 0;  // also for NaN
    return static_cast<std::uint16_t>(std::floor(std::min(static_cast<double>(height), 1.0) * 65535.0 + 0.5));
}

template <class Convert>
void forIndices(std::size_t count, const Convert& convert) {
    parallelFor(count, convert, 1 << 14);
}

}  // namespace

std::vector<std::byte> colorNumbers(const ColorImage& image, bool floats) {
    static_assert(sizeof(Color) == 3 * sizeof(float));
    const std::span<const Color> pixels = image.pixels();
    std::vector<std::byte> numbers(pixels.size() * (floats ? sizeof(Color) : 3));
    if (floats) {
        std::memcpy(numbers.data(), pixels.data(), numbers.size());
        return numbers;
    }
    const SrgbCodes codes;
    forIndices(pixels.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) numbers[3 * i + static_cast<std::size_t>(c)] = std::byte{codes(pixels[i][c])};
    });
    return numbers;
}

void writeColor(const std::string& path, const ColorImage& image, const std::string& bandText) {
    const Format& format = formatOf(path);
    PictureBlock block{image.width(), image.height(), {"R", "G", "B"}, format.light ? "float" : "uint8", {}, {}};
    setColorSpace(block.attributes, format, format.light ? "Linear" : "sRGB");
    setBandText(block.attributes, format, bandText);
    if (format.light) return writeBlock(path, format, std::move(block), image.data());
    if (format.library == "jpeg") block.attributes.emplace_back("Compression", "jpeg:95");
    writeBlock(path, format, std::move(block), colorNumbers(image, false).data());
}

void writeNumbers(const std::string& path, const ImageInfo& info, const std::byte* numbers,
                  const std::string& description) {
    const Format& format = formatOf(path);
    PictureBlock block{info.width, info.height, info.channels, info.type, {}, {}};
    setColorSpace(block.attributes, format, info.colorSpace);
    if (!description.empty()) block.attributes.emplace_back("ImageDescription", description);
    writeBlock(path, format, std::move(block), numbers);
}

void writeHeight(const std::string& path, const FloatImage& heights, bool asFloat) {
    const Format& format = formatOf(path);
    const bool floats = format.floats && (asFloat || !format.sixteen);
    if (!floats && (asFloat || !format.sixteen)) {
        const auto fits = [&](const Format& other) { return other.floats || (!asFloat && other.sixteen); };
        throw InputError(path, Message(MessageId::FormatNotForThis,
                                       {{"extension", extensionOf(path)}, {"known", extensions(fits)}}));
    }
    if (floats) {
        writeBlock(path, format, {heights.width(), heights.height(), {"Y"}, "float", {}, {}}, heights.data());
        return;
    }
    std::vector<std::uint16_t> codes(heights.size());
    forIndices(codes.size(), [&](std::size_t i) { codes[i] = sixteenBit(heights.pixels()[i]); });
    writeBlock(path, format, {heights.width(), heights.height(), {"Y"}, "uint16", {}, {}}, codes.data());
}

std::vector<std::byte> planeNumbers(const std::vector<NamedPlane>& planes) {
    assert(!planes.empty());
    const std::size_t count = planes.size(), pixels = planes.front().plane.size();
    std::vector<std::byte> numbers(pixels * count * sizeof(float));
    forIndices(pixels, [&](std::size_t i) {
        for (std::size_t c = 0; c < count; ++c) {
            const float number = planes[c].plane.pixels()[i];
            std::memcpy(numbers.data() + (i * count + c) * sizeof number, &number, sizeof number);
        }
    });
    return numbers;
}

void writePlanes(const std::string& path, const std::vector<NamedPlane>& planes, const std::string& bandText) {
    assert(!planes.empty());
    const Format& format = formatOf(path);
    if (format.library != "openexr")
        throw InputError(path,
                         Message(MessageId::FormatNotForThis, {{"extension", extensionOf(path)}, {"known", "exr"}}));
    const FloatImage& first = planes.front().plane;
    PictureBlock block{first.width(), first.height(), {}, "float", {}, {}};
    setBandText(block.attributes, format, bandText);
    for (const NamedPlane& plane : planes) {
        assert(plane.plane.width() == first.width() && plane.plane.height() == first.height());
        block.channels.push_back(plane.name);
    }
    writeBlock(path, format, std::move(block), planeNumbers(planes).data());
}

namespace {

const Format& tiffFormatOf(const std::string& path) {
    const Format& format = formatOf(path);
    if (format.library == "tiff") return format;
    throw InputError(path,
                     Message(MessageId::FormatNotForThis, {{"extension", extensionOf(path)}, {"known", "tif, tiff"}}));
}

}  // namespace

void writeMipTiff(const std::string& path, const std::vector<DescribedPage>& pages) {
    assert(!pages.empty());
    tiffFormatOf(path);
    pictureLibrary().writeTiffPages(path, pages);
}

void writeDescribedTiff(const std::string& path, int width, int height, const PictureCodes& codes,
                        const std::string& description) {
    constexpr std::array kTypes{"float", "uint16", "uint8"};
    const Format& format = tiffFormatOf(path);
    const PictureBlock block{width, height, {"Y"}, kTypes[codes.index()], {{"ImageDescription", description}}, {}};
    std::visit([&](const auto& all) { writeBlock(path, format, block, all.data()); }, codes);
}

}  // namespace relief
