#include "images/exr_header.h"

#include <array>
#include <cstdint>

#include <sys/types.h>

namespace relief {

namespace {

constexpr ::off_t kMagicAndVersion = 8;
constexpr unsigned kFlagOfParts = 0x10;  // in the second byte of the version: a header for each part

// Skips a text that ends with a zero. Returns its length; -1: the file ends in it.
std::int64_t skipText(std::FILE* file) {
    for (std::int64_t length = 0;; ++length) {
        const int c = std::getc(file);
        if (c == EOF) return -1;
        if (c == 0) return length;
    }
}

}  // namespace

bool exrAttributesFit(std::FILE* file) {
    if (::fseeko(file, 0, SEEK_END) != 0) return true;
    const ::off_t size = ::ftello(file);
    std::array<unsigned char, kMagicAndVersion> begin{};
    std::rewind(file);
    if (std::fread(begin.data(), 1, begin.size(), file) != begin.size()) return true;
    const bool parts = (begin[5] & kFlagOfParts) != 0;
    for (bool first = true;; first = false) {
        // An attribute: name, type, length in four bytes (the lowest first), value. An empty name ends a header, an
        // empty header the list of headers.
        const std::int64_t name = skipText(file);
        if (name < 0 || (name == 0 && (first || !parts))) return true;
        if (name == 0) {
            const int next = std::getc(file);
            if (next <= 0) return true;
            std::ungetc(next, file);
            continue;
        }
        std::array<unsigned char, 4> bytes{};
        if (skipText(file) < 0 || std::fread(bytes.data(), 1, bytes.size(), file) != bytes.size()) return true;
        const auto length =
            static_cast<::off_t>(bytes[0] | bytes[1] << 8U | bytes[2] << 16U) + (::off_t{bytes[3]} << 24U);
        if (length > size - ::ftello(file)) return false;
        if (::fseeko(file, length, SEEK_CUR) != 0) return true;
    }
}

}  // namespace relief
