#include "images/tiled_part.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "images/file_descriptor.h"
#include "images/file_replacing.h"
#include "images/tiled_levels.h"
#include "images/tiled_pages.h"
#include "relief/files.h"
#include "relief/memory.h"

namespace relief {

namespace {

constexpr std::uint64_t kMagic = 0x31747261506c6552;  // "RelPart1"
constexpr std::uint64_t kMostLearned = 4096;          // bytes
constexpr std::uint64_t kBlock = 4096;                // bytes

// What a state in the file begins with; then follow the work, what was learned, and the levels, filled up to a multiple
// of kChecksumChunk bytes.
struct StateHead {
    std::uint64_t magic = kMagic;
    std::uint64_t sequence = 0;
    std::uint64_t bands = 0;
    std::uint64_t work = 0, learned = 0, levels = 0;  // bytes
    std::uint64_t unused = 0;
    std::uint64_t checksum = 0;  // of all this with 0 for itself
};
static_assert(sizeof(StateHead) % kChecksumChunk == 0);

std::uint64_t roundedUp(std::uint64_t bytes, std::uint64_t unit) {
    return (bytes + unit - 1) / unit * unit;
}

std::uint64_t stateBytes(std::uint64_t work, std::uint64_t learned, std::uint64_t levels) {
    return sizeof(StateHead) + roundedUp(work + learned + levels, kChecksumChunk);
}

}  // namespace

TiledPart::TiledPart(const std::string& path, const TiledLayout& layout, const std::string& work, EarlierRun earlier)
    : path_(path),
      target_(linkTarget(path)),
      part_(target_ + ".part"),
      work_(work),
      layout_(layout),
      most_(roundedUp(stateBytes(work.size(), kMostLearned, TiledLevels::savedBytes(layout)), kBlock)) {
    requireMemory(layout_.checksumBytes(), path_);
    checksums_.resize(layout_.checksumBytes() / sizeof(std::uint64_t));
    // Fails now if the file cannot be replaced in the end.
    const AtomicFile probe(path_);
    try {
        open(earlier);
    } catch (...) {
        close();
        throw;
    }
}

TiledPart::~TiledPart() {
    close();
}

void TiledPart::close() {
    if (descriptor_ < 0) return;
    // Unlinked before it is unlocked, so that no other run can take it up in between.
    if (!finished_ && kept_ == 0) ::unlink(part_.c_str());
    ::close(descriptor_);
}

void TiledPart::fail(int error) const {
    throwUnwritable(path_, error, path_);
}

void TiledPart::open(EarlierRun earlier) {
    descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const bool fresh = descriptor_ >= 0;
    if (!fresh && errno != EEXIST) fail(errno);
    if (!fresh && earlier == EarlierRun::Refuse) throw InputError(part_, Message(MessageId::SweepThere));
    if (!fresh) descriptor_ = ::open(part_.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    kept_ = fresh ? 0 : 1;  // what an exception leaves alone
    lock();
    takePermissions(descriptor_, target_);
    if (!fresh && earlier == EarlierRun::Resume && !untouched()) {
        findEarlier();
        kept_ = earlier_->bands;
        return;
    }
    kept_ = 0;
    // What was there is gone, and places that are never written hold zeros.
    if (::ftruncate(descriptor_, 0) != 0 || ::ftruncate(descriptor_, static_cast<::off_t>(placeOfState(2))) != 0)
        fail(errno);
    reserve();
    keep({});
}

// Locks the file, so that a second run with the same output cannot write it. File systems without locks are trusted.
void TiledPart::lock() {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    bool taken = ::fcntl(descriptor_, F_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN);
    // Another run may have finished, and renamed this file, since it was opened.
    struct stat here {};
    struct stat named {};
    if (!taken && ::fstat(descriptor_, &here) == 0 && ::stat(part_.c_str(), &named) == 0)
        taken = here.st_ino != named.st_ino || here.st_dev != named.st_dev;
    if (!taken) return;
    if (::fcntl(descriptor_, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) lock.l_pid = 0;
    throw InputError(part_, Message(MessageId::SweepAlive, {{"process", lock.l_pid}, {"host", hostName()}}));
}

// Reserves the places of the journal and of the checksums, so that they can be written when the disk is full. A file
// system that cannot do this is no error.
void TiledPart::reserve() {
    const auto from = static_cast<::off_t>(layout_.checksums);
    const auto count = static_cast<::off_t>(placeOfState(2)) - from;
    if (::fallocate(descriptor_, 0, from, count) != 0 && errno != EOPNOTSUPP && errno != ENOSYS) fail(errno);
}

std::optional<TiledPart::State> TiledPart::stateAt(int place, std::uint64_t& sequence) const {
    StateHead head;
    const auto at = static_cast<std::int64_t>(placeOfState(place));
    if (readAt(descriptor_, at, &head, sizeof head) != sizeof head || head.magic != kMagic) return std::nullopt;
    if (std::max({head.work, head.learned, head.levels}) > most_) return std::nullopt;
    const std::uint64_t bytes = stateBytes(head.work, head.learned, head.levels);
    if (bytes > most_) return std::nullopt;
    std::vector<std::byte> all(bytes);
    if (readAt(descriptor_, at, all.data(), bytes) != static_cast<::ssize_t>(bytes)) return std::nullopt;
    const std::uint64_t checksum = std::exchange(head.checksum, 0);
    std::memcpy(all.data(), &head, sizeof head);
    if (tileChecksum(all.data(), bytes) != checksum) return std::nullopt;
    const auto* const text = reinterpret_cast<const char*>(all.data()) + sizeof head;
    if (std::string_view(text, head.work) != work_) return std::nullopt;
    sequence = head.sequence;
    const std::byte* const levels = all.data() + sizeof head + head.work + head.learned;
    return State{static_cast<std::int64_t>(head.bands), std::string(text + head.work, head.learned),
                 std::vector<std::byte>(levels, levels + head.levels)};
}

// Returns true if the run that created the file was killed before it wrote anything.
bool TiledPart::untouched() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) return false;
    if (status.st_size == 0) return true;
    if (static_cast<std::uint64_t>(status.st_size) != placeOfState(2)) return false;
    for (const std::uint64_t at : {std::uint64_t{0}, placeOfState(0), placeOfState(1)}) {
        std::array<std::byte, sizeof(StateHead)> bytes{};
        if (readAt(descriptor_, static_cast<std::int64_t>(at), bytes.data(), bytes.size()) !=
                static_cast<::ssize_t>(bytes.size()) ||
            bytes != std::array<std::byte, sizeof(StateHead)>{})
            return false;
    }
    return true;
}

void TiledPart::findEarlier() {
    for (const int place : {0, 1}) {
        std::uint64_t sequence = 0;
        auto state = stateAt(place, sequence);
        if (!state || (earlier_ && sequence < sequence_)) continue;
        earlier_ = std::move(state);
        sequence_ = sequence;
    }
    if (!earlier_) throw InputError(part_, Message(MessageId::SweepOther));
    const auto at = static_cast<std::int64_t>(layout_.checksums);
    if (readAt(descriptor_, at, checksums_.data(), table().size()) != static_cast<::ssize_t>(table().size()))
        throw InputError(part_, Message(MessageId::FileTruncated));
}

void TiledPart::write(std::uint64_t at, const void* bytes, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
        const ::ssize_t wrote = ::pwrite(descriptor_, static_cast<const char*>(bytes) + done, count - done,
                                         static_cast<::off_t>(at + done));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) fail(errno);
        if (wrote == 0) fail(ENOSPC);
        done += static_cast<std::size_t>(wrote);
    }
}

