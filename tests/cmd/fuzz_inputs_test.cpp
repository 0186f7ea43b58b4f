// Inputs that the fuzzer found worth keeping (tests/fuzz/inputs), read again by their readers, and random changes of
// them: what libFuzzer does with more care (tests/run --fuzz).
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "fuzz/targets.h"
#include "measuring/random_rays.h"

namespace relief::fuzz {
namespace {

constexpr std::uint64_t kSeed = 3;

// The inputs of a target by file name, in the order of the names.
std::map<std::string, std::string> inputsOf(const Target& target) {
    std::map<std::string, std::string> inputs;
    const std::filesystem::path folder = std::filesystem::path(RELIEF_FUZZ_INPUTS) / target.name;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        inputs[entry.path().filename().string()] = testing::bytesOf(entry.path().string());
    }
    return inputs;
}

// Replaces, removes or repeats some bytes, or puts a part of another input in their place.
std::string changed(std::string bytes, const std::string& other, Random& random) {
    const auto at = [&](const std::string& text) {
        return static_cast<std::size_t>(random.below(static_cast<int>(text.size()) + 1));
    };
    const int changes = 1 + random.below(4);
    for (int n = 0; n < changes; ++n) {
        const std::size_t place = at(bytes), count = static_cast<std::size_t>(random.below(16));
        switch (random.below(5)) {
            case 0:
                if (place < bytes.size()) bytes[place] = static_cast<char>(random.below(256));
                break;
            case 1:
                if (place < bytes.size()) bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.below(8)));
                break;
            case 2:
                bytes.erase(place, count);
                break;
            case 3:
                bytes.insert(place, bytes.substr(at(bytes), count));
                break;
            default:
                bytes.replace(place, std::min(count, bytes.size() - place), other.substr(at(other), count));
        }
    }
    return bytes;
}

TEST(FuzzInputs, AreReadOrRefused) {
    for (const Target& target : targets()) {
        const auto inputs = inputsOf(target);
        EXPECT_FALSE(inputs.empty()) << target.name;
        for (const auto& [name, bytes] : inputs) EXPECT_NO_THROW(run(target, bytes)) << target.name << "/" << name;
    }
}

TEST(FuzzInputs, ChangedAtRandomAreReadOrRefused) {
    const int perInput = std::getenv("RELIEF_LONG") != nullptr ? 20'000 : 100;
    std::cout << "seed " << kSeed << ", " << perInput << " changes of each input:";
    Random random(kSeed);
    for (const Target& target : targets()) {
        std::cout << ' ' << target.name << std::flush;  // names the reader that ends the process
        const auto inputs = inputsOf(target);
        for (const auto& [name, bytes] : inputs) {
            for (int n = 0; n < perInput; ++n) {
                const std::uint64_t before = random.bits();
                Random own(before);
                const std::string input = changed(bytes, inputs.begin()->second, own);
                EXPECT_NO_THROW(run(target, input)) << target.name << "/" << name << ", numbers from " << before;
            }
        }
    }
    std::cout << '\n';
}

}  // namespace
}  // namespace relief::fuzz
