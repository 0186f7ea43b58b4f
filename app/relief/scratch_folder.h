// Files that are needed for a moment: pictures of a rank that has no folder to write into, on their way to rank 0.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "json_line.h"

namespace relief::app {

class ScratchFolder {
  public:
    // Throws WorkError.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    // The file's bytes, for a message; the file goes.
    static Json take(const std::string& path);

  private:
    std::filesystem::path folder_;
};

// To a temporary file that is renamed, as all files are written.
void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace relief::app
