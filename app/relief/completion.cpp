#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "filtering/filters/filter_choice.h"
#include "manual.h"
#include "map_engine.h"
#include "relief/maps/pyramid_files.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"
#include "relief/tracers/map_choice.h"
#include "rendering/frame.h"
#include "scenario/row_methods.h"

namespace relief::app {

namespace {

using Words = std::vector<std::string>;

template <class List>
Words nameWords(const List& list) {
    Words names;
    for (const auto& entry : list) names.emplace_back(entry.name);
    return names;
}

// Returns "layers=", "steps=", ...: the options of all methods, as --set takes them.
template <class List>
Words optionWords(const List& list) {
    std::set<std::string> names;
    for (const auto& entry : list)
        for (const OptionDescription& option : entry.options) names.insert(option.name + "=");
    return {names.begin(), names.end()};
}

std::string joined(const Words& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
    return out;
}

// Returns the literal alternatives of a value's type: all of "repeat|clamp|border", "auto" and "full" of
// "auto|full|LO,HI".
Words choicesIn(const std::string& type) {
    Words words;
    if (type.find('|') == std::string::npos || type.starts_with("FILE")) return words;
    std::istringstream parts(type);
    for (std::string word; std::getline(parts, word, '|');) {
        if (std::all_of(word.begin(), word.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; }))
            words.push_back(word);
    }
    return words;
}

Words both(Words some, const Words& others) {
    some.insert(some.end(), others.begin(), others.end());
    return some;
}

// Returns the possible values of the option, or of the command's first argument if `option` is empty. Empty if it is a
// file or its values are not known.
Words valuesOf(const std::string& command, const std::string& option, const std::string& type) {
    const Words tracers = nameWords(tracerList());
    const Words filters = nameWords(filterList());
    const Words reliefs = nameWords(reliefRecipes());
    const Words rows = nameWords(rowMethodList());
    const Words maps = both(both(mapKinds(), pyramidMapKinds()), engineOnlyKinds());
    const std::map<std::string, Words> known{{"--tracer", tracers},
                                             {"--tracers", tracers},
                                             {"--filter", filters},
                                             {"--filters", filters},
                                             {"--relief", reliefs},
                                             {"--layer", layerNames()},
                                             {"--layers", layerNames()},
                                             {"--convention", nameWords(namedConventions())},
                                             {"--mapping", rows},
                                             {"--mappings", rows},
                                             {"--variants", rows},
                                             {"--set", optionWords(tracerList())},
                                             {"--filter-set", optionWords(filterList())},
                                             {"make", reliefs},
                                             {"map", maps},
                                             {"export", {"shader"}},
                                             {"bench", {"tracers", "rows", "filters"}},
                                             {"list", both(both(tracers, filters), both(reliefs, maps))}};
    const auto found = known.find(option.empty() ? command : option);
    return found != known.end() ? found->second : choicesIn(type);
}

// What the completion of a command needs: its options, its first argument, and the values of options.
struct Completion {
    std::string name;
    Words options;
    Words first;
    std::map<std::string, Words> values;
    Words plain;  // options with a value that is neither a file nor one of a known set
};

void addOption(Completion& completion, const Words& names, const std::string& type) {
    for (const std::string& name : names) {
        completion.options.push_back(name);
        const Words values = valuesOf(completion.name, name, type);
        if (!values.empty()) {
            completion.values[name] = values;
        } else if (!type.empty() && type.find("FILE") == std::string::npos &&
                   type.find("FOLDER") == std::string::npos) {
            completion.plain.push_back(name);
        }
    }
}

Completion completionOf(const CLI::App& parser) {
    Completion completion{parser.get_name(), {}, {}, {}, {}};
    for (const CLI::Option* option : parser.get_options()) {
        if (option->get_group().empty() || option->get_positional()) continue;
        Words names;
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        addOption(completion, names, option->get_type_name());
    }
    completion.first = valuesOf(parser.get_name(), "", "");
    return completion;
}

// Returns the branch of bash's `case` for one command.
std::string cases(const Completion& completion, const std::string& indent) {
    std::string out = indent + "options='" + joined(completion.options) + "'\n";
    if (!completion.first.empty()) out += indent + "first='" + joined(completion.first) + "'\n";
    out += indent + "case $before in\n";
    std::map<std::string, std::string> byValues;
    for (const auto& [name, values] : completion.values) {
        std::string& names = byValues[joined(values)];
        names += (names.empty() ? "" : " | ") + name;
    }
    for (const auto& [values, names] : byValues) out += indent + "    " + names + ") values='" + values + "' ;;\n";
    if (!completion.plain.empty()) {
        std::string names;
        for (const std::string& name : completion.plain) names += (names.empty() ? "" : " | ") + name;
        out += indent + "    " + names + ") return ;;\n";
    }
    return out + indent + "esac\n";
}

std::string functionOf(const std::string& name, const std::string& body) {
    return "# Completion for " + name + " in bash, made by the build from the program's own options.\n_" + name +
           R"(() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= place=0 at
    local options= first= values= head=
    # bash breaks --option=value at the sign.
    if [ "$word" = = ]; then
        word=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    COMPREPLY=()
)" + body +
           R"(    case $word in
        -*) COMPREPLY=($(compgen -W "$options" -- "$word")); return ;;
    esac
    if [ -z "$values" ] && [ "$place" = 1 ] && [ "${before#-}" = "$before" ]; then values=$first; fi
    if [ -n "$values" ]; then
        # Lists: the part behind the last comma.
        case $word in *,*) head=${word%,*}, ;; esac
        COMPREPLY=($(compgen -P "$head" -W "$values" -- "${word##*,}"))
        case ${COMPREPLY[0]} in *=) compopt -o nospace 2>/dev/null ;; esac
        return
    fi
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
}
complete -F _)" +
           name + " " + name + "\n";
}

