// JSON as lines of a file, and what such lines say, which may be anything.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace relief::app {

using Json = nlohmann::ordered_json;

// One line of printable ASCII, without "\n"; bytes that are no UTF-8 (file names may hold them) are replaced.
std::string asciiLine(const Json& json);
// As it will be read from a file: numbers and names take the form that a file gives them.
Json readBack(const Json& json);

// A member of an object; null where there is none.
const Json* member(const Json& json, const char* name);
// The same as a whole number or as text; where it is not there, or of another type: `otherwise`, or nothing.
std::int64_t numberIn(const Json& json, const char* name, std::int64_t otherwise);
std::string textIn(const Json& json, const char* name);

}  // namespace relief::app
