#include "installed.h"

#include <filesystem>

namespace relief::app {

namespace {

// Above the program's: of the installed tree, or of the build.
std::filesystem::path treeFolder() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none).parent_path().parent_path();
}

}  // namespace

std::string pluginPath(const std::string& name) {
    return (treeFolder() / RELIEF_PLUGIN_FOLDER / name).string();
}

}  // namespace relief::app
