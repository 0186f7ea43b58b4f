// The progress of long work: a bar on a terminal, erased when the work is done.
#include "progress_bar.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"

namespace relief::test {
namespace {

using app::durationText;
using app::progressLine;

TEST(ProgressBar, timesAreRoundedUp) {
    EXPECT_EQ(durationText(0), "1 s");
    EXPECT_EQ(durationText(2.1), "3 s");
    EXPECT_EQ(durationText(59.5), "1 min 00 s");
    EXPECT_EQ(durationText(125), "2 min 05 s");
}

TEST(ProgressBar, aLineIsNoWiderThanTheTerminal) {
    const std::string line = progressLine("tracing", 0.5, 3, 80, Language::English);
    EXPECT_EQ(line.substr(0, 42), "tracing  [############------------]  50%  ") << line;
    EXPECT_NE(line.find("3 s"), std::string::npos) << line;
    EXPECT_NE(progressLine("tracing", 0.5, 3, 80, Language::Ukrainian), line);
    EXPECT_EQ(progressLine("tracing", 0.5, 3, static_cast<int>(line.size()), Language::English), line);
    EXPECT_EQ(progressLine("tracing", 0.5, 3, static_cast<int>(line.size()) - 1, Language::English), "50%");
}

TEST(ProgressBar, aLogHasLines) {
    EXPECT_EQ(app::progressSentence("tracing", 0.505, 65, Language::English), "tracing: 50%, 1 min 05 s left");
}

// The programs are interrupted as soon as they have printed a line of progress.
TEST(ProgressBar, linesAreWrittenWhereThereIsNoTerminal) {
    struct Running {
        pid_t child;
        int errors;
    };
    const auto start = [](const std::vector<const char*>& more) {
        int ends[2] = {-1, -1};
        EXPECT_EQ(::pipe(ends), 0);
        const pid_t child = fork();
        if (child == 0) {
            dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
            dup2(ends[1], STDERR_FILENO);
            std::vector<const char*> words{"relief"};
            words.insert(words.end(), more.begin(), more.end());
            words.insert(words.end(), {"--verbose", "--threads", "1", nullptr});
            execv(RELIEF_PROGRAM, const_cast<char* const*>(words.data()));
            _exit(127);
        }
        ::close(ends[1]);
        return Running{child, ends[0]};
    };
    // Both run at the same time, since each prints nothing in its first second.
    const std::pair<std::string, Running> all[]{
        {"stress", start({"stress", "--seconds", "60"})},
        {"recommend", start({"recommend", "--relief", "city:512", "--seconds", "60"})}};
    for (const auto& [stage, running] : all) {
        std::string text;
        char bytes[4096];
        for (ssize_t got = 0; (got = ::read(running.errors, bytes, sizeof bytes)) > 0;) {
            text.append(bytes, static_cast<std::size_t>(got));
            if (text.find(" left\n") != std::string::npos) ::kill(running.child, SIGINT);
        }
        ::close(running.errors);
        int status = 0;
        ::waitpid(running.child, &status, 0);
        EXPECT_EQ(WEXITSTATUS(status), 130) << text;
        EXPECT_EQ(text.find("relief: " + stage + ": "), 0U) << text;
        EXPECT_NE(text.find("%, "), std::string::npos) << text;
        EXPECT_EQ(text.find('\r'), std::string::npos) << text;
    }
}

// Returns what the program writes to a terminal until it is interrupted, which is done as soon as it has drawn a bar.
TEST(ProgressBar, isDrawnOnATerminalAndErased) {
    constexpr const char* kErased = "\r\033[K";
    winsize size{};
    size.ws_row = 24;
    size.ws_col = 120;
    int terminal = -1;
    const testing::TemporaryFolder folder;
    const std::string picture = folder / "p.png";
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
        // Would take half a minute.
        execl(RELIEF_PROGRAM, "relief", "render", "--relief", "fractal", "--size", "640x480", "--supersample", "64",
              "--language", "en", "-o", picture.c_str(), nullptr);
        _exit(127);
    }
    std::string text;
    char bytes[4096];
    // The terminal closes with the child, which is reported as an error, not as the end of the file.
    for (ssize_t got = 0; (got = ::read(terminal, bytes, sizeof bytes)) > 0;) {
        text.append(bytes, static_cast<std::size_t>(got));
        if (text.find(" left") != std::string::npos) ::kill(child, SIGINT);
    }
    ::close(terminal);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status)) << text;
    EXPECT_EQ(WEXITSTATUS(status), 130) << text;
    EXPECT_EQ(text.substr(0, 11), "\rsamples  [") << text;
    EXPECT_NE(text.find(kErased, text.rfind(" left")), std::string::npos) << text;
    EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace relief::test
