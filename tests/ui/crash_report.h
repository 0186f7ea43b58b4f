// What the test program prints when a signal ends it: the stack, and the last actions of the test.
#pragma once

#include <string_view>

namespace reliefui {

// Installs handlers that report a crash on stderr; the program then ends as it would without them.
void reportCrashes();

// Records an action that a test is about to perform; a crash prints the last ones. To be called from the tests' thread
// only.
void rememberForCrash(std::string_view text);

}  // namespace reliefui
