// Runs the program in a folder of its own and keeps what it wrote. Every test runs in a folder with Cyrillic letters
// and spaces under a Ukrainian locale (comma as decimal point): whatever goes wrong plainly goes wrong there, too.
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

struct Place {
    std::string name;
    std::string locale;
    std::string folder;
};

struct Result {
    int status = -1;  // exit status; 128 + signal where it was killed
    std::string out;
    std::string err;
};

// What is not plain about a run.
struct RunSetup {
    std::vector<std::string> launcher;    // starts the program: mpirun, with its options
    std::string program;                  // another than the one that was built
    std::string input;                    // standard input
    std::string output;                   // write standard output into this file instead of Result::out
    std::int64_t largestFile = -1;        // bytes a file may grow to
    std::int64_t addressSpace = -1;       // bytes the program may map
    int interruptAfterMilliseconds = 0;   // SIGINT then; standard input stays open until the end
    std::function<bool()> interruptWhen;  // SIGINT as soon as this holds, if that is earlier
    std::vector<std::pair<std::string, std::string>> variables;  // of the environment
};

class CommandTest : public testing::TestWithParam<Place> {
  protected:
    void SetUp() override;
    void TearDown() override;

    Result run(const std::vector<std::string>& arguments, const RunSetup& setup = {}) const;
    // Runs and expects success without a word on standard error.
    std::string runFine(const std::vector<std::string>& arguments, const RunSetup& setup = {}) const;
    // Expects this status, nothing on standard output, and one line on standard error that starts with "relief: " and
    // holds each of the parts.
    void expectRefusal(const std::vector<std::string>& arguments, int status, const std::vector<std::string>& parts,
                       const RunSetup& setup = {}) const;

    // A path in the test's folder.
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const;
    std::string read(const std::string& name) const;
    // Names in the folder, sorted.
    std::vector<std::string> files() const;
    // A procedural relief as a height map.
    std::string makeRelief(const std::string& recipe, const std::string& name,
                           const std::vector<std::string>& more = {}) const;

  private:
    std::filesystem::path folder_;
    std::string locale_;
};

std::vector<std::string> lines(const std::string& text);
std::vector<std::string> fields(const std::string& line);
// The bytes of an OpenEXR or TIFF file but for the second that it was written in.
std::string withoutDate(const std::string& bytes);

// A grey float OpenEXR picture, uncompressed, as bytes.
std::string exrBytes(int width, int height, const std::vector<float>& values);
// Signature and header of a grey 8-bit PNG of that size, nothing behind it.
std::string pngHeaderBytes(std::uint32_t width, std::uint32_t height);

// A plain one and the Ukrainian one.
std::vector<Place> everyPlace();
// The Ukrainian one; with RELIEF_LONG every place.
std::vector<Place> places();
void PrintTo(const Place& place, std::ostream* out);
std::string placeName(const testing::TestParamInfo<Place>& info);

}  // namespace relief::test
