#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>

#include "base/parallel.h"
#include "images/described_tiff.h"
#include "images/picture_bands.h"
#include "images/system_error.h"
#include "relief/files.h"

namespace relief {

namespace {

struct Format {
    std::string_view extension;
    std::string_view library;
    bool light;    // holds floats of any size, and linear light is what it is for
    bool sixteen;  // holds 16-bit numbers without loss
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
std::string extensions(const Predicate& wanted) {
    std::string list;
    for (const Format& format : kFormats)
        if (wanted(format)) list += (list.empty() ? "" : ", ") + std::string(format.extension);
    return list;
}

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

const Format& formatOf(const std::string& path) {
    const std::string extension = extensionOf(path);
    for (const Format& format : kFormats)
        if (format.extension == extension) return format;
    throw InputError(path,
                     Message(MessageId::FormatUnknown,
                             {{"extension", extension}, {"known", extensions([](const Format&) { return true; })}}));
}

// The formats' libraries notice a full disk late or never, and some say so on stderr. Here the first failure is kept,
// and they are told that all is well.
class CheckedOutput : public OIIO::Filesystem::IOProxy {
  public:
    explicit CheckedOutput(const std::string& path)
        : IOProxy(path, Write), descriptor_(::open(path.c_str(), O_RDWR | O_TRUNC | O_CLOEXEC)) {
        if (descriptor_ < 0) error_ = errno;
    }
    ~CheckedOutput() override { finish(); }
    CheckedOutput(const CheckedOutput&) = delete;
    CheckedOutput& operator=(const CheckedOutput&) = delete;

    // 0, or the errno of the first failure.
    int finish() {
        if (descriptor_ >= 0 && ::close(descriptor_) != 0) keep(errno);
        descriptor_ = -1;
        return error_;
    }

