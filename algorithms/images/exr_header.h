// Lengths that the header of an OpenEXR file states, checked before the library takes memory for them.
#pragma once

#include <cstdio>

namespace relief {

// Returns whether no attribute of the file's headers is longer than what follows it in the file. The library takes
// memory of the stated length before it reads the attribute, so a file of 200 bytes could cost two gigabytes. Other
// faults are left to the library. The file's position changes. Cost: reads the headers. Throws nothing.
bool exrAttributesFit(std::FILE* file);

}  // namespace relief