// Returns the views that the help lists after "VIEW:", up to the next option: "result (PNG alone), profile, ...".
Words viewsIn(const std::string& help) {
    const std::string sign = " VIEW: ";
    const std::size_t at = help.find(sign);
    if (at == std::string::npos) return {};
    std::istringstream words(help.substr(at + sign.size()));
    Words views;
    bool remark = false;
    for (std::string word; words >> word && !word.starts_with("-");) {
        remark = remark || word.starts_with("(");
        const bool ends = word.ends_with(',');
        if (ends) word.pop_back();
        if (!remark) views.push_back(word);
        if (word.ends_with(')')) remark = false;
    }
    return views;
}

}  // namespace

std::string bashCompletion(const CLI::App& program) {
    std::string body = R"(    for ((at = 1; at < COMP_CWORD; ++at)); do
        case ${COMP_WORDS[at]} in
            --language) if [ -z "$command" ]; then ((++at)); fi ;;
            -*) ;;
            *) if [ -z "$command" ]; then command=${COMP_WORDS[at]} place=$((COMP_CWORD - at)); fi ;;
        esac
    done
    case $command in
)";
    const auto shown = program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
    Words commands;
    for (const CLI::App* command : shown) commands.push_back(command->get_name());
    for (const CLI::App* command : shown) {
        Completion completion = completionOf(*command);
        if (completion.name == "help") completion.first = commands;
        body += "        " + completion.name + ")\n" + cases(completion, "            ") + "            ;;\n";
    }
    Completion whole = completionOf(program);
    body += "        *)\n" + cases(whole, "            ") + "            values=${values:-" + joined(commands) +
            "}\n            ;;\n    esac\n";
    return functionOf(program.get_name(), body);
}

std::string bashCompletion(const std::string& help) {
    Completion completion{help.substr(0, help.find(':')), {}, {}, {}, {}};
    const std::map<std::string, Words> byType{{"VIEW", viewsIn(help)}, {"KIND", mapKinds()}};
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  -")) continue;
        // "  --size WxH      size of ...", "  --export VIEW -o FILE one figure ...", "  --version, --help"
        std::istringstream words(line);
        std::string word;
        while (words >> word && word.starts_with("-")) {
            if (word.ends_with(',')) word.pop_back();
            std::string type;
            const bool takes = words >> type && !type.starts_with("-") &&
                               std::any_of(type.begin(), type.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
            const auto known = byType.find(type);
            if (known != byType.end()) {
                completion.options.push_back(word);
                completion.values[word] = known->second;
            } else {
                addOption(completion, {word}, takes || choicesIn(type).size() > 1 ? type : "");
            }
            if (!takes) break;
        }
    }
    return functionOf(completion.name, cases(completion, "    "));
}

}  // namespace relief::app
