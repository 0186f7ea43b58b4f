// Runs of the program without loading it anew: half a second each time, most of it for the shared libraries.
//
// A process that has everything loaded, and has started no thread, waits from the beginning of the tests; for each run
// it forks a child, which calls what main() calls.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace relief::test {

struct ProgramRun {
    std::vector<std::string> arguments;                          // without the program's name
    std::vector<std::pair<std::string, std::string>> variables;  // besides those of this process
    std::string input, output, errors;                           // files
    std::int64_t largestFile = -1;                               // bytes a file may grow to
};

// First thing in main().
void startProgramServer();

// The status as waitpid() gives it; -1: the server is gone.
int runByServer(const ProgramRun& run);

}  // namespace relief::test
