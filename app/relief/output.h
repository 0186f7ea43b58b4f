// Destinations of results: standard output, or a file that appears only when it is complete. Every failed write is an
// error: a full disk or a closed pipe must not look like success.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "relief/files.h"

namespace relief::app {

// Thrown if the reader of standard output, or of a pipe, has closed it: the program then ends silently, as other
// programs end by SIGPIPE.
struct OutputClosed {};

// Writes text piece by piece. path: "-" for standard output; devices and pipes are written to directly; other files are
// written under a temporary name in the same folder and renamed by commit().
class TextOutput {
  public:
    TextOutput(std::string path, std::stop_token stop);
    ~TextOutput();
    TextOutput(const TextOutput&) = delete;
    TextOutput& operator=(const TextOutput&) = delete;

    // Throws WorkError, OutputClosed, and Cancelled when the stop token is triggered while a reader stalls.
    void write(std::string_view text);
    // Completes the output; without it, an existing file is left unchanged. Throws WorkError.
    void commit();
    // Removes the temporary file, for a process that ends at once; safe while another thread is writing to it.
    void discard() const;

  private:
    void close();

    std::string name_;  // for messages
    std::unique_ptr<AtomicFile> file_;
    int descriptor_ = -1;
    bool owned_ = false;
    bool inPieces_ = false;  // a reader may stall: poll the stop token between pieces
    std::stop_token stop_;
};

// Writes one text to standard output.
void writeStandardOutput(std::string_view text, std::stop_token stop = {});

// Returns all of standard input. Throws Cancelled when the stop token is triggered.
std::string readStandardInput(const std::stop_token& stop);

// Checks the output before long work. Throws InputError if the file name's ending is not one of `endings` (without
// dot), WorkError if the folder does not exist.
void checkOutput(const std::string& path, const std::vector<std::string>& endings);
// Throws WorkError if the folder does not exist, or if `path` is itself a folder.
void checkOutputFolder(const std::string& path);
// Throws InputError if writing `output`, the value of `option`, would replace one of the files that the command reads,
// by whatever name or link. written: the file that is written if it is not `output` itself. Empty names and "-" are no
// files; devices and pipes are not replaced.
void refuseOverwriting(const std::string& option, const std::string& output, const std::vector<std::string>& files,
                       const std::string& written = {});

// Returns the ending of the file's name, in lower case, without the dot.
std::string fileEnding(const std::string& path);

}  // namespace relief::app
