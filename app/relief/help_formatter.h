// How --help looks: summaries in the list of commands, paragraphs and wrapped options in a command's own page.
#pragma once

#include <string>

#include "session.h"

namespace relief::app {

class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_subcommand(const CLI::App* parser) const override;
    std::string make_description(const CLI::App* parser) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
};

// Broken into lines of at most `columns` characters where there is a space.
std::string wrapped(const std::string& text, std::size_t columns);

}  // namespace relief::app
