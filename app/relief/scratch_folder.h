// A temporary folder for short-lived files: pictures that a rank without an output folder writes before it sends them
// to rank 0.
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
    // Removes the folder with its content.
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    // Returns the path of a file in the folder.
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    // Returns the file's bytes, for a message, and removes the file.
    static Json take(const std::string& path);

  private:
    std::filesystem::path folder_;
};

// Writes the bytes to a temporary file and renames it, as for all output files.
void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace relief::app
