// The program `relief` as a function, so that tests run it in a process of their own without starting it anew: one
// command a file; here parsing, and every failure turned into one line and an exit status: 0 done, 1 the work failed,
// 2 bad usage or input, 128 + signal where it was interrupted.
#pragma once

namespace relief::app {

// arguments[0]: the program's name. Writes to standard output and standard error; to be called before any other thread
// is started. Returns the exit status.
int programMain(int count, char** arguments);

}  // namespace relief::app
