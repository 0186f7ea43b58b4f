#include "images/placed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "images/file_descriptor.h"
#include "images/file_replacing.h"
#include "images/system_error.h"

namespace relief {

namespace {

constexpr std::uint64_t kCopied = std::uint64_t{1} << 22;  // bytes at a time

// Returns 0 or an errno.
int writeAt(int descriptor, std::uint64_t at, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ::ssize_t wrote = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<::off_t>(at));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) return wrote < 0 ? errno : ENOSPC;
        bytes = bytes.subspan(static_cast<std::size_t>(wrote));
        at += static_cast<std::uint64_t>(wrote);
    }
    return 0;
}

std::uint64_t checksumOf(std::span<const std::byte> bytes) {
    const std::size_t whole = bytes.size() / kChecksumChunk * kChecksumChunk;
    std::array<std::byte, kChecksumChunk> rest{};
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(whole), bytes.end(), rest.begin());
    return tileChecksum(bytes.data(), whole) ^ tileChecksum(rest.data(), rest.size());
}

// Throws InputError unless the open file is one of that layout.
void checkPart(const PlacedPart& part, const Descriptor& file) {
    struct stat status {};
    if (!file.open() || ::fstat(file.number(), &status) != 0)
        throw InputError(part.path, systemMessage(errno, FileAccess::Read));
    const std::vector<std::byte> head = part.layout.head();
    std::vector<std::byte> there(head.size());
    const bool read = readAt(file.number(), 0, there.data(), there.size()) == static_cast<::ssize_t>(there.size());
    if (!read || there != head || static_cast<std::uint64_t>(status.st_size) != part.layout.fileBytes())
        throw InputError(part.path, Message(MessageId::FileTruncated));
}

PlacedPicture wholeOf(const std::vector<PlacedPart>& parts) {
    PlacedPicture whole = parts.front().layout.picture();
    whole.end = whole.height;
    whole.text.clear();
    return whole;
}

}  // namespace

PlacedFile::PlacedFile(std::string path, PictureLayout layout)
    : path_(std::move(path)), target_(linkTarget(path_)), rows_(target_ + ".rows"), layout_(std::move(layout)) {
    const AtomicFile probe(path_);
}

PlacedFile::~PlacedFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    if (::access((target_ + ".part").c_str(), F_OK) != 0) ::unlink(rows_.c_str());
}

void PlacedFile::fail(int error) const {
    throwUnwritable(path_, error, path_);
}

void PlacedFile::open(bool keep) {
    descriptor_ = ::open(rows_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | (keep ? 0 : O_TRUNC), 0666);
    if (descriptor_ < 0) fail(errno);
    takePermissions(descriptor_, target_);
    const std::uint64_t bytes = layout_.fileBytes();
    while (::fallocate(descriptor_, 0, 0, static_cast<::off_t>(bytes)) != 0) {
        if (errno == EINTR) continue;
        // Such file systems report a full disk later.
        if (errno == EOPNOTSUPP || errno == ENOSYS) return;
        failReserving(errno);
    }
}

void PlacedFile::failReserving(int error) const {
    constexpr double kGiga = 1e9;
    constexpr int kDigits = 3;
    try {
        fail(error);
    } catch (const WorkError& fault) {
        const double size = static_cast<double>(layout_.fileBytes()) / kGiga;
        throw WorkError(path_, Message(MessageId::PictureDisk,
                                       {MessageValue("why", fault.message()), {"size", numberText(size, kDigits)}}));
    }
}

std::uint64_t PlacedFile::write(int first, std::span<const std::byte> rows) {
    if (const int error = writeAt(descriptor_, layout_.place(first), rows); error != 0) fail(error);
    return checksumOf(rows);
}

bool PlacedFile::holds(int first, int count, std::uint64_t checksum) const {
    std::vector<std::byte> rows(layout_.place(first + count) - layout_.place(first));
    const auto at = static_cast<std::int64_t>(layout_.place(first));
    return readAt(descriptor_, at, rows.data(), rows.size()) == static_cast<::ssize_t>(rows.size()) &&
           checksumOf(rows) == checksum;
}

void PlacedFile::finish() {
    if (const int error = writeAt(descriptor_, 0, layout_.head()); error != 0) fail(error);
    // The file may be longer if another command of the same output has left it.
    if (::ftruncate(descriptor_, static_cast<::off_t>(layout_.fileBytes())) != 0 ||
        (::fsync(descriptor_) != 0 && errno != EINVAL))
        fail(errno);
    replaceFile(rows_, target_, path_);
    ::close(std::exchange(descriptor_, -1));
}

void joinPlaced(const std::vector<PlacedPart>& parts, const std::string& path, Work& work) {
    const PictureLayout whole(wholeOf(parts));
    AtomicFile output(path);
    const auto fail = [&](int error) { throwUnwritable(path, error, path); };
    Descriptor file(::open(output.temporaryPath().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!file.open()) fail(errno);
    const auto write = [&](std::uint64_t at, std::span<const std::byte> bytes) {
        if (const int error = writeAt(file.number(), at, bytes); error != 0) fail(error);
    };
    write(0, whole.head());
    work.progress().begin("merge", static_cast<std::int64_t>(whole.fileBytes() / kCopied));
    std::vector<std::byte> bytes(kCopied);
    for (const PlacedPart& part : parts) {
        const Descriptor from(::open(part.path.c_str(), O_RDONLY | O_CLOEXEC));
        checkPart(part, from);
        const PlacedPicture& rows = part.layout.picture();
        std::uint64_t to = whole.place(rows.begin), at = part.layout.place(rows.begin);
        for (const std::uint64_t end = part.layout.fileBytes(); at < end;) {
            work.throwIfStopped();
            const std::span<std::byte> some(bytes.data(), std::min(kCopied, end - at));
            if (readAt(from.number(), static_cast<std::int64_t>(at), some.data(), some.size()) !=
                static_cast<::ssize_t>(some.size()))
                throw InputError(part.path, Message(MessageId::FileTruncated));
            write(to, some);
            at += some.size(), to += some.size();
            work.progress().advance();
        }
    }
    if (const int error = file.close(); error != 0) fail(error);
    output.commit();
}

}  // namespace relief
