#include "command_test.h"

#include <fcntl.h>
#include <locale.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <sstream>
#include <thread>

#include "program_server.h"

namespace relief::test {

namespace {

bool localeThere(const std::string& name) {
    const locale_t locale = newlocale(LC_ALL_MASK, name.c_str(), nullptr);
    if (locale == nullptr) return false;
    freelocale(locale);
    return true;
}

std::string readFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool servable([[maybe_unused]] const RunSetup& setup) {
#ifdef RELIEF_ALWAYS_STARTED
    return false;
#else
    return setup.launcher.empty() && setup.program.empty() && setup.addressSpace < 0 &&
           setup.interruptAfterMilliseconds == 0;
#endif
}

// Runs in the child, between fork and exec.
[[noreturn]] void execute(const std::vector<std::string>& arguments, const RunSetup& setup, const std::string& locale,
                          int input, const std::string& out, const std::string& err) {
    dup2(input, STDIN_FILENO);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (setup.addressSpace >= 0) {
        const rlimit limit{static_cast<rlim_t>(setup.addressSpace), static_cast<rlim_t>(setup.addressSpace)};
        setrlimit(RLIMIT_AS, &limit);
    }
    if (setup.largestFile >= 0) {
        const rlimit limit{static_cast<rlim_t>(setup.largestFile), static_cast<rlim_t>(setup.largestFile)};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    setenv("LC_ALL", locale.c_str(), 1);
    for (const auto& [name, value] : setup.variables) setenv(name.c_str(), value.c_str(), 1);
    signal(SIGINT, SIG_DFL);
    std::vector<char*> pointers;
    std::string program = setup.program.empty() ? RELIEF_PROGRAM : setup.program;
    for (const std::string& word : setup.launcher) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(program.data());
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    execvp(pointers.front(), pointers.data());
    _exit(127);
}

}  // namespace

std::vector<Place> everyPlace() {
    return {{"plain", "C", "plain"}, {"ukrainian", "uk_UA.UTF-8", "тека з пробілами"}};
}

std::vector<Place> places() {
    std::vector<Place> all = everyPlace();
    if (std::getenv("RELIEF_LONG") == nullptr) all.erase(all.begin());
    return all;
}

void PrintTo(const Place& place, std::ostream* out) {
    *out << place.locale << " in \"" << place.folder << '"';
}

std::string placeName(const testing::TestParamInfo<Place>& info) {
    return info.param.name;
}

void CommandTest::SetUp() {
    locale_ = GetParam().locale;
    if (!localeThere(locale_)) setenv("LOCPATH", RELIEF_TEST_LOCALES, 1);
    if (!localeThere(locale_)) {
        std::cout << "the locale " << locale_ << " is not installed: run under C.UTF-8\n";
        locale_ = "C.UTF-8";
    }
    std::string pattern = (std::filesystem::temp_directory_path() / "relief-cmd-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = std::filesystem::path(pattern) / GetParam().folder;
    std::filesystem::create_directory(folder_);
}

void CommandTest::TearDown() {
    if (!folder_.empty()) std::filesystem::remove_all(folder_.parent_path());
}

Result CommandTest::run(const std::vector<std::string>& arguments, const RunSetup& setup) const {
    const std::string out = (folder_.parent_path() / "stdout").string();
    const std::string err = (folder_.parent_path() / "stderr").string();
    const std::string in = (folder_.parent_path() / "stdin").string();
    std::ofstream(in, std::ios::binary) << setup.input;
    const auto seen = [&](int status) {
        Result result;
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        if (setup.output.empty()) result.out = readFile(out);
        result.err = readFile(err);
        return result;
    };
    const std::string& output = setup.output.empty() ? out : setup.output;
    if (servable(setup)) {
        ProgramRun served{arguments, {{"LC_ALL", locale_}}, in, output, err, setup.largestFile};
        served.variables.insert(served.variables.end(), setup.variables.begin(), setup.variables.end());
        const int status = runByServer(served);
        if (status != -1) return seen(status);
        ADD_FAILURE() << "the program server has ended";
        return {};
    }
    int pipeEnds[2] = {-1, -1};
    if (setup.interruptAfterMilliseconds > 0 && pipe(pipeEnds) != 0) return {};
    const int input = setup.interruptAfterMilliseconds > 0 ? pipeEnds[0] : open(in.c_str(), O_RDONLY | O_CLOEXEC);
    const pid_t child = fork();
    if (child == 0) {
        execute(arguments, setup, locale_, input, output, err);
    }
    close(input);
    if (setup.interruptAfterMilliseconds > 0) {
        const auto last =
            std::chrono::steady_clock::now() + std::chrono::milliseconds(setup.interruptAfterMilliseconds);
        while (std::chrono::steady_clock::now() < last && !(setup.interruptWhen && setup.interruptWhen())) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        kill(child, SIGINT);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (pipeEnds[1] >= 0) close(pipeEnds[1]);
    return seen(status);
}

std::string CommandTest::runFine(const std::vector<std::string>& arguments, const RunSetup& setup) const {
    const Result result = run(arguments, setup);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
}

RunSetup interruptedWhen(std::function<bool()> condition) {
    RunSetup setup;
    setup.interruptAfterMilliseconds = 60'000;
    setup.interruptWhen = std::move(condition);
    return setup;
}

void CommandTest::expectKept(const Result& stopped, const std::string& partFile, int parts) {
    EXPECT_EQ(stopped.status, 130);
    EXPECT_EQ(stopped.err.find("relief: " + partFile + ": stopped: "), 0U) << stopped.err;
    EXPECT_NE(
        stopped.err.find(" of " + std::to_string(parts) +
                         " parts are done and kept in this file; run the same command with --resume to continue\n"),
        std::string::npos)
        << stopped.err;
}

void CommandTest::expectRefusal(const std::vector<std::string>& arguments, int status,
                                const std::vector<std::string>& parts, const RunSetup& setup) const {
    const Result result = run(arguments, setup);
    std::string command;
    for (const std::string& argument : arguments) command += " " + argument;
    SCOPED_TRACE("relief" + command + "\n" + result.err);
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
    EXPECT_EQ(result.err.substr(0, 8), "relief: ");
    for (const std::string& part : parts) EXPECT_NE(result.err.find(part), std::string::npos) << "lacks " << part;
}

std::string CommandTest::write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return path(name);
}

std::string CommandTest::read(const std::string& name) const {
    return readFile(folder_ / name);
}

std::vector<std::string> CommandTest::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string CommandTest::makeRelief(const std::string& recipe, const std::string& name,
                                    const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"make", recipe, "-o", path(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runFine(arguments);
    return path(name);
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
}

std::string withoutDate(const std::string& bytes) {
    static const std::regex date("[0-9]{4}:[0-9]{2}:[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2}");
    return std::regex_replace(bytes, date, "");
}

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> all;
    std::size_t at = 0;
    while (true) {
        const std::size_t comma = line.find(',', at);
        all.push_back(line.substr(at, comma == std::string::npos ? comma : comma - at));
        if (comma == std::string::npos) return all;
        at = comma + 1;
    }
}

}  // namespace relief::test
