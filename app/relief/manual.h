// Manual pages and bash completion, made by the build from the parsers themselves: they cannot fall behind the program.
#pragma once

#include <string>

#include "session.h"

namespace relief::app {

// The hidden option --manual FOLDER: writes the pages FOLDER/man1/relief.1 and relief-COMMAND.1 and the completion
// FOLDER/completions/relief, and ends the program. Where FOLDER/reliefscope.help holds what reliefscope --help prints,
// the same of that program. After all commands are added.
void addManual(CLI::App& program);

// One page, in roff.
std::string manPage(const CLI::App& program, const CLI::App& parser);
// Of a program that is known by its help text: "NAME: summary", "Usage:", options indented by two, "Title:" paragraphs.
std::string manPage(const std::string& help);

// The functions of bash that complete the program's command lines.
std::string bashCompletion(const CLI::App& program);
std::string bashCompletion(const std::string& help);

}  // namespace relief::app
