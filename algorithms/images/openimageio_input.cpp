// Opens, checks and reads picture files by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>

#include "images/exr_header.h"
#include "images/file_descriptor.h"
#include "images/openimageio_rows.h"
#include "images/picture_bytes.h"
#include "images/picture_library.h"
#include "images/system_error.h"
#include "relief/memory.h"

namespace relief {

namespace {

constexpr std::size_t kHeadBytes = 65536;

// Formats without a signature, recognised by file extension. Formats in neither list are refused: movies, volumes,
// camera raw and medical pictures (their libraries write to stderr), and Maya IFF, DPX, ICO, SGI and DDS (OpenImageIO
// 2.4 crashes on damaged files).
constexpr std::array<std::string_view, 3> kFormatsByName{"targa", "rla", "heif"};

std::string formatByName(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return {};
    const std::string extension = lowerCase(path.substr(dot + 1));
    // Has the form "targa:tga,tpic;webp:webp;...".
    const std::string list = OIIO::get_string_attribute("extension_list");
    for (const std::string_view format : kFormatsByName) {
        const std::size_t at = (";" + list).find(";" + std::string(format) + ":");
        if (at == std::string::npos) continue;
        const std::size_t from = at + format.size() + 1;
        const std::string known = "," + list.substr(from, list.find(';', at) - from) + ",";
        if (known.find("," + extension + ",") != std::string::npos) return std::string(format);
    }
    return {};
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Opens ordinary files only: opening a pipe would wait for its writer.
File openRegular(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) throw InputError(path, systemMessage(errno, FileAccess::Read));
    requireRegular(path, status);
    File file(std::fopen(path.c_str(), "rbe"));
    if (!file) throw InputError(path, systemMessage(errno, FileAccess::Read));
    if (status.st_size == 0) throw InputError(path, Message(MessageId::FileEmpty));
    return file;
}

Bytes readBytes(std::FILE* file, std::size_t size, const std::string& path) {
    Bytes bytes(size);
    bytes.resize(std::fread(bytes.data(), 1, size, file));
    if (std::ferror(file) != 0) throw InputError(path, systemMessage(errno, FileAccess::Read));
    return bytes;
}

Bytes wholeFile(std::FILE* file, const std::string& path) {
    if (::fseeko(file, 0, SEEK_END) != 0) throw InputError(path, systemMessage(errno, FileAccess::Read));
    const auto size = static_cast<std::size_t>(std::max<::off_t>(0, ::ftello(file)));
    // The bytes and their cleaned copy.
    requireMemory(byteProduct({2, size}), path, MemoryHint::SmallerPicture);
    std::rewind(file);
    return readBytes(file, size, path);
}

void checkSize(const std::string& path, std::int64_t width, std::int64_t height, std::int64_t maxPixels) {
    if (width <= 0 || height <= 0)
        throw InputError(path, Message(MessageId::PictureEmpty, {{"width", width}, {"height", height}}));
    // Divides instead of multiplying, because the product may overflow. FloatImage stores its sides as int.
    const std::int64_t largest = std::min<std::int64_t>(maxPixels, std::numeric_limits<std::int64_t>::max() / 64);
    if (width > largest / height || std::max(width, height) > std::numeric_limits<int>::max())
        throw InputError(
            path, Message(MessageId::PictureTooLarge, {{"width", width}, {"height", height}, {"limit", maxPixels}}));
}

// Refuses a header that promises far more pixels than the file can hold, before memory is taken for them: a file of a
// kilobyte must not cost a gigabyte. No compression stores more pixels per byte, except of blank pages for fax
// machines: deflate reaches 1032 bytes, or 8256 pixels of one bit; tables of missing tiles of 256 x 256, 8192.
void checkPlausible(const std::string& path, std::int64_t width, std::int64_t height) {
    constexpr std::int64_t kPixelsPerByte = 1 << 15, kAlwaysRead = 1 << 20;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error || width * height <= kAlwaysRead || static_cast<std::uintmax_t>(width * height / kPixelsPerByte) <= bytes)
        return;
    throw InputError(path,
                     Message(MessageId::PictureImplausible,
                             {{"width", width}, {"height", height}, {"bytes", static_cast<std::int64_t>(bytes)}}));
}

// Enforces libpng's own limit on sides, which libpng would report on stderr.
void checkPngSides(const std::string& path, DeclaredSize size) {
    constexpr std::uint32_t kLimit = 1000000;
    if (size.width <= kLimit && size.height <= kLimit) return;
    throw InputError(path, Message(MessageId::PictureSideTooLong,
                                   {{"width", size.width}, {"height", size.height}, {"limit", kLimit}}));
}

[[noreturn]] void throwDamaged(const std::string& path, const std::string& libraryText) {
    const std::string why = oneLine(libraryText);
    if (why.empty()) throw InputError(path, Message(MessageId::FileTruncated));
    throw InputError(path, Message(MessageId::FileDamaged, {{"why", why}}));
}

std::optional<NumberType> numberType(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
            return NumberType::UInt8;
        case OIIO::TypeDesc::INT8:
            return NumberType::Int8;
        case OIIO::TypeDesc::UINT16:
            return NumberType::UInt16;
        case OIIO::TypeDesc::INT16:
            return NumberType::Int16;
        case OIIO::TypeDesc::UINT32:
            return NumberType::UInt32;
        case OIIO::TypeDesc::INT32:
            return NumberType::Int32;
        case OIIO::TypeDesc::HALF:
        case OIIO::TypeDesc::FLOAT:
            return NumberType::Float;
        case OIIO::TypeDesc::DOUBLE:
            return NumberType::Double;
        default:
            return std::nullopt;
    }
}