    const char* proxytype() const override { return "checked"; }
    std::size_t size() const override { return static_cast<std::size_t>(size_); }
    std::size_t write(const void* bytes, std::size_t count) override {
        pwrite(bytes, count, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pwrite(const void* bytes, std::size_t count, std::int64_t offset) override {
        std::size_t done = 0;
        while (done < count && error_ == 0) {
            const auto at = offset + static_cast<std::int64_t>(done);
            const ::ssize_t wrote = ::pwrite(descriptor_, static_cast<const char*>(bytes) + done, count - done, at);
            if (wrote > 0)
                done += static_cast<std::size_t>(wrote);
            else if (wrote == 0)
                keep(ENOSPC);
            else if (errno != EINTR)
                keep(errno);
        }
        size_ = std::max(size_, offset + static_cast<std::int64_t>(count));
        return count;
    }
    std::size_t read(void* bytes, std::size_t count) override {
        const std::size_t got = pread(bytes, count, m_pos);
        m_pos += static_cast<std::int64_t>(got);
        return got;
    }
    std::size_t pread(void* bytes, std::size_t count, std::int64_t offset) override {
        const ::ssize_t got = ::pread(descriptor_, bytes, count, offset);
        return got > 0 ? static_cast<std::size_t>(got) : 0;
    }

  private:
    void keep(int error) {
        if (error_ == 0) error_ = error;
    }

    int descriptor_;
    int error_ = 0;
    std::int64_t size_ = 0;
};

// write(output): opens it and writes all there is; true if nothing failed.
template <class Write>
void writeWhole(const std::string& path, const Format& format, const Write& write) {
    AtomicFile file(path);
    CheckedOutput sink(file.temporaryPath());
    bool done = false;
    std::string why;
    if (const auto output = OIIO::ImageOutput::create(std::string(format.library))) {
        done = output->set_ioproxy(&sink) && write(*output, file.temporaryPath());
        why = output->geterror();
        done = output->close() && done;
        if (why.empty()) why = output->geterror();
    } else {
        why = OIIO::geterror();
    }
    if (const int error = sink.finish(); error != 0)
        throw WorkError(path,
                        systemMessage(error, FileAccess::Write, std::filesystem::path(path).parent_path().string()));
    if (!done) throw WorkError(path, Message(MessageId::FileUnwritable, {{"why", oneLine(why)}}));
    file.commit();
}

void writePixels(const std::string& path, const Format& format, const OIIO::ImageSpec& spec, const void* pixels) {
    if (spec.width < 1 || spec.height < 1)
        throw InputError(path, Message(MessageId::PictureEmpty, {{"width", spec.width}, {"height", spec.height}}));
    writeWhole(path, format, [&](OIIO::ImageOutput& output, const std::string& name) {
        return output.open(name, spec) && output.write_image(spec.format, pixels);
    });
}

OIIO::ImageSpec specOf(int width, int height, int channels, OIIO::TypeDesc::BASETYPE type) {
    OIIO::ImageSpec spec(width, height, channels, type);
    if (channels == 1) spec.channelnames = {"Y"};
    // Twice as fast as zlib's own level 6, for a tenth more bytes; read by the PNG writer alone.
    spec.attribute("png:compressionLevel", 4);
    return spec;
}

// TIFF would get an EXIF directory for it, which OpenImageIO 2.4 puts where the picture's own should be.
void setColorSpace(OIIO::ImageSpec& spec, const Format& format, const std::string& name) {
    if (format.library != "tiff" && !name.empty()) spec.attribute("oiio:ColorSpace", name);
}

// The text of a band, where its format has a place for it.
void setBandText(OIIO::ImageSpec& spec, const Format& format, const PictureBand* band) {
    if (band == nullptr || band->text.empty()) return;
    spec.attribute(format.library == "tiff" ? "ImageDescription" : std::string(kBandAttribute), band->text);
}

// The band, or all rows of a picture.
PictureBand bandOf(const PictureBand* band, int height) {
    const PictureBand rows = band != nullptr ? *band : PictureBand{0, height, {}};
    assert(0 <= rows.begin && rows.begin <= rows.end && rows.end <= height);
    return rows;
}

// 8-bit sRGB codes by search among the light values where they change: no power a pixel, and the same bits everywhere.
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
    if (!(height > 0)) return 0;  // NaN, too
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
    const auto type = format.light ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec = specOf(image.width(), rows.end - rows.begin, 3, type);
    setColorSpace(spec, format, format.light ? "Linear" : "sRGB");
    setBandText(spec, format, band);
    if (format.light) {
        static_assert(sizeof(Color) == 3 * sizeof(float));
        writePixels(path, format, spec, pixels.data());
        return;
    }
    if (format.library == "jpeg") spec.attribute("Compression", "jpeg:95");
    const SrgbCodes codes;
    std::vector<std::uint8_t> bytes(pixels.size() * 3);
    forIndices(pixels.size(), [&](std::size_t i) {
        for (int c = 0; c < 3; ++c) bytes[3 * i + static_cast<std::size_t>(c)] = codes(pixels[i][c]);
    });
    writePixels(path, format, spec, bytes.data());
}

void writeNumbers(const std::string& path, const ImageInfo& info, const std::byte* numbers) {
    const Format& format = formatOf(path);
    const OIIO::TypeDesc type(info.type);
    OIIO::ImageSpec spec = specOf(info.width, info.height, static_cast<int>(info.channels.size()),
                                  static_cast<OIIO::TypeDesc::BASETYPE>(type.basetype));
    spec.channelnames = info.channels;
    setColorSpace(spec, format, info.colorSpace);
    const OIIO::TypeDesc given = type == OIIO::TypeDesc::HALF ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : type;
    writeWhole(path, format, [&](OIIO::ImageOutput& output, const std::string& name) {
        return output.open(name, spec) && output.write_image(given, numbers);
    });
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
        writePixels(path, format, specOf(heights.width(), heights.height(), 1, OIIO::TypeDesc::FLOAT), heights.data());
        return;
    }
    std::vector<std::uint16_t> codes(heights.size());
    forIndices(codes.size(), [&](std::size_t i) { codes[i] = sixteenBit(heights.pixels()[i]); });
    writePixels(path, format, specOf(heights.width(), heights.height(), 1, OIIO::TypeDesc::UINT16), codes.data());
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
    OIIO::ImageSpec spec = specOf(first.width(), height, static_cast<int>(count), OIIO::TypeDesc::FLOAT);
    setBandText(spec, format, band);
    spec.channelnames.clear();
    for (const NamedPlane& plane : planes) {
        assert(plane.plane.width() == first.width() && plane.plane.height() == first.height());
        spec.channelnames.push_back(plane.name);
    }
    const auto width = static_cast<std::size_t>(first.width());
    const std::size_t skipped = width * static_cast<std::size_t>(rows.begin);
    std::vector<float> numbers(width * static_cast<std::size_t>(height) * count);
    forIndices(numbers.size() / count, [&](std::size_t i) {
        for (std::size_t c = 0; c < count; ++c) numbers[i * count + c] = planes[c].plane.pixels()[skipped + i];
    });
    writePixels(path, format, spec, numbers.data());
}

namespace {

const Format& tiffFormatOf(const std::string& path) {
    const Format& format = formatOf(path);
    if (format.library == "tiff") return format;
    throw InputError(path,
                     Message(MessageId::FormatNotForThis, {{"extension", extensionOf(path)}, {"known", "tif, tiff"}}));
}

// Whether the file has these very pages.
bool holds(const std::string& path, const std::vector<DescribedPage>& pages) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return false;
    std::vector<float> read;
    for (std::size_t p = 0; p < pages.size(); ++p) {
        const FloatImage& picture = *pages[p].picture;
        const OIIO::ImageSpec spec = input->spec(0, static_cast<int>(p));
        if (spec.width != picture.width() || spec.height != picture.height()) return false;
        read.assign(picture.size(), 0);
        if (!input->read_image(0, static_cast<int>(p), 0, 1, OIIO::TypeDesc::FLOAT, read.data())) return false;
        if (!std::equal(read.begin(), read.end(), picture.pixels().begin())) return false;
    }
    return true;
}

}  // namespace

void writeMipTiff(const std::string& path, const std::vector<DescribedPage>& pages) {
    assert(!pages.empty());
    const Format& format = tiffFormatOf(path);
    AtomicFile file(path);
    std::string why;
    // Pages are appended by opening the file again, which a checked output of our own does not live through: what was
    // written is read back instead.
    const auto output = OIIO::ImageOutput::create(std::string(format.library));
    bool done = output != nullptr;
    for (std::size_t p = 0; done && p < pages.size(); ++p) {
        const FloatImage& picture = *pages[p].picture;
        OIIO::ImageSpec spec = specOf(picture.width(), picture.height(), 1, OIIO::TypeDesc::FLOAT);
        spec.tile_width = kTiffTile;
        spec.tile_height = kTiffTile;
        spec.attribute("ImageDescription", pages[p].description);
        // What readers know MIP levels in a TIFF by.
        spec.attribute("textureformat", "Plain Texture");
        const auto mode = p == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
        done = output->open(file.temporaryPath(), spec, mode) && output->write_image(spec.format, picture.data());
    }
    why = output ? output->geterror() : OIIO::geterror();
    if (output) done = output->close() && done;
    if (!done || !holds(file.temporaryPath(), pages)) {
        if (why.empty()) throw WorkError(path, Message(MessageId::DiskFull));
        throw WorkError(path, Message(MessageId::FileUnwritable, {{"why", oneLine(why)}}));
    }
    file.commit();
}

void writeDescribedTiff(const std::string& path, int width, int height, const PictureCodes& codes,
                        const std::string& description) {
    constexpr std::array kTypes{OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::UINT8};
    const Format& format = tiffFormatOf(path);
    OIIO::ImageSpec spec = specOf(width, height, 1, kTypes[codes.index()]);
    spec.attribute("ImageDescription", description);
    std::visit([&](const auto& all) { writePixels(path, format, spec, all.data()); }, codes);
}

}  // namespace relief
