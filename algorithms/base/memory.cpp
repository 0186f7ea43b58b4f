#include "relief/memory.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "relief/errors.h"

namespace relief {

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    if (stream) text << stream.rdbuf();
    return std::move(text).str();
}

// Parses the number at the beginning of the text, after blanks. std::nullopt if there is none ("max", "unlimited").
std::optional<std::uint64_t> leadingNumber(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return std::nullopt;
    std::uint64_t number = 0;
    const auto parsed = std::from_chars(text.data() + first, text.data() + text.size(), number);
    return parsed.ec == std::errc() ? std::optional(number) : std::nullopt;
}

// Parses the number after `name` in the first line that begins with it.
std::optional<std::uint64_t> numberOf(std::string_view text, std::string_view name) {
    for (std::size_t line = 0; line < text.size();) {
        const std::string_view rest = text.substr(line);
        if (rest.starts_with(name)) return leadingNumber(rest.substr(name.size()));
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) break;
        line += end + 1;
    }
    return std::nullopt;
}

std::uint64_t less(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

// File and key names of one version of Linux control groups.
struct GroupFiles {
    const char* limit;
    const char* used;
    const char* inactive;  // keys in memory.stat
    const char* active;
};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file ", "active_file "};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file ",
                               "total_active_file "};

std::uint64_t freeInGroup(const fs::path& folder, const GroupFiles& files) {
    const auto limit = leadingNumber(textOf(folder / files.limit));
    const auto used = leadingNumber(textOf(folder / files.used));
    if (!limit || !used) return kEndlessBytes;
    const std::string state = textOf(folder / "memory.stat");
    // As in the kernel's MemAvailable, half of the active file cache counts as reclaimable.
    const std::uint64_t cache =
        byteSum({numberOf(state, files.inactive).value_or(0), numberOf(state, files.active).value_or(0) / 2});
    return less(*limit, less(*used, cache));
}

// The least free memory of the group and its ancestors. Inside a container the path may be the host's and lead nowhere;
// the walk upwards then reaches the container's own group at the mount point.
std::uint64_t freeInGroups(const fs::path& mount, std::string_view path, const GroupFiles& files) {
    std::uint64_t bytes = kEndlessBytes;
    fs::path group = fs::path(path).relative_path();
    while (true) {
        bytes = std::min(bytes, freeInGroup(mount / group, files));
        if (group.empty()) return bytes;
        group = group.parent_path();
    }
}

std::uint64_t freeInAllGroups(const fs::path& root) {
    const fs::path mount = root / "sys/fs/cgroup";
    std::uint64_t bytes = kEndlessBytes;
    std::istringstream lines(textOf(root / "proc/self/cgroup"));
    // Format of a line: "0::/path" in version 2, "4:cpu,memory:/path" in version 1.
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = std::string(",").append(line, first + 1, second - first - 1).append(",");
        const std::string_view path = std::string_view(line).substr(second + 1);
        if (controllers == ",,") {
            for (const char* folder : {"", "unified"})
                bytes = std::min(bytes, freeInGroups(mount / folder, path, kVersion2));
        } else if (controllers.find(",memory,") != std::string::npos) {
            bytes = std::min(bytes, freeInGroups(mount / "memory", path, kVersion1));
        }
    }
    return bytes;
}

std::uint64_t freeByLimits(const fs::path& root) {
    const std::string limits = textOf(root / "proc/self/limits"), status = textOf(root / "proc/self/status");
    const auto left = [&](const char* limit, const char* used) {
        const auto bytes = numberOf(limits, limit);
        return bytes ? less(*bytes, byteProduct({numberOf(status, used).value_or(0), 1024})) : kEndlessBytes;
    };
    return std::min(left("Max address space", "VmSize:"), left("Max data size", "VmData:"));
}

MessageId sentenceOf(MemoryHint hint) {
    switch (hint) {
        case MemoryHint::SmallerSize:
            return MessageId::MemoryForSize;
        case MemoryHint::SmallerOrTiled:
            return MessageId::MemoryForWhole;
        case MemoryHint::SmallerPicture:
            return MessageId::MemoryForPicture;
        case MemoryHint::SmallerMap:
            return MessageId::MemoryForMap;
        case MemoryHint::None:
            break;
    }
    return MessageId::MemoryShort;
}

}  // namespace

std::uint64_t availableMemory(const std::string& folder) {
    const fs::path root = folder;
    const auto kilobytes = numberOf(textOf(root / "proc/meminfo"), "MemAvailable:");
    const std::uint64_t machine = kilobytes ? byteProduct({*kilobytes, 1024}) : kEndlessBytes;
    return std::min({machine, freeInAllGroups(root), freeByLimits(root)});
}

void requireMemory(std::uint64_t bytes, const std::string& subject, MemoryHint hint) {
    if (bytes < kCheckedBytes) return;
    const std::uint64_t available = availableMemory();
    if (bytes <= available) return;
    constexpr double kGiga = 1e9;
    constexpr int kDigits = 3;
    const auto text = [](std::uint64_t count) { return numberText(static_cast<double>(count) / kGiga, kDigits); };
    throw MemoryError(subject, Message(sentenceOf(hint), {{"needed", text(bytes)}, {"available", text(available)}}));
}

}  // namespace relief
