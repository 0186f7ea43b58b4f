// Where a measurement was made: rows of benchmarks carry it, so that numbers of two machines are not mixed up.
#pragma once

#include <string>

namespace relief {

// "GCC 12.2.0 -O3 -DNDEBUG -ffp-contract=off": with the flags that decide about speed and bits.
std::string compilerText();
// The processor's name as the system tells it; "unknown" where it does not.
std::string cpuText();
// Of the sources when they were built, with "+" where files differed from it; "unknown" without git.
std::string commitText();

}  // namespace relief
