// JSON as lines of a file, and tolerant access to members of such lines, which may hold any JSON.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace relief::app {

using Json = nlohmann::ordered_json;

// Returns one line of printable ASCII, without "\n"; bytes that are not valid UTF-8 (file names may contain them) are
// replaced.
std::string asciiLine(const Json& json);
// Returns the JSON as it will be read back from a file, with numbers and strings in the form that a file gives them.
Json readBack(const Json& json);

// Returns a member of an object; null if there is none.
const Json* member(const Json& json, const char* name);
// Return the member as an integer or a string; `otherwise`, or an empty string, if it is missing or of another type.
std::int64_t numberIn(const Json& json, const char* name, std::int64_t otherwise);
std::string textIn(const Json& json, const char* name);

}  // namespace relief::app
