// Work in the background that nobody waits for: on the threads of Qt's pool, which the application waits for at its
// end.
#pragma once

#include <functional>

namespace reliefui {

// Calls it soon, on another thread. Thread safe.
void runAside(std::function<void()> call);

}  // namespace reliefui
