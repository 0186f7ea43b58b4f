// The pyramids of [MIP18] (figs. 2 and 3) as pictures: a tiled TIFF of 32-bit floats with one page per level, level 0
// (the heights themselves) first, marked as MIP levels, so that viewers and engines can read it without this program.
// The description of each page is JSON: kind, level, size and the meaning of its numbers; that of the last page also
// contains checksums.
#pragma once

#include <string>
#include <vector>

#include "images/pyramid.h"

namespace relief {

// "max-pyramid", "mean-pyramid": the kinds of `relief map` that no method reads from a file.
const std::vector<std::string>& pyramidMapKinds();
// The kind with such a name.
PyramidKind pyramidKindOf(const std::string& name);

inline constexpr int kPyramidFileVersion = 1;
// Saves a pyramid. path: .tif or .tiff; the file appears only when it is complete. Throws WorkError, InputError.
void savePyramid(const std::string& path, const Pyramid& pyramid);

}  // namespace relief
