#include "images/exr_header.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace relief {

namespace {

constexpr std::size_t kMagicAndVersion = 8;
constexpr unsigned kFlagOfParts = 0x10;  // in the second byte of the version: a header for each part

struct FixedType {
    std::string_view name;
    std::size_t length;
};
// "OpenEXR File Layout", section "Attribute types".
constexpr std::array kFixedTypes{
    FixedType{"box2i", 16},      FixedType{"box2f", 16},   FixedType{"chromaticities", 32},
    FixedType{"compression", 1}, FixedType{"double", 8},   FixedType{"envmap", 1},
    FixedType{"float", 4},       FixedType{"int", 4},      FixedType{"keycode", 28},
    FixedType{"lineOrder", 1},   FixedType{"m33f", 36},    FixedType{"m33d", 72},
    FixedType{"m44f", 64},       FixedType{"m44d", 128},   FixedType{"rational", 8},
    FixedType{"tiledesc", 9},    FixedType{"timecode", 8}, FixedType{"v2i", 8},
    FixedType{"v2f", 8},         FixedType{"v2d", 16},     FixedType{"v3i", 12},
    FixedType{"v3f", 12},        FixedType{"v3d", 24},     FixedType{"deepImageState", 1},
};

// Reads from the front of bytes; nothing if they end before.
std::optional<std::string_view> takeName(std::string_view& bytes) {
    const std::size_t end = bytes.find('\0');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view name = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    return name;
}
std::optional<std::uint32_t> takeNumber(std::string_view& bytes) {
    if (bytes.size() < 4) return std::nullopt;
    std::uint32_t number = 0;
    for (unsigned n = 0; n < 4; ++n) number |= std::uint32_t{static_cast<unsigned char>(bytes[n])} << (8 * n);
    bytes.remove_prefix(4);
    return number;
}

// Channels, each a name and 16 bytes; an empty name ends them.
bool isChannelList(std::string_view value) {
    constexpr std::size_t kOfChannel = 16;
    while (const auto name = takeName(value)) {
        if (name->empty()) return value.empty();
        if (value.size() < kOfChannel) return false;
        value.remove_prefix(kOfChannel);
    }
    return false;
}

bool isListOfTexts(std::string_view value) {
    while (!value.empty()) {
        const auto length = takeNumber(value);
        if (!length || *length > value.size()) return false;
        value.remove_prefix(*length);
    }
    return true;
}

bool isPreview(std::string_view value) {
    const auto width = takeNumber(value), height = takeNumber(value);
    return width && height && (*height == 0 || *width <= value.size() / *height) &&
           value.size() == std::size_t{4} * *width * *height;
}

bool fits(std::string_view type, std::string_view value) {
    if (type == "chlist") return isChannelList(value);
    if (type == "stringvector") return isListOfTexts(value);
    if (type == "preview") return isPreview(value);
    const auto* const fixed = std::ranges::find(kFixedTypes, type, &FixedType::name);
    return fixed == kFixedTypes.end() || fixed->length == value.size();
}

}  // namespace

ExrLengths exrLengths(std::string_view bytes) {
    if (bytes.size() < kMagicAndVersion) return ExrLengths::Incomplete;
    const bool parts = (static_cast<unsigned char>(bytes[5]) & kFlagOfParts) != 0;
    bytes.remove_prefix(kMagicAndVersion);
    // An attribute: name, type, length, value. An empty name ends a header; an empty header ends the list of headers.
    while (const auto name = takeName(bytes)) {
        if (name->empty()) {
            if (!parts || bytes.starts_with('\0')) return ExrLengths::Fit;
            continue;
        }
        const auto type = takeName(bytes);
        const auto length = type ? takeNumber(bytes) : std::nullopt;
        if (!length || *length > bytes.size()) break;
        if (!fits(*type, bytes.substr(0, *length))) return ExrLengths::Wrong;
        bytes.remove_prefix(*length);
    }
    return ExrLengths::Incomplete;
}

}  // namespace relief
