// What the process has in memory, for tests and benchmarks.
#pragma once

#include <fstream>

#include <unistd.h>

namespace relief::test {

inline double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace relief::test
