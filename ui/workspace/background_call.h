// Background work without a result. It runs on the threads of Qt's global pool, for which the application waits before
// it ends.
#pragma once

#include <functional>

namespace reliefui {

// Queues the call for another thread and returns at once. Thread safe.
void runInBackground(std::function<void()> call);

}  // namespace reliefui
