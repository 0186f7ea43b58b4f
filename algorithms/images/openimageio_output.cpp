// Writes picture files by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>

#include "images/picture_library.h"
#include "images/system_error.h"

namespace relief {

namespace {

// Output file that records the first write error and reports success to the format's library: the libraries notice a
// full disk late or never, and some write to stderr about it.
class CheckedOutput : public OIIO::Filesystem::IOProxy {
  public:
    explicit CheckedOutput(const std::string& path)
        : IOProxy(path, Write), descriptor_(::open(path.c_str(), O_RDWR | O_TRUNC | O_CLOEXEC)) {
        if (descriptor_ < 0) error_ = errno;
    }
    ~CheckedOutput() override { finish(); }
    CheckedOutput(const CheckedOutput&) = delete;
    CheckedOutput& operator=(const CheckedOutput&) = delete;

    // Flushes and closes. Returns 0, or the errno of the first failure.
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
        std::size_t done = 0;
        while (done < count) {
            const auto at = offset + static_cast<std::int64_t>(done);
            const ::ssize_t got = ::pread(descriptor_, static_cast<char*>(bytes) + done, count - done, at);
            if (got == 0 || (got < 0 && errno != EINTR)) break;
            if (got > 0) done += static_cast<std::size_t>(got);
        }
        return done;
    }

  private:
    void keep(int error) {
        if (error_ == 0) error_ = error;
    }

    int descriptor_;
    int error_ = 0;
    std::int64_t size_ = 0;
};

OIIO::ImageSpec specOf(int width, int height, const std::vector<std::string>& channels, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), type);
    spec.channelnames = channels;
    // No channel is coverage, by which OpenImageIO would divide the others.
    if (std::find(channels.begin(), channels.end(), "A") != channels.end()) spec.attribute("oiio:UnassociatedAlpha", 1);
    // Level 4 is twice as fast as zlib's default 6 and makes files a tenth larger. Only the PNG writer reads this
    // attribute.
    spec.attribute("png:compressionLevel", 4);
    return spec;
}

// TIFF and OpenEXR files hold the time of writing. SOURCE_DATE_EPOCH, seconds since 1970, replaces it, so that a file
// can be made again byte for byte (reproducible-builds.org).
void setDate(OIIO::ImageSpec& spec) {
    const char* const text = std::getenv("SOURCE_DATE_EPOCH");
    if (text == nullptr) return;
    std::time_t seconds = 0;
    const auto [end, error] = std::from_chars(text, text + std::strlen(text), seconds);
    std::tm parts{};
    if (error != std::errc() || *end != '\0' || gmtime_r(&seconds, &parts) == nullptr) return;
    std::array<char, 64> date{};
    if (std::strftime(date.data(), date.size(), "%Y:%m:%d %H:%M:%S", &parts) > 0)
        spec.attribute("DateTime", date.data());
}

// Reads the file back and returns true if it holds exactly these pages.
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

void writeWithOpenImageIo(const std::string& path, const std::string& format, const PictureBlock& block) {
    const OIIO::TypeDesc type(block.type);
    OIIO::ImageSpec spec = specOf(block.width, block.height, block.channels, type);
    for (const auto& [name, text] : block.attributes) spec.attribute(name, text);
    if (format == "tiff" || format == "openexr") setDate(spec);
    const OIIO::TypeDesc given = type == OIIO::TypeDesc::HALF ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : type;
    // libjpeg ends the process at a longer side.
    constexpr int kLongestSideOfJpeg = 65500;
    if (format == "jpeg" && std::max(block.width, block.height) > kLongestSideOfJpeg) {
        const std::string why = "JPEG: at most " + std::to_string(kLongestSideOfJpeg) + " pixels per side";
        throw WorkError(path, Message(MessageId::FileUnwritable, {{"why", why}}));
    }
    AtomicFile file(path);
    CheckedOutput sink(file.temporaryPath());
    bool done = false;
    std::string why;
    if (const auto output = OIIO::ImageOutput::create(format)) {
        done = output->set_ioproxy(&sink) && output->open(file.temporaryPath(), spec) &&
               output->write_image(given, block.numbers);
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

void writePagesWithOpenImageIo(const std::string& path, const std::vector<DescribedPage>& pages) {
    AtomicFile file(path);
    std::string why;
    // OpenImageIO appends pages by reopening the file, which CheckedOutput does not support. Write errors are found by
    // reading the file back instead.
    const auto output = OIIO::ImageOutput::create("tiff");
    bool done = output != nullptr;
    for (std::size_t p = 0; done && p < pages.size(); ++p) {
        const FloatImage& picture = *pages[p].picture;
        OIIO::ImageSpec spec = specOf(picture.width(), picture.height(), {"Y"}, OIIO::TypeDesc::FLOAT);
        setDate(spec);
        spec.tile_width = kTiffTile;
        spec.tile_height = kTiffTile;
        spec.attribute("ImageDescription", pages[p].description);
        // Marks the pages as MIP levels for readers of TIFF textures.
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

}  // namespace relief
