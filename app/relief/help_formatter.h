// Layout of --help: summaries in the list of commands; paragraphs and wrapped options on a command's own page.
#pragma once

#include <string>

#include "session.h"

namespace relief::app {

// The option text of mandatory arguments. CLI11's own marker is not used, because it would report a missing argument
// before a misspelt option.
inline constexpr const char* kNeeded = "needed";

// Applies this layout to the program's pages and to those of commands added later.
void setHelpFormatter(CLI::App& program);

// Breaks the text at spaces into lines of at most `columns` characters.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace relief::app
