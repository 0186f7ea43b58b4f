// Finds files that belong to the program relative to the program's own location, because an installed tree may be
// moved.
#pragma once

#include <string>

namespace relief::app {

// Returns the path of the plug-in of this name ("relief_mpi.so"), whether or not it exists.
std::string pluginPath(const std::string& name);

// Resolves files that are shipped with the program. If `path` begins with "datasets/" or "lessons/" and does not exist
// in the working folder, returns the path of the installed file, or of the file in the checkout that the program was
// built from. Every other path is returned unchanged. For reading only.
std::string shippedFile(const std::string& path);

}  // namespace relief::app