// The type in which pixels are requested from OpenImageIO: the file's own, so that nothing is converted, except half,
// which becomes float (exact).
OIIO::TypeDesc readType(const OIIO::TypeDesc& type) {
    return type.basetype == OIIO::TypeDesc::HALF ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : type;
}

// Bytes per pixel that PictureInput::read() keeps. If all channels have one type, these are all channels from the first
// requested to the last.
std::size_t bytesRead(const OIIO::ImageSpec& spec, std::span<const int> channels) {
    std::size_t bytes = 0;
    if (!spec.channelformats.empty()) {
        for (const int c : channels) bytes += readType(spec.channelformat(c)).size();
        return bytes;
    }
    const auto [low, high] = std::minmax_element(channels.begin(), channels.end());
    return static_cast<std::size_t>(*high + 1 - *low) * readType(spec.format).size();
}

// Progress callback of OpenImageIO, called between rows; returning true stops the reading.
bool stopRequested(void* work, float) {
    return static_cast<const Work*>(work)->stopped();
}

struct LoadedFile {
    std::string format;
    bool byRows = true;                  // OpenImageIO decodes it by rows or tiles
    Bytes bytes;                         // cleaned; empty if it is read from the disk
    std::unique_ptr<TiffOnDisk> onDisk;  // a TIFF file for PictureAccess::Rows
};

// Checks the file before any library reads it, and loads what must be cleaned first.
LoadedFile loadFile(const std::string& path, std::int64_t maxPixels, PictureAccess access) {
    const File file = openRegular(path);
    const Bytes head = readBytes(file.get(), kHeadBytes, path);
    std::string format(formatBySignature(head));
    if (format.empty()) format = formatByName(path);
    if (format.empty()) throw InputError(path, Message(MessageId::FileNotPicture));
    const std::optional<DeclaredSize> size = declaredSize(format, head);
    if (size) checkSize(path, size->width, size->height, maxPixels);
    LoadedFile loaded{.format = format, .byRows = isReadByRows(format, head), .bytes = {}, .onDisk = {}};
    Bytes& bytes = loaded.bytes;
    if (format == "png") {
        if (size) checkPngSides(path, *size);
        auto clean = cleanPng(wholeFile(file.get(), path));
        if (!clean) throwDamaged(path, {});
        bytes = std::move(*clean);
    } else if (format == "jpeg") {
        bytes = cleanJpeg(wholeFile(file.get(), path));
    } else if (format == "tiff" && access == PictureAccess::Rows) {
        loaded.onDisk = std::make_unique<TiffOnDisk>(path);
    } else if (format == "tiff") {
        bytes = wholeFile(file.get(), path);
        if (const std::uint64_t depth = tiffDepth(bytes); depth > 1)
            throw InputError(path, Message(MessageId::PictureVolume, {{"depth", depth}}));
        hideTiffMetadata(bytes);
    } else if (format == "openexr" && !exrAttributesFit(file.get())) {
        throwDamaged(path, {});
    }
    return loaded;
}

