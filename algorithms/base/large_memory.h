// Memory for maps that are read here and there: on large pages, where the system has them. Reading a map of many
// megabytes at random, the processor otherwise looks up the place of nearly every page anew.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "relief/memory.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace relief {

template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    explicit LargePages(const LargePages<U>& /*other*/) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (!isLarge(bytes)) return static_cast<T*>(::operator new(bytes));
        requireMemory(bytes, "");
        const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
        void* memory = std::aligned_alloc(kPage, whole);
        if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
        // A wish: without large pages all works as before.
        (void)madvise(memory, whole, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        if (isLarge(count * sizeof(T))) {
            std::free(memory);
        } else {
            ::operator delete(memory);
        }
    }
    bool operator==(const LargePages& /*other*/) const {
        return true;
    }

  private:
    static constexpr std::size_t kPage = std::size_t{2} << 20U;
    // Below, hardly more is read than is remembered of places; and what is left of the last page would be too much.
    static bool isLarge(std::size_t bytes) {
        return bytes >= 4 * kPage;
    }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace relief
