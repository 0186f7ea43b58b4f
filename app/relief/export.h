// The kinds of `relief export KIND`: files for programs of others. Each kind is a source of its own, export_KIND.cpp,
// and is listed in export.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options_common.h"

namespace relief::app {

// The options that kinds share.
struct ExportOptions {
    OptionText kind, output;
    ScenarioOptions scenario;
    RunOptions run;
};

struct ExportKind {
    std::string name;
    std::string help;      // a paragraph of the command's help
    std::string examples;  // lines that begin with two spaces
    // The options that the kind takes, by their long names, or "FILE"; others are refused, but for --output and those
    // of the group General.
    std::vector<std::string> options;
    std::function<int(const ExportOptions&, Session&)> run;
};

// Each adds the options that only this kind has to the command's parser.
ExportKind addShaderExport(CLI::App& parser);
ExportKind addRaysExport(CLI::App& parser);

}  // namespace relief::app