class OpenImageIoFile final : public PictureFile {
  public:
    OpenImageIoFile(const std::string& path, std::int64_t maxPixels, PictureAccess access);

    ImageInfo info() const override;
    std::string attribute(const std::string& name) const override {
        return std::string(input_->spec().get_string_attribute(name));
    }
    int alphaChannel() const override { return input_->spec().alpha_channel; }
    RawPlanes read(std::span<const int> channels, Work& work, std::size_t bytesAfter) override;
    NumberType type(int channel) const override { return *numberType(input_->spec().channelformat(channel)); }
    void readRows(int channel, int first, int count, std::byte* samples) override;

  private:
    void requireRowMemory() const;
    bool open(std::string& why);
    void checkSpec(std::int64_t maxPixels) const;

    std::string path_;
    // Declared before the input, which reads from these bytes and so must be destroyed first.
    LoadedFile file_;
    std::optional<OIIO::Filesystem::IOMemReader> memory_;
    OIIO::ImageInput::unique_ptr input_;
    RowReader rows_;
};

OpenImageIoFile::OpenImageIoFile(const std::string& path, std::int64_t maxPixels, PictureAccess access) : path_(path) {
    try {
        file_ = loadFile(path, maxPixels, access);
        if (!file_.bytes.empty()) memory_.emplace(file_.bytes.data(), file_.bytes.size());
        input_ = OIIO::ImageInput::create(file_.format);
        if (!input_) {
            OIIO::geterror();
            throw InputError(path, Message(MessageId::FileNotPicture));
        }
        std::string why;
        if (!open(why)) throwDamaged(path, why);
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MemoryError(path, systemMessage(ENOMEM, FileAccess::Read));
    } catch (const std::exception& fault) {
        throwDamaged(path, fault.what());
    }
    checkSpec(maxPixels);
    if (access == PictureAccess::Rows) requireRowMemory();
}

bool OpenImageIoFile::open(std::string& why) {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    if (memory_ && !input_->set_ioproxy(&*memory_)) return false;
    if (file_.onDisk && !input_->set_ioproxy(file_.onDisk.get())) return false;
    OIIO::ImageSpec spec;
    const bool done = input_->open(path_, spec, hints);
    // Fetching the error also clears warnings about metadata, which would look like a failure to read the pixels.
    why = input_->geterror();
    return done;
}

void OpenImageIoFile::checkSpec(std::int64_t maxPixels) const {
    const OIIO::ImageSpec& spec = input_->spec();
    checkSize(path_, spec.width, spec.height, maxPixels);
    checkPlausible(path_, spec.width, spec.height);
    if (spec.depth > 1) throw InputError(path_, Message(MessageId::PictureVolume, {{"depth", spec.depth}}));
    if (spec.deep) throw InputError(path_, Message(MessageId::PictureDeep));
    if (spec.nchannels < 1) throw InputError(path_, Message(MessageId::FileNotPicture));
    for (int c = 0; c < spec.nchannels; ++c)
        if (!numberType(spec.channelformat(c)))
            throw InputError(path_, Message(MessageId::PictureNumberType, {{"type", spec.channelformat(c).c_str()}}));
    // OpenImageIO 2.4 returns zeros for these types and reports success.
    const bool doubles = spec.format.basetype == OIIO::TypeDesc::DOUBLE;
    if (doubles && input_->format_name() == std::string_view("tiff") && (spec.tile_width > 0 || spec.height == 1))
        throw InputError(path_, Message(MessageId::PictureDoubles));
}

