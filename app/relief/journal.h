// Rows of a sweep as they come, in FILE.part beside the output; kept if the run does not come to its end.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "errors.h"

namespace relief::app {

class Journal {
  public:
    Journal(const std::string& output, const std::string& header)
        : path_(output + ".part"), file_(path_, std::ios::binary) {
        write(header);
    }
    // Throws WorkError.
    void write(const std::string& text) {
        file_ << text << std::flush;
        if (!file_) throw WorkError(path_, Message(MessageId::FileUnwritable, {{"why", std::strerror(errno)}}));
    }
    void remove() {
        file_.close();
        std::remove(path_.c_str());
    }

  private:
    std::string path_;
    std::ofstream file_;
};

}  // namespace relief::app
