// Runs of the program without loading its shared libraries anew, which takes half a second of a start.
//
// startProgramServer() forks a server at the start of main(), before a test can start a thread; a forked child has only
// the thread that called fork(). For each run the server forks a child that calls what the program's main() calls.
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

// First thing in main(). Aborts where there can be no server.
void startProgramServer();

// The status as waitpid() gives it; -1: the server is gone.
int runByServer(const ProgramRun& run);

}  // namespace relief::test