ImageInfo OpenImageIoFile::info() const {
    const OIIO::ImageSpec& spec = input_->spec();
    return {path_,
            input_->format_name(),
            spec.width,
            spec.height,
            spec.channelnames,
            spec.format.c_str(),
            attribute("oiio:ColorSpace")};
}

RawPlanes OpenImageIoFile::read(std::span<const int> channels, Work& work, std::size_t bytesAfter) {
    const OIIO::ImageSpec& spec = input_->spec();
    const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    requireMemory(byteProduct({pixels, bytesRead(spec, channels) + bytesAfter}), path_, MemoryHint::SmallerPicture);
    RawPlanes raw;
    const auto readBlock = [&](int from, int to) {
        const OIIO::TypeDesc type = readType(spec.channelformat(from));
        const auto count = static_cast<std::size_t>(to - from);
        raw.storage.push_back(std::make_unique<std::byte[]>(pixels * count * type.size()));
        OIIO::ImageInput& input = *input_;
        const bool done = input.read_image(0, 0, from, to, type, raw.storage.back().get(), OIIO::AutoStride,
                                           OIIO::AutoStride, OIIO::AutoStride, &stopRequested, &work);
        work.throwIfStopped();
        // libjpeg treats a truncated file as a warning: it fills the rest with grey, and read_image reports success.
        const std::string why = input.geterror();
        if (!done || !why.empty()) throwDamaged(path_, why);
    };
    const auto plane = [&](const std::byte* block, int from, int channel, int stride) {
        const OIIO::TypeDesc type = readType(spec.channelformat(channel));
        raw.planes.push_back({block + static_cast<std::size_t>(channel - from) * type.size(),
                              static_cast<std::size_t>(stride), *numberType(type)});
    };
    const auto [low, high] = std::minmax_element(channels.begin(), channels.end());
    try {
        if (spec.channelformats.empty()) {
            readBlock(*low, *high + 1);
            for (const int c : channels) plane(raw.storage.back().get(), *low, c, *high + 1 - *low);
        } else {
            for (const int c : channels) {
                readBlock(c, c + 1);
                plane(raw.storage.back().get(), c, c, 1);
            }
        }
    } catch (const std::bad_alloc&) {
        throw MemoryError(path_, Message(MessageId::PictureNoMemory, {{"width", spec.width}, {"height", spec.height}}));
    }
    return raw;
}

// Memory for the rows of tiles, or for the whole picture where OpenImageIO decodes that at once.
void OpenImageIoFile::requireRowMemory() const {
    const OIIO::ImageSpec& spec = input_->spec();
    std::uint64_t bytes = RowReader::keptBytes(spec);
    if (!file_.byRows) bytes = byteSum({bytes, spec.image_bytes(true)});
    requireMemory(bytes, path_, MemoryHint::SmallerPicture);
}

void OpenImageIoFile::readRows(int channel, int first, int count, std::byte* samples) {
    try {
        const OIIO::TypeDesc type = readType(input_->spec().channelformat(channel));
        const bool done = rows_.read(*input_, channel, type, first, count, samples);
        // As in read(): a warning means that rows are missing.
        const std::string why = input_->geterror();
        if (!done || !why.empty()) throwDamaged(path_, why);
    } catch (const std::bad_alloc&) {
        throw MemoryError(path_, systemMessage(ENOMEM, FileAccess::Read));
    }
}

}  // namespace

std::unique_ptr<PictureFile> openWithOpenImageIo(const std::string& path, std::int64_t maxPixels,
                                                 PictureAccess access) {
    return std::make_unique<OpenImageIoFile>(path, maxPixels, access);
}

}  // namespace relief
