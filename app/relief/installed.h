// What belongs to the program and lies in other files, found from the program's own place: an installed tree may be
// moved.
#pragma once

#include <string>

namespace relief::app {

// The plug-in of this name ("relief_mpi.so"), whether it is there or not.
std::string pluginPath(const std::string& name);

// A file that comes with the program: a path that begins with "datasets/" or "lessons/" and leads nowhere from the
// working folder means the installed one, or the checkout's that the program was built from. Every other path is
// returned as it is. For files that are read.
std::string shippedFile(const std::string& path);

}  // namespace relief::app
