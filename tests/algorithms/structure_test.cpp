// Laws of the sources themselves.
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "images/files.h"

namespace relief::test {
namespace {

// A type that two sources define under one name is one type to the linker, which keeps the functions of either: what
// then runs depends on what the compiler has inlined.
TEST(Structure, NoTypeIsDefinedTwice) {
    const std::regex opens("namespace ([A-Za-z_:]*) ?\\{"),
        defines("(?:class|struct) (\\w+)(?: final)?(?: : .*)? \\{.*");
    std::map<std::string, std::set<std::string>> places;
    for (const char* top : {"algorithms", "app", "ui"}) {
        const auto folder = std::filesystem::path(RELIEF_SOURCE) / top;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            const std::string file = entry.path().string();
            if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
            std::vector<std::string> namespaces;
            std::istringstream text(readTextFile(file));
            for (std::string line; std::getline(text, line);) {
                std::smatch match;
                if (std::regex_match(line, match, opens)) namespaces.push_back(match[1]);
                if (line.starts_with("}  // namespace") && !namespaces.empty()) namespaces.pop_back();
                if (!std::regex_match(line, match, defines)) continue;
                std::string name;
                for (const std::string& outer : namespaces) name += (outer.empty() ? file : outer) + "::";
                places[name + match[1].str()].insert(file);
            }
        }
    }
    EXPECT_GT(places.size(), 500U) << "the sources were not understood";
    for (const auto& [name, files] : places) {
        EXPECT_EQ(files.size(), 1U) << name << " in " << *files.begin() << " and " << *files.rbegin();
    }
}

}  // namespace
}  // namespace relief::test
