#include "installed.h"

#include <filesystem>

namespace relief::app {

namespace fs = std::filesystem;

namespace {

// Returns the folder above the program's: the root of the installed tree or of the build.
fs::path treeFolder() {
    std::error_code none;
    return fs::read_symlink("/proc/self/exe", none).parent_path().parent_path();
}

}  // namespace

std::string pluginPath(const std::string& name) {
    return (treeFolder() / RELIEF_PLUGIN_FOLDER / name).string();
}

std::string shippedFile(const std::string& path) {
    std::error_code none;
    const bool dataset = path.starts_with("datasets/");
    if ((!dataset && !path.starts_with("lessons/")) || fs::exists(path, none)) return path;
    const fs::path source(RELIEF_SOURCE);
    for (const fs::path& folder : {treeFolder() / "share" / "reliefscope", dataset ? source : source / "ui"}) {
        if (fs::path file = folder / path; fs::exists(file, none)) return file.string();
    }
    return path;
}

}  // namespace relief::app
