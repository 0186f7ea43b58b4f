// How --help looks: summaries in the list of commands, paragraphs and wrapped options in a command's own page.
#pragma once

#include <string>

#include "session.h"

namespace relief::app {

// The option text of arguments that cannot be left out: CLI11's own mark would complain about them before it looks for
// misspelt options.
inline constexpr const char* kNeeded = "needed";

// Makes the program's pages, and those of commands added later, look so.
void setHelpFormatter(CLI::App& program);

// Broken into lines of at most `columns` characters where there is a space.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace relief::app
