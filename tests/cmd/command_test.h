// Runs the program in a folder of its own and captures its output. Every test uses a folder name with Cyrillic letters
// and spaces and a Ukrainian locale (decimal comma), since whatever fails in a plain setting fails there, too.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace relief::test {

// An earlier output; export rays replaces no other file by a view.
inline constexpr const char* kOld = R"({"format": "reliefscope rays"})";

struct Place {
    std::string name;
    std::string locale;
    std::string folder;
};

struct Result {
    int status = -1;  // exit status; 128 + signal if the program was killed
    std::string out;
    std::string err;
};

// Deviations from a plain run.
struct RunSetup {
    std::vector<std::string> launcher{};    // starts the program: mpirun, with its options
    std::string program{};                  // in place of the program under test
    std::string input{};                    // standard input
    std::string output{};                   // redirects standard output to this file, instead of Result::out
    std::int64_t largestFile = -1;          // limit of a file's size, in bytes
    std::int64_t addressSpace = -1;         // limit of the address space, in bytes
    int interruptAfterMilliseconds = 0;     // sends SIGINT after this time; standard input stays open until the end
    std::function<bool()> interruptWhen{};  // sends SIGINT as soon as this returns true, if that is earlier
    std::vector<std::pair<std::string, std::string>> variables{};  // added to the environment
};

// Sends SIGINT as soon as the condition holds, or after a minute.
RunSetup interruptedWhen(std::function<bool()> condition);

class CommandTest : public testing::TestWithParam<Place> {
  protected:
    void SetUp() override;
    void TearDown() override;

    Result run(const std::vector<std::string>& arguments, const RunSetup& setup = {}) const;
    // Runs the program; expects success and no output on standard error. Returns standard output.
    std::string runFine(const std::vector<std::string>& arguments, const RunSetup& setup = {}) const;
    // Expects this status, no output on standard output, and one line on standard error that starts with "relief: " and
    // contains each of the parts.
    void expectRefusal(const std::vector<std::string>& arguments, int status, const std::vector<std::string>& parts,
                       const RunSetup& setup = {}) const;

    // Expects that the run was interrupted, and that standard error says how many of the parts are kept in the file.
    static void expectKept(const Result& stopped, const std::string& partFile, int parts);

    // Returns a path in the test's folder.
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const;
    std::string read(const std::string& name) const;
    // Returns the file names in the folder, sorted.
    std::vector<std::string> files() const;
    // Writes a procedural relief as a height map. Returns its path.
    std::string makeRelief(const std::string& recipe, const std::string& name,
                           const std::vector<std::string>& more = {}) const;

  private:
    std::filesystem::path folder_;
    std::string locale_;
};

std::vector<std::string> lines(const std::string& text);
std::vector<std::string> fields(const std::string& line);
// Returns the bytes of an OpenEXR or TIFF file without the time of writing.
std::string withoutDate(const std::string& bytes);

// Returns a grey float OpenEXR picture, uncompressed, as bytes.
std::string exrBytes(int width, int height, const std::vector<float>& values);
// Returns signature and header of a grey 8-bit PNG of that size, without data.
std::string pngHeaderBytes(std::uint32_t width, std::uint32_t height);

// A plain place and the Ukrainian one.
std::vector<Place> everyPlace();
// The Ukrainian place; with RELIEF_LONG every place.
std::vector<Place> places();
void PrintTo(const Place& place, std::ostream* out);
std::string placeName(const testing::TestParamInfo<Place>& info);

}  // namespace relief::test
