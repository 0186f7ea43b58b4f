// What the tests' program says when a signal ends it: where it was, and what the test did last.
#pragma once

#include <string_view>

namespace reliefui {

// From now on a crash is said on stderr, then ends the program as it would have without.
void reportCrashes();

// Something that a test is about to do; a crash tells the last ones. For the thread of the tests.
void rememberForCrash(std::string_view text);

}  // namespace reliefui
