// Inputs that the fuzzer found worth keeping (tests/fuzz/inputs): each is read again by its reader.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "fuzz/targets.h"

namespace relief::fuzz {
namespace {

TEST(FuzzInputs, AreReadOrRefused) {
    for (const Target& target : targets()) {
        const std::filesystem::path folder = std::filesystem::path(RELIEF_FUZZ_INPUTS) / target.name;
        std::size_t read = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            SCOPED_TRACE(entry.path().string());
            std::ifstream file(entry.path(), std::ios::binary);
            const std::string bytes(std::istreambuf_iterator<char>(file), {});
            EXPECT_NO_THROW(run(target, bytes));
            ++read;
        }
        EXPECT_GT(read, 0U) << target.name;
    }
}

}  // namespace
}  // namespace relief::fuzz
