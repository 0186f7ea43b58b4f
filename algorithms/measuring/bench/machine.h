// Machine, compiler and version of a measurement: rows of benchmarks contain them, so that numbers of different
// machines are not confused.
#pragma once

#include <string>

namespace relief {

// Returns compiler and version with the flags that affect speed and bits, such as "GCC 12.2.0 -O3 -DNDEBUG
// -ffp-contract=off".
std::string compilerText();
// Returns the processor's name as the system reports it, or "unknown".
std::string cpuText();
// Returns the commit of the sources at build time, with "+" if files differed from it; "unknown" without git.
std::string commitText();

}  // namespace relief
