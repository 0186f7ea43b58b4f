#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>

#include "base/parallel.h"
#include "images/described_tiff.h"
#include "images/picture_bands.h"
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
void setBandText(Attributes& attributes, const Format& format, const PictureBand* band) {
    if (band == nullptr || band->text.empty()) return;
    attributes.emplace_back(format.library == "tiff" ? "ImageDescription" : kBandAttribute, band->text);
}

// The given band, or one that covers all rows.
PictureBand bandOf(const PictureBand* band, int height) {
    const PictureBand rows = band != nullptr ? *band : PictureBand{0, height, {}};
    assert(0 <= rows.begin && rows.begin <= rows.end && rows.end <= height);
    return rows;
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

void writeColor(const std::string& path, const ColorImage& image, const PictureBand* band) {
    const Format& format = formatOf(path);
    const PictureBand rows = bandOf(band, image.height());
    const auto width = static_cast<std::size_t>(image.width());
    const std::span<const Color> pixels = image.pixels().subspan(
        width * static_cast<std::size_t>(rows.begin), width * static_cast<std::size_t>(rows.end - rows.begin));
    PictureBlock block{image.width(), rows.end - rows.begin, {"R", "G", "B"}, format.light ? "float" : "uint8", {}, {}};
    setColorSpace(block.attributes, format, format.light ? "Linear" : "sRGB");
    setBandText(block.attributes, format, band);
    if (format.light) {
        static_assert(sizeof(Color) == 3 * sizeof(float));
        writeBlock(path, format, std::move(block), pixels.data());
        return;
    }
    if (format.library == "jpeg") block.attributes.emplace_back("Compression", "jpeg:95");
    const SrgbCodes codes;
    std::vector<std::uint8_t> bytes(pixels.size() * 3);
    forIndices(pixels.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) bytes[3 * i + static_cast<std::size_t>(c)] = codes(pixels[i][c]);
    });
    writeBlock(path, format, std::move(block), bytes.data());
}

void writeNumbers(const std::string& path, const ImageInfo& info, const std::byte* numbers) {
    const Format& format = formatOf(path);
    PictureBlock block{info.width, info.height, info.channels, info.type, {}, {}};
    setColorSpace(block.attributes, format, info.colorSpace);
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

void writePlanes(const std::string& path, const std::vector<NamedPlane>& planes, const PictureBand* band) {
    assert(!planes.empty());
    const Format& format = formatOf(path);
    if (format.library != "openexr")
        throw InputError(path,
                         Message(MessageId::FormatNotForThis, {{"extension", extensionOf(path)}, {"known", "exr"}}));
    const FloatImage& first = planes.front().plane;
    const std::size_t count = planes.size();
    const PictureBand rows = bandOf(band, first.height());
    const int height = rows.end - rows.begin;
    PictureBlock block{first.width(), height, {}, "float", {}, {}};
    setBandText(block.attributes, format, band);
    for (const NamedPlane& plane : planes) {
        assert(plane.plane.width() == first.width() && plane.plane.height() == first.height());
        block.channels.push_back(plane.name);
    }
    const auto width = static_cast<std::size_t>(first.width());
    const std::size_t skipped = width * static_cast<std::size_t>(rows.begin);
    std::vector<float> numbers(width * static_cast<std::size_t>(height) * count);
    forIndices(numbers.size() / count, [&](std::size_t i) {
        for (std::size_t c = 0; c < count; ++c) numbers[i * count + c] = planes[c].plane.pixels()[skipped + i];
    });
    writeBlock(path, format, std::move(block), numbers.data());
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
