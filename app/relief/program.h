// The program `relief`, one command a file: parsing, and every failure turned into one line and an exit status.
#pragma once

namespace relief::app {

// Returns the exit status: 0 done, 1 the work failed, 2 bad usage or input, or more memory needed than is free,
// 128 + signal where it was interrupted. Takes over the signals of the process: once, from the main thread.
int runProgram(int count, char** arguments);

}  // namespace relief::app
