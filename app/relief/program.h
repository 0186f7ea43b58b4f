// The program `relief`, one command a file: parsing, and every failure turned into one line and an exit status.
#pragma once

namespace relief::app {

// Returns the exit status: see session.h; 128 + the signal's number where it was interrupted. Takes over the signals of
// the process: once, from the main thread.
int runProgram(int count, char** arguments);

}  // namespace relief::app
