#include "images/tiled_heights.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "images/file_descriptor.h"
#include "images/page_watch.h"
#include "images/system_error.h"
#include "images/tiled_pages.h"
#include "relief/memory.h"

namespace relief {

namespace {

// Groups that a thread may have begun to read when they were dropped are dropped once more after this many further
// ones, since its read has mapped them again.
constexpr std::size_t kDroppedAgain = 32;
// States of a group.
constexpr std::size_t kStates = kGroupBytes / kLeastTileBytes;

// Opens a file for reading; the descriptor is not open if that fails. A pipe without a writer does not block.
int openedToRead(const std::string& path) {
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

// Size of an open file. Throws InputError if it is not open, or not an ordinary file.
std::uint64_t sizeOf(const Descriptor& file, const std::string& path) {
    struct stat status {};
    if (!file.open() || ::fstat(file.number(), &status) != 0)
        throw InputError(path, systemMessage(errno, FileAccess::Read));
    requireRegular(path, status);
    return static_cast<std::uint64_t>(status.st_size);
}

// Reads `count` bytes. Throws WorkError if the file cannot be read, InputError if it ends before them.
void readFully(int descriptor, std::uint64_t at, std::byte* to, std::size_t count, const std::string& path) {
    const ::ssize_t got = readAt(descriptor, static_cast<std::int64_t>(at), to, count);
    if (got < 0) throw WorkError(path, systemMessage(errno, FileAccess::Read));
    if (got != static_cast<::ssize_t>(count)) throw InputError(path, Message(MessageId::FileTruncated));
}

// The file in memory, as a private copy: only pages that are written take memory of the process, so that what is
// resident is what was loaded. (A page of the file that is read takes its neighbours with it, since Linux 6.18 up to
// 2 MB.) At an address that is a multiple of kGroupBytes.
class Mapping {
  public:
    Mapping(int descriptor, std::uint64_t bytes, const std::string& path) : bytes_(bytes) {
        reserved_ = bytes + kGroupBytes;
        void* const place = ::mmap(nullptr, reserved_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (place == MAP_FAILED) fail(path);
        place_ = place;
        const auto address = reinterpret_cast<std::uintptr_t>(place);
        auto* const aligned = static_cast<std::byte*>(place) + ((kGroupBytes - address % kGroupBytes) % kGroupBytes);
        void* const map =
            ::mmap(aligned, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED | MAP_NORESERVE, descriptor, 0);
        if (map == MAP_FAILED) {
            const int error = errno;
            ::munmap(place_, reserved_);
            errno = error;
            fail(path);
        }
        first_ = static_cast<std::byte*>(map);
        // A page that is mapped again must not pull its neighbours from the disk.
        static_cast<void>(::madvise(first_, bytes_, MADV_RANDOM));
        watch_.emplace(first_, bytes_);
    }
    ~Mapping() {
        watch_.reset();
        ::munmap(place_, reserved_);
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    const std::byte* first() const { return first_; }
    // Returns true if zeros have been read in place of the file.
    bool lost() const { return watch_->lost(); }
    // Copies a tile, whose bytes are those of the file, to its place. Threads may read it meanwhile, since no byte
    // changes.
    __attribute__((no_sanitize("thread"))) void load(std::uint64_t at, std::span<const std::uint64_t> tile) const {
        auto* const to = reinterpret_cast<volatile std::uint64_t*>(first_ + at);
        for (std::size_t i = 0; i < tile.size(); ++i) to[i] = tile[i];
    }
    // Takes a group out of memory. Safe while threads read it: they find the same bytes in the file.
    void drop(std::uint64_t group) const {
        static_cast<void>(::madvise(first_ + (group << kGroupShift), kGroupBytes, MADV_DONTNEED));
    }

  private:
    [[noreturn]] static void fail(const std::string& path) {
        throw MemoryError(path, systemMessage(errno, FileAccess::Read));
    }

    std::uint64_t bytes_, reserved_;
    void* place_ = nullptr;
    std::byte* first_ = nullptr;
    std::optional<PageWatch> watch_;
};

}  // namespace

struct TiledHeights::Cache {
    // descriptor: owned.
    Cache(std::unique_ptr<Descriptor> opened, const TiledHeights& heights)
        : file(std::move(opened)), map(file->number(), heights.layout_.fileBytes, heights.path_) {}

    std::unique_ptr<Descriptor> file;
    Mapping map;
    std::vector<std::uint64_t> checksums;
    std::size_t tableBytes = 0;

    std::mutex mutex;                    // guards what follows, and the changes of states other than resident to used
    std::deque<std::uint64_t> groups;    // those with resident tiles; the first goes first
    std::vector<std::uint8_t> resident;  // by group: the size of its resident tiles, in units of kLeastTileBytes
    std::size_t most = 0;                // of these units in all
    std::array<std::uint64_t, kDroppedAgain> dropped{};

    std::atomic<std::uint64_t> tilesRead{0}, bytesRead{0}, misses{0}, evictions{0};
    std::atomic<std::size_t> taken{0};  // units of kLeastTileBytes

    void readChecksums(const TiledHeights& heights, std::uint64_t checksum);
    void load(const TiledHeights& heights, const TilePage& page, std::uint64_t at);
    void dropUnused(std::atomic<std::uint8_t>* states);
    void requireWhole(const TiledHeights& heights) const;
};

void TiledHeights::Cache::readChecksums(const TiledHeights& heights, std::uint64_t checksum) {
    checksums.resize(heights.layout_.checksumBytes() / sizeof(std::uint64_t));
    auto* const bytes = reinterpret_cast<std::byte*>(checksums.data());
    const std::size_t count = checksums.size() * sizeof(std::uint64_t);
    readFully(file->number(), heights.layout_.checksums, bytes, count, heights.path_);
    if (tileChecksum(bytes, count) != checksum) throw InputError(heights.path_, Message(MessageId::TiledTableDamaged));
}

void TiledHeights::Cache::requireWhole(const TiledHeights& heights) const {
    if (!map.lost()) return;
    const std::uint64_t size = sizeOf(*file, heights.path_), whole = heights.layout_.fileBytes;
    if (size < whole)
        throw InputError(heights.path_, Message(MessageId::TiledTruncated, {{"bytes", size}, {"whole", whole}}));
    throw WorkError(heights.path_, systemMessage(EIO, FileAccess::Read));
}

// The clock algorithm: drops the first group; groups used since their last turn get another one instead.
void TiledHeights::Cache::dropUnused(std::atomic<std::uint8_t>* states) {
    for (;;) {
        const std::uint64_t group = groups.front();
        groups.pop_front();
        std::atomic<std::uint8_t>* const first = states + group * kStates;
        bool used = false;
        for (std::size_t i = 0; i < kStates; ++i) {
            // Readers may have marked it as used again since it was made unused: another round would find none unused
            // only if they marked every group faster than their turns come.
            if (first[i].load(std::memory_order_relaxed) != kUsed) continue;
            first[i].store(kResident, std::memory_order_relaxed);
            used = true;
        }
        if (used) {
            groups.push_back(group);
            continue;
        }
        for (std::size_t i = 0; i < kStates; ++i) first[i].store(kAbsent, std::memory_order_release);
        taken -= std::exchange(resident[group], 0);
        map.drop(group);
        const std::uint64_t before = std::exchange(dropped[evictions++ % kDroppedAgain], group);
        if (resident[before] == 0) map.drop(before);
        return;
    }
}

void TiledHeights::Cache::load(const TiledHeights& heights, const TilePage& page, std::uint64_t at) {
    ++misses;
    std::array<std::uint64_t, kTileTexels * sizeof(float) / sizeof(std::uint64_t)> words;
    auto* const tile = reinterpret_cast<std::byte*>(words.data());
    // Reading the bytes before they are accessed in the mapping turns errors of the disk into exceptions.
    requireWhole(heights);
    readFully(file->number(), at, tile, page.tileBytes(), heights.path_);
    if (tileChecksum(tile, page.tileBytes()) != checksums[page.placeIndex(at)]) {
        const auto [x, y] = page.tileAt(at);
        throw InputError(heights.path_,
                         Message(MessageId::TiledTileDamaged,
                                 {{"kind", tileKindName(page.kind)}, {"level", page.level}, {"x", x}, {"y", y}}));
    }
    ++tilesRead;
    bytesRead += page.tileBytes();
    const std::lock_guard lock(mutex);
    std::atomic<std::uint8_t>& state = heights.states_[at >> kStateShift];
    if (state.load(std::memory_order_relaxed) != kAbsent) return;  // loaded by another thread meanwhile
    const std::size_t units = page.tileBytes() >> kStateShift;
    while (taken + units > most && !groups.empty()) dropUnused(heights.states_.get());
    std::uint8_t& ofGroup = resident[at >> kGroupShift];
    if (ofGroup == 0) groups.push_back(at >> kGroupShift);
    ofGroup = static_cast<std::uint8_t>(ofGroup + units);
    taken += units;
    map.load(at, std::span(words).first(page.tileBytes() / sizeof(std::uint64_t)));
    requireWhole(heights);
    // Not yet as used: what is read once only goes before what is read again.
    state.store(kResident, std::memory_order_release);
}

TiledHeights::TiledHeights(std::string path, std::size_t residentBytes) : path_(std::move(path)) {
    auto file = std::make_unique<Descriptor>(openedToRead(path_));
    const std::uint64_t size = sizeOf(*file, path_);
    if (size == 0) throw InputError(path_, Message(MessageId::FileEmpty));
    const auto head = readTiledHead(file->number());
    if (!head) throw InputError(path_, Message(MessageId::TiledNot));
    layout_ = head->layout;
    checksum_ = head->checksum;
    if (size < layout_.fileBytes)
        throw InputError(path_, Message(MessageId::TiledTruncated, {{"bytes", size}, {"whole", layout_.fileBytes}}));
    const std::size_t states = (layout_.fileBytes + kLeastTileBytes - 1) >> kStateShift;
    const std::size_t groups = (layout_.checksums + kGroupBytes - 1) >> kGroupShift;
    const std::size_t tables = layout_.checksumBytes() + states + groups;
    requireMemory(tables, path_);
    cache_ = std::make_unique<Cache>(std::move(file), *this);
    cache_->readChecksums(*this, head->checksum);
    cache_->tableBytes = tables;
    cache_->resident.resize(groups);
    states_ = std::make_unique<std::atomic<std::uint8_t>[]>(states + sizeof(std::int32_t) - 1);
    map_ = cache_->map.first();
    limit_ = residentBytes;
    cache_->most = residentBytes < tables ? 0 : (residentBytes - tables) >> kStateShift;
    setAccess();
}

void TiledHeights::setAccess() {
    const TilePage& heights = layout_.pages.front();
    access_.map = map_;
    if (layout_.fileBytes >> kStateShift < std::uint64_t{1} << 31) access_.states = states_.get();
    access_.type = layout_.type;
    access_.tileBytesShift = heights.tileBytesShift;
    access_.acrossShift = heights.acrossShift;
    access_.downShift = heights.downShift;
    for (int level = 0; level < layout_.levels; ++level) {
        const TilePage& page = layout_.page(TileKind::Max, level);
        const auto at = static_cast<std::size_t>(level);
        access_.firstGroup[at] = static_cast<std::int32_t>(page.first >> kGroupShift);
        access_.groupsAcross[at] = page.groupsAcross;
    }
}

TiledHeights::~TiledHeights() = default;

std::shared_ptr<TiledHeights> TiledHeights::open(const std::string& path, std::size_t residentBytes) {
    // The constructor is private.
    return std::shared_ptr<TiledHeights>(new TiledHeights(path, residentBytes));
}

bool TiledHeights::isTiled(const std::string& path) {
    const Descriptor file(openedToRead(path));
    return file.open() && beginsTiled(file.number());
}

void TiledHeights::touch(const TilePage& page, std::uint64_t at, std::atomic<std::uint8_t>& state) const {
    // Only from resident to used: if the tile is dropped at the same moment, it stays absent.
    std::uint8_t seen = kResident;
    if (state.compare_exchange_strong(seen, kUsed, std::memory_order_acq_rel) || seen == kUsed) return;
    cache_->load(*this, page, at);
}

void TiledHeights::prefetch(std::span<const TileRange> ranges) const {
    for (const TileRange& range : ranges) {
        const TilePage& page = layout_.page(range.kind, range.level);
        const int left = std::max(range.left, 0) >> kTileShift >> page.acrossShift;
        const int top = std::max(range.top, 0) >> kTileShift >> page.downShift;
        const int right = std::min(range.right, page.width - 1) >> kTileShift >> page.acrossShift;
        const int bottom = std::min(range.bottom, page.height - 1) >> kTileShift >> page.downShift;
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                const std::uint64_t at = page.tileOffset(x << page.acrossShift, y << page.downShift);
                const std::atomic<std::uint8_t>* const states = states_.get() + (at >> kStateShift);
                const bool any = std::any_of(states, states + kStates, [](const std::atomic<std::uint8_t>& state) {
                    return state.load(std::memory_order_relaxed) != kAbsent;
                });
                if (any) continue;
                static_cast<void>(::posix_fadvise(cache_->file->number(), static_cast<::off_t>(at),
                                                  static_cast<::off_t>(kGroupBytes), POSIX_FADV_WILLNEED));
            }
        }
    }
}

void TiledHeights::requireWhole() const {
    cache_->requireWhole(*this);
}

TileStatistics TiledHeights::statistics() const {
    return {cache_->tilesRead, cache_->bytesRead, cache_->misses, cache_->evictions};
}

std::size_t TiledHeights::residentBytes() const {
    return cache_->tableBytes + (cache_->taken.load(std::memory_order_relaxed) << kStateShift);
}

}  // namespace relief
