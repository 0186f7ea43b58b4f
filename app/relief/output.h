// Where results go: standard output or a file that appears only when it is complete. Every failed write is an error:
// a full disk or a closed pipe must not look like success.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "relief/files.h"

namespace relief::app {

// Thrown where the reader of standard output, or of a pipe, has gone away: the program ends as SIGPIPE ends others,
// without a word.
struct OutputClosed {};

// Text written piece by piece. path "-": standard output; devices and pipes are written directly; anything else beside
// and renamed by commit().
class TextOutput {
  public:
    TextOutput(std::string path, std::stop_token stop);
    ~TextOutput();
    TextOutput(const TextOutput&) = delete;
    TextOutput& operator=(const TextOutput&) = delete;

    void write(std::string_view text);
    // Without it, a file is left as it was. Throws WorkError.
    void commit();
    // The temporary file goes, for a process that ends at once; while another thread may be writing to it.
    void discard() const;

  private:
    void close();

    std::string name_;  // for messages
    std::unique_ptr<AtomicFile> file_;
    int descriptor_ = -1;
    bool owned_ = false;
    bool inPieces_ = false;  // a reader may stall: look at the stop token between pieces
    std::stop_token stop_;
};

// One text to standard output.
void writeStandardOutput(std::string_view text, std::stop_token stop = {});

// All of standard input; ends with Cancelled when the stop token is triggered.
std::string readStandardInput(const std::stop_token& stop);

// To be called before long work: the ending must be one of `endings` (without dot; InputError otherwise), and the
// folder must be there.
void checkOutput(const std::string& path, const std::vector<std::string>& endings);
// The folder must be there, and the name not be a folder's; throws WorkError.
void checkOutputFolder(const std::string& path);

// The ending of the file's name, lower case, without dot.
std::string fileEnding(const std::string& path);

}  // namespace relief::app
