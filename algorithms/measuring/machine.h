// Where a measurement was made: rows of benchmarks carry it, so that numbers of two machines are not mixed up.
#pragma once

#include <string>

namespace relief {

// "GCC 12.2.0", "Clang 16.0.6".
std::string compilerText();
// The processor's name as the system tells it; "unknown" where it does not.
std::string cpuText();
// Of the sources when they were configured; "unknown" without git.
std::string commitText();

}  // namespace relief
