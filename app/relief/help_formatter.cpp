#include "help_formatter.h"

#include <algorithm>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace relief::app {

namespace {

constexpr std::size_t kPageColumns = 80;
constexpr std::size_t kNameColumns = 28;

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

HelpFormatter::HelpFormatter() {
    column_width(kNameColumns);
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
}

// A command's description consists of its summary, a line break, and its paragraph.
std::string HelpFormatter::make_subcommand(const CLI::App* parser) const {
    const std::string description = parser->get_description();
    std::string line = "  " + parser->get_name();
    line.resize(std::max(line.size() + 1, std::size_t{12}), ' ');
    return line + description.substr(0, description.find('\n')) + "\n";
}

std::string HelpFormatter::make_description(const CLI::App* parser) const {
    const std::string description = parser->get_description();
    const std::size_t end = description.find('\n');
    std::string out = description.substr(0, end) + "\n";
    if (end != std::string::npos) out += "\n" + wrapped(description.substr(end + 1), kPageColumns) + "\n";
    return out + "\n";
}

// CLI11 separates groups by two empty lines; one is removed.
std::string HelpFormatter::make_help(const CLI::App* parser, std::string name, CLI::AppFormatMode mode) const {
    return CLI::detail::find_and_replace(CLI::Formatter::make_help(parser, std::move(name), mode), "\n\n\n", "\n\n");
}

std::string HelpFormatter::make_option_usage(const CLI::Option* option) const {
    const std::string name = make_option_name(option, true);
    return option->get_option_text() == kNeeded ? name : "[" + name + "]";
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    return wrapped(option->get_description(), kPageColumns - kNameColumns);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
}

}  // namespace

void setHelpFormatter(CLI::App& program) {
    program.formatter(std::make_shared<HelpFormatter>());
}

std::string wrapped(const std::string& text, std::size_t columns) {
    std::string out;
    std::string line;
    std::string word;
    const auto flush = [&] {
        if (!line.empty() && line.size() + 1 + word.size() > columns) {
            out += line + "\n";
            line.clear();
        }
        if (!line.empty() && !word.empty()) line += ' ';
        line += word;
        word.clear();
    };
    for (const char c : text) {
        if (c != ' ' && c != '\n') {
            word += c;
            continue;
        }
        flush();
        if (c == '\n') {
            out += line + "\n";
            line.clear();
        }
    }
    flush();
    return out + line;
}

}  // namespace relief::app
