// What the operating system says about a file, as one of our sentences (its own text would follow the locale).
#pragma once

#include <string>

#include "relief/errors.h"

namespace relief {

enum class FileAccess : std::uint8_t { Read, Write };

// error: an errno. folder: named when the folder of an output is not there.
Message systemMessage(int error, FileAccess access, const std::string& folder = {});

// Text of a library on one line, without control characters or space at the ends.
std::string oneLine(const std::string& text);

}  // namespace relief
