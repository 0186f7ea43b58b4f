// What belongs to the program and lies in other files, found from the program's own place: an installed tree may be
// moved.
#pragma once

#include <string>

namespace relief::app {

// The plug-in of this name ("relief_mpi.so"), whether it is there or not.
std::string pluginPath(const std::string& name);

}  // namespace relief::app
