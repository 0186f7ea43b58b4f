// The pyramids of [MIP18] (figs. 2 and 3) as pictures: a tiled TIFF of 32-bit floats, a page a level, level 0 (the
// heights themselves) first, marked as MIP levels, so that viewers and engines read it without this program. Each
// page's description is JSON: kind, level, size and what its numbers mean; the last one's also holds checksums.
#pragma once

#include <string>
#include <vector>

#include "images/pyramid.h"

namespace relief {

// "max-pyramid", "mean-pyramid": kinds of `relief map` that no method is given as a file.
const std::vector<std::string>& pyramidMapKinds();
// Of such a name.
PyramidKind pyramidKindOf(const std::string& name);

inline constexpr int kPyramidFileVersion = 1;
// path: .tif or .tiff; appears only when complete. Throws WorkError, InputError.
void savePyramid(const std::string& path, const Pyramid& pyramid);

}  // namespace relief
