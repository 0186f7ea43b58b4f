// The progress bar of a run of numbered parts, as drawn on a terminal.
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "parts_run.h"

namespace relief::app {
namespace {

// After resuming, the bar refers to the remaining parts, not to all.
TEST(PartsBar, CountsRemainingPartsAfterResuming) {
    constexpr std::size_t kParts = 20, kLeft = 4;
    constexpr std::chrono::milliseconds kPart(400);  // the bar appears after a second, during the third part
    const testing::TemporaryFolder folder;
    int terminal = -1;
    // All in the child: threads of an earlier run would not exist after the fork.
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
        PartsRun run;
        run.bar = "parts";
        run.parts = kParts;
        run.output = folder / "table.csv";
        run.measure = [](Task task, Work&) {
            if (task.part >= kParts - kLeft) throw Cancelled();
            return Json(task.part);
        };
        Session quiet(Language::English, std::stop_token());
        quiet.setQuiet(true);
        try {
            doParts(run, quiet);
            _exit(2);
        } catch (const Cancelled&) {
        }
        run.earlier = EarlierRun::Resume;
        run.measure = [&](Task task, Work&) {
            std::this_thread::sleep_for(kPart);
            return Json(task.part);
        };
        Session session(Language::English, std::stop_token());
        const std::optional<PartsDone> done = doParts(run, session);
        _exit(done && done->results.size() == kParts ? 0 : 1);
    }
    std::string text;
    char bytes[4096];
    // The terminal closes with the child, which is reported as an error, not as the end of the file.
    for (ssize_t got = 0; (got = ::read(terminal, bytes, sizeof bytes)) > 0;) {
        text.append(bytes, static_cast<std::size_t>(got));
    }
    ::close(terminal);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << text;
    EXPECT_NE(text.find(" 75% "), std::string::npos) << text;
}

}  // namespace
}  // namespace relief::app
