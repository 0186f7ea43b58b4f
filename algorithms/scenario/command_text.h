// Parts of `relief` command lines, quoted for a shell. Each argument follows a space.
#pragma once

#include <string>

#include "scenario/scenario.h"

namespace relief {

// Returns the options that name a height map and how it is read: " --height FILE --channel R".
std::string heightArguments(const Pictures& pictures);
// Returns those of --relief-depth, --address and --surface that are not the default.
std::string fieldArguments(double reliefDepth, Address address, Surface surface);

}  // namespace relief
