// A cache of the maps that methods precompute. A map is built when it is first needed, and only once even if several
// threads need it at the same time. The cache keeps within a memory budget by evicting the least recently used maps.
// The key contains exactly what a map depends on, so that changing the depth of a relief keeps its max pyramids.
#pragma once

#include <any>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// kind: "max-pyramid/bilinear/repeat", ...; heights: identifies the height map (HeightField::identity()), which the
// cache entry keeps alive.
struct MapKey {
    std::string kind;
    std::shared_ptr<const void> heights;

    bool operator<(const MapKey& other) const {
        return heights != other.heights ? heights.owner_before(other.heights) : kind < other.kind;
    }
};

// Thread safe.
class MapCache {
  public:
    explicit MapCache(std::size_t budgetBytes = std::size_t{4} << 30) : budget_(budgetBytes) {}

    // Returns the map of this key, calling `build` if there is none. If another thread is building it, waits for the
    // result; if that thread's work is cancelled, one of the waiting threads builds the map instead. T must have
    // bytes(). need: peak bytes of building, including the map. Throws MemoryError if they are not available, and
    // Cancelled. Adds to the counters CountMapBuilds, CountMapBytes and CountMapSeconds of the work.
    template <class T>
    std::shared_ptr<const T> get(const MapKey& key, std::uint64_t need, Work& work,
                                 const std::function<T(Work&)>& build) {
        auto map = find(key, need, work, [&](Work& w) -> Built {
            auto made = std::make_shared<const T>(build(w));
            return {made, made->bytes()};
        });
        return std::static_pointer_cast<const T>(map);
    }

    // Adds a map made elsewhere, such as one read from a file, which the next get() returns.
    template <class T>
    void put(const MapKey& key, std::shared_ptr<const T> map) {
        const std::size_t size = map->bytes();
        keep(key, {std::move(map), size});
    }

    // Returns the bytes of all maps in the cache.
    std::size_t bytes() const;
    std::size_t budget() const { return budget_; }
    // Removes all maps from the cache; maps in use remain valid.
    void clear();

  private:
    struct Built {
        std::shared_ptr<const void> map;
        std::size_t bytes = 0;
    };
    struct Entry {
        std::shared_ptr<const void> map;  // null while the map is being built
        std::size_t bytes = 0;
        std::uint64_t lastUse = 0;
        double buildSeconds = 0;
    };

    std::shared_ptr<const void> find(const MapKey& key, std::uint64_t need, Work& work,
                                     const std::function<Built(Work&)>& build);
    void keep(const MapKey& key, Built built);
    void evict();

    std::size_t budget_;
    mutable std::mutex mutex_;
    std::condition_variable done_;
    std::map<MapKey, Entry> entries_;
    std::uint64_t clock_ = 0;
};

}  // namespace relief
