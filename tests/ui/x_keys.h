// Sends keys to a window of another process, as an X client can.
#pragma once

namespace reliefui {

// Presses and releases the key that X calls `name` ("period") in the largest window of the process, which receives the
// focus. Returns false if the process has no window yet.
bool sendKey(long long process, const char* name);

}  // namespace reliefui
