// The program `relief`, with one command per file: parses the arguments and turns every failure into one line and an
// exit status.
#pragma once

namespace relief::app {

// Returns the exit status (see session.h), or 128 + the number of the signal that interrupted the work. Takes over the
// signal handling of the process; call it once, from the main thread.
int runProgram(int count, char** arguments);

}  // namespace relief::app
