// Operating system errors on files as the program's own messages (the system's text would follow the locale).
#pragma once

#include <string>

#include "relief/errors.h"

namespace relief {

enum class FileAccess : std::uint8_t { Read, Write };

// The message for an errno. folder: named in the message if the folder of an output does not exist.
Message systemMessage(int error, FileAccess access, const std::string& folder = {});

// A library's message on one line, without control characters and without blanks at the ends.
std::string oneLine(const std::string& text);

}  // namespace relief
