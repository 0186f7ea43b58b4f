// One target of targets.h for libFuzzer: RELIEF_FUZZ_TARGET names it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/targets.h"

namespace {

const relief::fuzz::Target& chosen() {
    const char* const name = std::getenv("RELIEF_FUZZ_TARGET");
    for (const relief::fuzz::Target& target : relief::fuzz::targets()) {
        if (name != nullptr && std::string_view(name) == target.name) return target;
    }
    std::fputs("RELIEF_FUZZ_TARGET must be one of:", stderr);
    for (const relief::fuzz::Target& target : relief::fuzz::targets()) std::fprintf(stderr, " %s", target.name);
    std::fputs("\n", stderr);
    std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const relief::fuzz::Target& target = chosen();
    relief::fuzz::run(target, {reinterpret_cast<const char*>(data), size});
    return 0;
}
