// Runs of the program without loading its shared libraries again, which takes half a second per start.
//
// startProgramServer() forks a server at the start of main(), before a test can start a thread: a forked child has only
// the thread that called fork(). For each run the server forks a child that calls what the program's main() calls.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace relief::test {

struct ProgramRun {
    std::vector<std::string> arguments;                          // without the program's name
    std::vector<std::pair<std::string, std::string>> variables;  // added to those of this process
    std::string input, output, errors;                           // file names
    std::int64_t largestFile = -1;                               // limit of a file's size, in bytes
};

// To be called first in main(). Aborts if the server cannot be started.
void startProgramServer();

// Returns the status as waitpid() does; -1 if the server has ended.
int runByServer(const ProgramRun& run);

}  // namespace relief::test