void TiledPart::writeTiles(const TilePage& page, std::uint64_t offset, std::span<const std::byte> tiles) {
    write(offset, tiles.data(), tiles.size());
    for (std::size_t at = 0; at < tiles.size(); at += page.tileBytes())
        checksums_[page.placeIndex(offset + at)] = tileChecksum(tiles.data() + at, page.tileBytes());
}

void TiledPart::keep(const State& state) {
    std::vector<std::byte> all(stateBytes(work_.size(), state.learned.size(), state.levels.size()));
    if (all.size() > most_) fail(EFBIG);
    StateHead head{.sequence = sequence_ + 1,
                   .bands = static_cast<std::uint64_t>(state.bands),
                   .work = work_.size(),
                   .learned = state.learned.size(),
                   .levels = state.levels.size()};
    std::byte* to = all.data() + sizeof head;
    to = std::copy_n(reinterpret_cast<const std::byte*>(work_.data()), work_.size(), to);
    to = std::copy_n(reinterpret_cast<const std::byte*>(state.learned.data()), state.learned.size(), to);
    std::copy(state.levels.begin(), state.levels.end(), to);
    std::memcpy(all.data(), &head, sizeof head);
    head.checksum = tileChecksum(all.data(), all.size());
    std::memcpy(all.data(), &head, sizeof head);
    write(layout_.checksums, checksums_.data(), table().size());
    // The tiles first: a state must not speak of tiles that are lost.
    if (::fdatasync(descriptor_) != 0 && errno != EINVAL) fail(errno);
    write(placeOfState(static_cast<int>(head.sequence % 2)), all.data(), all.size());
    if (::fdatasync(descriptor_) != 0 && errno != EINVAL) fail(errno);
    sequence_ = head.sequence;
    kept_ = state.bands;
}

void TiledPart::finish() {
    const std::vector<std::byte> head = tiledHead(layout_, tileChecksum(table().data(), table().size()));
    write(layout_.checksums, checksums_.data(), table().size());
    write(0, head.data(), head.size());
    if (::ftruncate(descriptor_, static_cast<::off_t>(layout_.fileBytes)) != 0 ||
        (::fsync(descriptor_) != 0 && errno != EINVAL))
        fail(errno);
    replaceFile(part_, target_, path_);
    finished_ = true;
}

}  // namespace relief
