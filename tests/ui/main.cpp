// Own main: surfaces have to be chosen before the QApplication, and no display means skipped tests, not an abort.
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif
#include <QSettings>
#include <QTemporaryDir>

#include "crash_report.h"
#include "window_fixture.h"
#include "windows/application.h"
#include "windows/display_check.h"
#include "windows/program.h"

int main(int count, char** values) {
    reliefui::reportCrashes();
    ::testing::InitGoogleTest(&count, values);
    const std::string problem = reliefui::displayProblem();
    if (!problem.empty() || ::testing::GTEST_FLAG(list_tests)) {
        if (!problem.empty()) std::fprintf(stderr, "the window is not tested: %s\n", problem.c_str());
        return RUN_ALL_TESTS();
    }
    // The user's list of recent files is not ours.
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    reliefui::prepareWindows();
    reliefui::Application application(count, values);
    reliefui::setUpApplication(application);
    reliefui::haveDisplay() = true;
    const int failed = RUN_ALL_TESTS();
#ifdef __SANITIZE_ADDRESS__
    // Now, while the display's drivers are loaded: what they leak could not be told from ours when they are gone.
    __lsan_do_leak_check();
#endif
    return failed;
}
