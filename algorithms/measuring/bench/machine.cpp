#include "measuring/bench/machine.h"

#include <fstream>

#include "relief_commit.h"

#ifndef RELIEF_FLAGS
#define RELIEF_FLAGS ""
#endif

namespace relief {

namespace {

std::string compilerName() {
#if defined(__clang__)
    return "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
           std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
    return "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." +
           std::to_string(__GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

}  // namespace

std::string compilerText() {
    const std::string flags = RELIEF_FLAGS;
    return compilerName() + (flags.empty() ? "" : " " + flags);
}

std::string cpuText() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t colon = line.find(':');
        const std::size_t begin = colon == std::string::npos ? colon : line.find_first_not_of(" \t", colon + 1);
        if (begin != std::string::npos) return line.substr(begin);
    }
    return "unknown";
}

std::string commitText() {
    return RELIEF_COMMIT;
}

}  // namespace relief
