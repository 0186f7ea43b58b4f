#include "images/openimageio_rows.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "images/page_watch.h"
#include "images/system_error.h"
#include "relief/memory.h"

namespace relief {

TiffOnDisk::TiffOnDisk(const std::string& path)
    : IOProxy(path, Read), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (!file_.open() || ::fstat(file_.number(), &status) != 0 || status.st_size == 0)
        throw InputError(path, systemMessage(errno, FileAccess::Read));
    size_ = static_cast<std::size_t>(status.st_size);
    void* const map = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE, file_.number(), 0);
    if (map == MAP_FAILED) throw InputError(path, systemMessage(errno, FileAccess::Read));
    // A private mapping: hiding changes a copy of the directory's pages, not the file.
    const std::span<unsigned char> file(static_cast<unsigned char*>(map), size_);
    std::optional<PageWatch> watch(std::in_place, map, size_);
    const std::uint64_t depth = tiffDepth(file);
    const auto [first, last] = tiffDirectory(file);
    hideTiffMetadata(file);
    directoryAt_ = first;
    directory_.assign(file.begin() + static_cast<std::ptrdiff_t>(first),
                      file.begin() + static_cast<std::ptrdiff_t>(last));
    const bool lost = watch->lost();
    watch.reset();
    ::munmap(map, size_);
    if (lost) throw InputError(path, Message(MessageId::FileTruncated));
    if (depth > 1) throw InputError(path, Message(MessageId::PictureVolume, {{"depth", depth}}));
}

std::size_t TiffOnDisk::read(void* bytes, std::size_t count) {
    const std::size_t got = pread(bytes, count, m_pos);
    m_pos += static_cast<std::int64_t>(got);
    return got;
}

std::size_t TiffOnDisk::pread(void* bytes, std::size_t count, std::int64_t offset) {
    const ::ssize_t got = readAt(file_.number(), offset, bytes, count);
    if (got < 0) return 0;
    const auto done = static_cast<std::size_t>(got);
    const auto at = static_cast<std::size_t>(offset);
    const std::size_t first = std::max(at, directoryAt_);
    const std::size_t last = std::min(at + done, directoryAt_ + directory_.size());
    if (first < last)
        std::memcpy(static_cast<unsigned char*>(bytes) + (first - at), directory_.data() + (first - directoryAt_),
                    last - first);
    return done;
}

bool isReadByRows(const std::string& format, std::span<const unsigned char> head) {
    constexpr std::size_t kInterlace = 28;  // byte of a PNG file that tells whether it is interlaced
    if (format == "png") return head.size() > kInterlace && head[kInterlace] == 0;
    return format == "tiff" || format == "openexr" || format == "hdr" || format == "bmp" || format == "fits";
}

std::uint64_t RowReader::keptBytes(const OIIO::ImageSpec& spec) {
    // A sample of at most 8 bytes.
    return spec.tile_width == 0 ? 0
                                : byteProduct({8, static_cast<std::uint64_t>(spec.width),
                                               static_cast<std::uint64_t>(std::min(spec.tile_height, spec.height)),
                                               static_cast<std::uint64_t>(1 + spec.nchannels)});
}

bool RowReader::read(OIIO::ImageInput& input, int channel, OIIO::TypeDesc type, int first, int count,
                     std::byte* samples) {
    const OIIO::ImageSpec& spec = input.spec();
    const std::size_t rowBytes = static_cast<std::size_t>(spec.width) * type.size();
    if (spec.tile_width == 0)
        return input.read_scanlines(0, 0, spec.y + first, spec.y + first + count, 0, channel, channel + 1, type,
                                    samples);
    for (int y = first; y < first + count;) {
        if (channel != channel_ || y < begin_ || y >= end_) {
            channel_ = -1;
            begin_ = y / spec.tile_height * spec.tile_height;
            end_ = std::min(begin_ + spec.tile_height, spec.height);
            rows_.resize(rowBytes * static_cast<std::size_t>(end_ - begin_));
            if (!input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin_, spec.y + end_, 0, 1, channel,
                                  channel + 1, type, rows_.data()))
                return false;
            channel_ = channel;
        }
        const int rows = std::min(end_, first + count) - y;
        std::memcpy(samples + rowBytes * static_cast<std::size_t>(y - first),
                    rows_.data() + rowBytes * static_cast<std::size_t>(y - begin_),
                    rowBytes * static_cast<std::size_t>(rows));
        y += rows;
    }
    return true;
}

}  // namespace relief
