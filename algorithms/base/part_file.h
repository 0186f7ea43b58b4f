// What all runs share that keep their work in FILE.part, so that they can go on after they were stopped.
#pragma once

#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>

namespace relief {

// What to do with FILE.part of an earlier run: refuse to start, go on with it (--resume), or begin again (--anew).
enum class EarlierRun : std::uint8_t { Refuse, Resume, Replace };

// Name of this machine; empty if the system does not report it.
inline std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace relief
