// A crash of the tests must be reported with its place and the preceding actions, since a rare one could not be found
// otherwise.
#include "crash_report.h"

#include <csignal>
#include <string>

#include <gtest/gtest.h>

namespace reliefui {

// Not static: its name must appear in the report.
[[gnu::noinline]] void crashInTheMidst(int signal) {
    constexpr int kManySteps = 100;
    for (int i = 0; i < kManySteps; ++i) rememberForCrash("step " + std::to_string(i) + ".");
    raise(signal);
    rememberForCrash("survived");
}

namespace {

class CrashReportDeathTest : public ::testing::TestWithParam<int> {
  protected:
    void SetUp() override { ::testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_P(CrashReportDeathTest, saysTheLastSteps) {
    EXPECT_DEATH(crashInTheMidst(GetParam()), "the last steps:\nstep 75\\.\nstep 76\\.(.|\n)*step 99\\.\n");
}

#ifndef __SANITIZE_ADDRESS__
TEST_P(CrashReportDeathTest, saysWhereAndDiesOfTheSignal) {
    EXPECT_EXIT(crashInTheMidst(GetParam()), ::testing::KilledBySignal(GetParam()),
                "the tests crash: SIG[A-Z]+ in thread (.|\n)*crashInTheMidst");
}
#endif

INSTANTIATE_TEST_SUITE_P(Signals, CrashReportDeathTest, ::testing::Values(SIGSEGV, SIGABRT, SIGFPE, SIGBUS));

}  // namespace
}  // namespace reliefui
