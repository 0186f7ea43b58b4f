// Lengths that the header of an OpenEXR file states, checked before the library takes memory for them.
#pragma once

#include <cstdint>
#include <string_view>

namespace relief {

// Fit: the headers end within the bytes, and each attribute has the length that its type demands. Wrong: one has
// another length. Incomplete: the bytes end before the headers do.
enum class ExrLengths : std::uint8_t { Fit, Wrong, Incomplete };

// Checks the lengths of attributes. The library takes memory of the stated length before it reads, so a file of 200
// bytes could cost two gigabytes; and it ignores the length of types that it knows, so what it reads next depends on
// these lengths being right. Other faults are left to the library. bytes: the file, or its beginning.
ExrLengths exrLengths(std::string_view bytes);

}  // namespace relief
