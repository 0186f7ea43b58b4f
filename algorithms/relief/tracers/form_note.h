// Notes on the forms of methods, for lists.
#pragma once

#include <string>

namespace relief {

// Returns a sentence that says why the method has no SIMD version, or with which options it has none; empty if it
// always has one. Throws InputError for unknown names.
std::string formNote(const std::string& name);

}  // namespace relief
