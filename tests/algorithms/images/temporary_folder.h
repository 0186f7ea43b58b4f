// A new folder for the files of one test, removed afterwards; and a function that catches errors as text.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

#include "relief/errors.h"

namespace relief::testing {

class TemporaryFolder {
  public:
    TemporaryFolder() {
        static std::atomic<int> count{0};
        folder_ = std::filesystem::temp_directory_path() /
                  ("relief_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string operator/(const std::string& name) const { return (folder_ / name).string(); }
    // Returns the number of files including hidden ones, to detect files left behind by failed writes.
    int files() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
        return count;
    }
    std::string with(const std::string& name, const std::string& bytes) const {
        const std::string path = *this / name;
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

  private:
    std::filesystem::path folder_;
};

inline std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Returns the one line of the InputError that `call` throws; "" if it throws none. Checks that the line begins with the
// error's subject.
template <class Call>
std::string faultOf(const Call& call) {
    try {
        call();
    } catch (const InputError& fault) {
        const std::string text = fault.what();
        if (text.find('\n') != std::string::npos) return "MORE THAN ONE LINE: " + text;
        if (text.find('{') != std::string::npos) return "UNFILLED: " + text;
        if (!text.starts_with(fault.subject())) return "WITHOUT ITS SUBJECT: " + text;
        return text;
    }
    return {};
}

}  // namespace relief::testing
