// Maps that methods precompute: built when first needed, once, however many ask at the same time; kept within a memory
// budget, the longest unused going first. Keyed by what they depend on, so that changing the relief's depth keeps the
// max pyramids.
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

// kind: "max-pyramid/bilinear/repeat", ...; heights: identity of the height map (kept alive by the entry).
struct MapKey {
    std::string kind;
    std::shared_ptr<const FloatImage> heights;

    bool operator<(const MapKey& other) const {
        return heights != other.heights ? heights.owner_before(other.heights) : kind < other.kind;
    }
};

class MapCache {
  public:
    explicit MapCache(std::size_t budgetBytes = std::size_t{4} << 30) : budget_(budgetBytes) {}

    // The map of this key; built by `build` if there is none. Whoever comes while it is being built waits for it; if
    // the builder is cancelled, one of those who wait builds it instead. T has bytes().
    // need: bytes that building takes at most, the map among them. Throws MemoryError where they are not free.
    // Counts CountMapBuilds, CountMapBytes and CountMapSeconds in the work's counters.
    template <class T>
    std::shared_ptr<const T> get(const MapKey& key, std::uint64_t need, Work& work,
                                 const std::function<T(Work&)>& build) {
        auto map = find(key, need, work, [&](Work& w) -> Built {
            auto made = std::make_shared<const T>(build(w));
            return {made, made->bytes()};
        });
        return std::static_pointer_cast<const T>(map);
    }

    // A map made elsewhere, such as one read from a file: the next get() finds it.
    template <class T>
    void put(const MapKey& key, std::shared_ptr<const T> map) {
        const std::size_t size = map->bytes();
        keep(key, {std::move(map), size});
    }

    std::size_t bytes() const;
    std::size_t budget() const { return budget_; }
    void clear();

  private:
    struct Built {
        std::shared_ptr<const void> map;
        std::size_t bytes = 0;
    };
    struct Entry {
        std::shared_ptr<const void> map;  // null while it is being built
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
