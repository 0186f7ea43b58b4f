// A main() of our own: the surface format must be chosen before the QApplication is created, and without a display
// tests are skipped instead of aborted.
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
    std::string problem = reliefui::displayProblem();
    if (problem.empty()) problem = reliefui::glProblem();
    if (!problem.empty() || ::testing::GTEST_FLAG(list_tests)) {
        if (!problem.empty()) std::fprintf(stderr, "the window is not tested: %s\n", problem.c_str());
        return RUN_ALL_TESTS();
    }
    // The tests do not use the user's list of recent files.
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    reliefui::prepareWindows();
    reliefui::Application application(count, values);
    reliefui::setUpApplication(application);
    reliefui::haveDisplay() = true;
    const int failed = RUN_ALL_TESTS();
#ifdef __SANITIZE_ADDRESS__
    // Checked now, while the display's drivers are loaded: after they are unloaded their leaks could not be
    // distinguished from ours.
    __lsan_do_leak_check();
#endif
    return failed;
}
