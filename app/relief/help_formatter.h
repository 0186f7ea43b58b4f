// How --help looks: summaries in the list of commands, paragraphs and wrapped options in a command's own page.
#pragma once

#include <string>

#include "session.h"

namespace relief::app {

// The option text of arguments that cannot be left out: CLI11's own mark would complain about them before it looks for
// misspelt options.
inline constexpr const char* kNeeded = "needed";

class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_subcommand(const CLI::App* parser) const override;
    std::string make_description(const CLI::App* parser) const override;
    std::string make_help(const CLI::App* parser, std::string name, CLI::AppFormatMode mode) const override;
    std::string make_option_usage(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
};

// Broken into lines of at most `columns` characters where there is a space.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace relief::app
