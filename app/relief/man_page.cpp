#include <sstream>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "manual.h"

namespace relief::app {

namespace {

// Escapes text for roff: hyphens that can be pasted into a shell, and no line that could be taken for a request.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((out.empty() || out.back() == '\n') && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else {
            out += c;
        }
    }
    return out;
}

std::string heading(const std::string& name, const std::string& summary) {
    std::string title = name;
    for (char& c : title)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return ".TH \"" + title + "\" 1 \"\" \"Reliefscope " RELIEF_VERSION "\" \"User Commands\"\n.SH NAME\n" +
           roff(name) + " \\- " + roff(summary) + "\n";
}

std::string section(const std::string& title, const std::string& body) {
    return body.empty() ? "" : ".SH " + title + "\n" + body + (body.ends_with('\n') ? "" : "\n");
}

// Returns the lines unformatted.
std::string verbatim(const std::string& text) {
    return text.empty() ? "" : ".nf\n" + roff(text) + (text.ends_with('\n') ? "" : "\n") + ".fi\n";
}

std::string tagged(const std::string& tag, const std::string& text) {
    return ".TP\n" + tag + "\n" + roff(text) + "\n";
}

std::string bold(const std::string& text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
    return "\\fI" + roff(text) + "\\fR";
}

std::string lineFrom(const std::string& text, std::size_t at) {
    return text.substr(at, text.find('\n', at) - at);
}

// Returns the lines of a help text under "Exit status:", from the title's own line up to an empty line or the next
// title.
std::string exitStatusLines(const std::string& help) {
    constexpr std::string_view kTitle = "Exit status:";
    const std::size_t at = help.find(kTitle);
    if (at == std::string::npos) return {};
    std::istringstream lines(help.substr(at + kTitle.size()));
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        const bool first = out.empty();
        if (line.empty() && !first) break;
        if (!first && line.front() != ' ' && line.find(": ") != std::string::npos) break;
        if (!line.empty()) out += line + "\n";
    }
    return out;
}

// Formats the exit statuses: an indented number, or several, followed by two or more spaces and the meaning becomes a
// tagged paragraph; other lines become text.
std::string exitStatus(const std::string& help) {
    std::istringstream lines(exitStatusLines(help));
    std::string out;
    bool inList = false;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t text = line.find_first_not_of(' ');
        const std::size_t end = line.find("  ", text);
        const bool number = text > 1 && line[text] >= '0' && line[text] <= '9' && end != std::string::npos;
        if (number) {
            out += tagged(bold(line.substr(text, end - text)), line.substr(line.find_first_not_of(' ', end)));
        } else {
            if (inList && text == 0) out += ".PP\n";
            out += roff(line.substr(text)) + "\n";
        }
        inList = number || (inList && text > 0);
    }
    return out;
}

std::string optionTag(const CLI::Option& option) {
    std::string tag;
    if (option.get_positional()) {
        tag = italic(option.get_name(true));
    } else {
        for (const std::string& name : option.get_snames()) tag += (tag.empty() ? "" : ", ") + bold("-" + name);
        for (const std::string& name : option.get_lnames()) tag += (tag.empty() ? "" : ", ") + bold("--" + name);
    }
    if (!option.get_type_name().empty()) tag += " " + italic(option.get_type_name());
    return tag;
}

std::string options(const CLI::App& parser) {
    std::string out;
    for (const std::string& group : parser.get_groups()) {
        if (group.empty()) continue;
        std::string entries;
        for (const CLI::Option* option :
             parser.get_options([&](const CLI::Option* o) { return o->get_group() == group; }))
            entries += tagged(optionTag(*option), option->get_description());
        if (!entries.empty()) out += ".SS " + group + "\n" + entries;
    }
    return out;
}

std::string pageName(const CLI::App& program, const CLI::App& parser) {
    return &program == &parser ? program.get_name() : program.get_name() + "-" + parser.get_name();
}

