// Determines how much memory the process may still take, and refuses work that needs more before anything is allocated:
// Linux grants more memory than it has, and later kills this or another process when the memory is used.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>

namespace relief {

// Stands for "no limit", and for sums and products that overflow.
inline constexpr std::uint64_t kEndlessBytes = std::numeric_limits<std::uint64_t>::max();

// Requests below this many bytes are never checked, because reading the limits takes about 50 microseconds.
inline constexpr std::uint64_t kCheckedBytes = std::uint64_t{64} << 20U;

// Returns the product of the factors (width, height, bytes per pixel, ...); kEndlessBytes on overflow.
constexpr std::uint64_t byteProduct(std::initializer_list<std::uint64_t> factors) {
    std::uint64_t product = 1;
    for (const std::uint64_t factor : factors) {
        if (factor != 0 && product > kEndlessBytes / factor) return kEndlessBytes;
        product *= factor;
    }
    return product;
}

// Returns the sum of the terms; kEndlessBytes on overflow.
constexpr std::uint64_t byteSum(std::initializer_list<std::uint64_t> terms) {
    std::uint64_t sum = 0;
    for (const std::uint64_t term : terms) sum = term > kEndlessBytes - sum ? kEndlessBytes : sum + term;
    return sum;
}

// Returns the bytes that this process can allocate without harming others, the minimum of
// - MemAvailable of /proc/meminfo: free memory, and file cache that can be dropped;
// - for each memory control group of the process, and each group above it (versions 1 and 2): limit minus use, where
//   file cache that is not in active use does not count as used;
// - the limits on address space (ulimit -v) and on data (ulimit -d), minus the process's own use of each.
// Returns kEndlessBytes if none of these is known, as on systems without /proc. root: the folder that contains proc/
// and sys/, which only tests set to another one than "/". Thread safe; reads about ten small files.
std::uint64_t availableMemory(const std::string& root = "/");

// What the user can do about a refusal.
// SmallerOrTiled: as SmallerSize, for `relief render`, whose --tiled needs less.
enum class MemoryHint : std::uint8_t { None, SmallerSize, SmallerPicture, SmallerMap, SmallerOrTiled };

// Throws MemoryError if `bytes` more than the process has now exceed availableMemory(). The message states in one line
// what `subject` (an option, a file, a map) needs and what is available. Requests below kCheckedBytes always pass.
// Thread safe.
void requireMemory(std::uint64_t bytes, const std::string& subject, MemoryHint hint = MemoryHint::None);

}  // namespace relief
