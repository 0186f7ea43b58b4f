// Properties of the sources themselves.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "relief/files.h"

namespace relief::test {
namespace {

// A type defined by two sources under one name is one type for the linker, which keeps the functions of either: which
// of them runs then depends on the compiler's inlining.
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

std::filesystem::path folderOfSources(const std::string& top) {
    return std::filesystem::path(RELIEF_SOURCE) / top;
}

// The folders in the order that README.md in the folder lists.
std::vector<std::string> foldersInOrder(const std::string& top) {
    std::vector<std::string> folders;
    const std::regex row("\\| `([a-z/]+)/` \\|.*");
    std::istringstream text(readTextFile((folderOfSources(top) / "README.md").string()));
    for (std::string line; std::getline(text, line);) {
        if (std::smatch match; std::regex_match(line, match, row)) folders.push_back(match[1]);
    }
    return folders;
}

// For each source, by its path in the folder, the sources that it includes.
std::map<std::string, std::vector<std::string>> includes(const std::string& top) {
    const std::filesystem::path root = folderOfSources(top);
    std::map<std::string, std::vector<std::string>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        const std::string ending = entry.path().extension();
        if (ending != ".h" && ending != ".cpp" && ending != ".inc" && ending != ".def") continue;
        files[entry.path().lexically_relative(root).generic_string()];
    }
    const std::regex names("\\s*#\\s*include [<\"]([^>\"]+)[>\"].*");
    for (auto& [file, included] : files) {
        std::istringstream text(readTextFile((root / file).string()));
        for (std::string line; std::getline(text, line);) {
            std::smatch match;
            if (!std::regex_match(line, match, names)) continue;
            const std::string beside = (std::filesystem::path(file).parent_path() / match[1].str()).generic_string();
            for (const std::string& path : {match[1].str(), "include/" + match[1].str(), beside}) {
                if (files.contains(path)) included.push_back(path);
            }
        }
    }
    return files;
}

void nothingIsIncludedFromFurtherDown(const std::string& top, std::size_t leastIncludes) {
    const std::vector<std::string> order = foldersInOrder(top);
    const auto files = includes(top);
    const auto folderOf = [](const std::string& file) { return std::filesystem::path(file).parent_path().string(); };
    std::set<std::string> folders;
    for (const auto& [file, included] : files) folders.insert(folderOf(file));
    for (const std::string& folder : order) {
        EXPECT_TRUE(folders.contains(folder)) << top << "/README.md names " << folder << "/, which has no sources";
    }
    for (const std::string& folder : folders) {
        ASSERT_TRUE(std::find(order.begin(), order.end(), folder) != order.end())
            << "the table of folders in " << top << "/README.md has no line for " << folder
            << "/; its place is below the folders that it includes";
    }
    // A public header belongs to the folder that implements it.
    std::map<std::string, std::string> implementedIn;
    for (const auto& [file, included] : files) {
        if (file.ends_with(".cpp")) implementedIn[std::filesystem::path(file).stem()] = folderOf(file);
    }
    const auto isOpen = [&](const std::string& file) { return folderOf(file).starts_with("include"); };
    const auto placeOf = [&](const std::string& file) {
        std::string folder = folderOf(file);
        const auto implemented = implementedIn.find(std::filesystem::path(file).stem());
        if (isOpen(file) && implemented != implementedIn.end()) folder = implemented->second;
        return std::find(order.begin(), order.end(), folder) - order.begin();
    };
    std::size_t count = 0;
    for (const auto& [file, included] : files) {
        for (const std::string& other : included) {
            ++count;
            if (isOpen(file)) {
                EXPECT_TRUE(isOpen(other)) << file << " is public, " << other << " is not";
            } else {
                EXPECT_LE(placeOf(other), placeOf(file))
                    << file << " includes " << other << ", whose folder is further down in " << top << "/README.md";
            }
        }
    }
    EXPECT_GT(count, leastIncludes) << "the sources were not understood";
}

TEST(Structure, NothingIsIncludedFromAFolderFurtherDown) {
    nothingIsIncludedFromFurtherDown("algorithms", 800);
    nothingIsIncludedFromFurtherDown("ui", 500);
}

// Both would be included as `relief/NAME.h`.
TEST(Structure, NoPrivateHeaderHasTheNameOfAPublicOne) {
    for (const auto& [file, included] : includes("algorithms")) {
        if (!file.starts_with("include/")) continue;
        EXPECT_FALSE(exists(folderOfSources("algorithms") / file.substr(8))) << file;
    }
}

}  // namespace
}  // namespace relief::test
