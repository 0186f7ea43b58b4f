// The readers of everything that comes from outside, each as a function of the file's bytes: for libFuzzer
// (fuzz_main.cpp), and for the tests that read the kept inputs again.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace relief::fuzz {

struct Target {
    const char* name;  // and folder of its inputs in tests/fuzz/inputs
    // Reads the bytes as a file would be read. Errors of the program (InputError, ...) are caught; every other
    // exception, and every crash, is a fault of the program.
    void (*read)(std::string_view bytes);
};

std::span<const Target> targets();
// Calls the target's function. Ends quietly where the program refuses the bytes with one of its own errors.
void run(const Target& target, std::string_view bytes);

}  // namespace relief::fuzz
