#include "relief/map_cache.h"

#include <chrono>
#include <utility>

#include "relief/maps/map_memory.h"
#include "relief/memory.h"

namespace relief {

namespace {

// Memory of the maps and of the heights that they keep alive. Heights count once: the entries of one height map are
// adjacent.
template <class Entries>
std::size_t heldBytes(const Entries& entries) {
    std::size_t total = 0;
    const void* last = nullptr;
    for (const auto& [key, entry] : entries) {
        total += entry.bytes;
        // The memory of heights that are read by tiles has a bound of its own.
        const bool image = key.heights && !key.kind.starts_with(kTiledKind);
        if (image && key.heights.get() != last) total += static_cast<const FloatImage*>(key.heights.get())->bytes();
        last = key.heights.get();
    }
    return total;
}

}  // namespace

std::shared_ptr<const void> MapCache::find(const MapKey& key, std::uint64_t need, Work& work,
                                           const std::function<Built(Work&)>& build) {
    std::unique_lock lock(mutex_);
    for (;;) {
        const auto found = entries_.find(key);
        if (found == entries_.end()) break;
        if (found->second.map) {
            found->second.lastUse = ++clock_;
            return found->second.map;
        }
        // The wait ends at intervals, so that a waiting request can be cancelled.
        done_.wait_for(lock, std::chrono::milliseconds(20));
        work.throwIfStopped();
    }
    entries_.emplace(key, Entry{});
    lock.unlock();
    Built built;
    const auto begin = std::chrono::steady_clock::now();
    try {
        requireMemory(need, "map " + key.kind.substr(0, key.kind.find('/')), MemoryHint::SmallerMap);
        built = build(work);
        work.throwIfStopped();
    } catch (...) {
        lock.lock();
        entries_.erase(key);
        done_.notify_all();
        throw;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    work.counters().add(MessageId::CountMapBuilds, 1);
    work.counters().add(MessageId::CountMapBytes, static_cast<double>(built.bytes));
    work.counters().add(MessageId::CountMapSeconds, seconds);
    lock.lock();
    Entry& entry = entries_[key];
    entry = {built.map, built.bytes, ++clock_, seconds};
    evict();
    done_.notify_all();
    return built.map;
}

void MapCache::keep(const MapKey& key, Built built) {
    const std::lock_guard lock(mutex_);
    entries_[key] = {std::move(built.map), built.bytes, ++clock_, 0};
    evict();
    done_.notify_all();
}

void MapCache::evict() {
    while (heldBytes(entries_) > budget_) {
        auto oldest = entries_.end();
        for (auto it = entries_.begin(); it != entries_.end(); ++it) {
            if (!it->second.map || it->second.lastUse == clock_) continue;
            if (oldest == entries_.end() || it->second.lastUse < oldest->second.lastUse) oldest = it;
        }
        if (oldest == entries_.end()) return;
        entries_.erase(oldest);
    }
}

std::size_t MapCache::bytes() const {
    const std::lock_guard lock(mutex_);
    return heldBytes(entries_);
}

void MapCache::clear() {
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [](const auto& item) { return item.second.map != nullptr; });
}

}  // namespace relief