// Returns the commands of the program; those without a group are hidden.
std::vector<const CLI::App*> shownCommands(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string seeAlso(const CLI::App& program, const CLI::App& parser) {
    std::string out;
    const auto name = [&](const std::string& page) { out += (out.empty() ? "" : ",\n") + bold(page) + "(1)"; };
    if (&program != &parser) name(program.get_name());
    for (const CLI::App* command : shownCommands(program)) {
        if (command != &parser) name(pageName(program, *command));
    }
    name("reliefscope");
    return out;
}

}  // namespace

std::string manPage(const CLI::App& program, const CLI::App& parser) {
    const bool whole = &program == &parser;
    const std::string description = parser.get_description();
    const std::size_t end = description.find('\n');
    std::string summary = description.substr(0, end);
    if (summary.ends_with('.')) summary.pop_back();
    std::string out = heading(pageName(program, parser), summary);
    const auto formatter = std::dynamic_pointer_cast<CLI::Formatter>(parser.get_formatter());
    std::string usage = formatter->make_usage(&parser, whole ? "relief" : "relief " + parser.get_name());
    usage.erase(0, usage.find_first_not_of(" \n"));
    if (usage.starts_with("Usage: ")) usage.erase(0, usage.find(' ') + 1);
    out += section("SYNOPSIS", roff(usage.substr(0, usage.find('\n'))));
    if (end != std::string::npos) out += section("DESCRIPTION", roff(description.substr(end + 1)));
    if (whole) {
        std::string commands;
        for (const CLI::App* command : shownCommands(program)) {
            const std::string about = command->get_description();
            commands += tagged(bold(command->get_name()), about.substr(0, about.find('\n')));
        }
        out += section("COMMANDS", commands);
    }
    out += section("OPTIONS", options(parser));
    const std::string footer = parser.get_footer();
    const std::string own = exitStatus(footer);
    out += section("EXIT STATUS", own.empty() ? exitStatus(program.get_footer()) : own);
    if (const std::size_t at = footer.find("Example"); at != std::string::npos) {
        const std::size_t first = footer.find('\n', at) + 1;
        const std::string examples = footer.substr(first, footer.find("\n\n", first) - first);
        out += section("EXAMPLES", verbatim(examples.substr(0, examples.find("\nExit status"))));
    }
    return out + section("SEE ALSO", seeAlso(program, parser));
}

std::string manPage(const std::string& help) {
    const std::size_t colon = help.find(": ");
    std::string summary = lineFrom(help, colon + 2);
    if (summary.ends_with('.')) summary.pop_back();
    std::string out = heading(help.substr(0, colon), summary);
    std::istringstream lines(help.substr(help.find('\n') + 1));
    std::string entries;
    std::string examples;
    bool inExamples = false;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t text = line.find_first_not_of(' ');
        if (line.starts_with("Usage: ")) {
            out += section("SYNOPSIS", roff(line.substr(line.find(' ') + 1)));
        } else if (text == std::string::npos) {
            continue;
        } else if (text == 0) {
            // Of the paragraphs with a title only the examples are kept; the exit status is formatted below.
            inExamples = line.starts_with("Example");
            if (inExamples) examples = line.substr(line.find(':') + 2) + "\n";
        } else if (inExamples) {
            examples += line.substr(text) + "\n";
        } else if (text == 2) {
            // The name is followed by two spaces and the text; after a long name the text may begin after one space, at
            // its column.
            constexpr std::size_t kTextColumn = 24;
            std::size_t end = line.find("  ", text);
            if (end == std::string::npos && line.size() > kTextColumn) end = kTextColumn - 1;
            entries += tagged(bold(line.substr(text, end - text)),
                              end == std::string::npos ? "" : line.substr(line.find_first_not_of(' ', end)));
        } else {
            entries += roff(line.substr(text)) + "\n";
        }
    }
    out += section("OPTIONS", entries);
    out += section("EXIT STATUS", exitStatus(help));
    return out + section("EXAMPLES", verbatim(examples)) + section("SEE ALSO", bold("relief") + "(1)");
}

}  // namespace relief::app
