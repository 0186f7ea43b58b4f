// Frees large objects in the background: freeing 100 MB takes as long as several frames, which would block the window's
// thread.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "workspace/background_call.h"

namespace reliefui {

// True while a windowed application exists, which waits for pending destruction when it ends. Without one, objects are
// freed immediately, because there is no window to block.
inline std::atomic<bool>& freesInBackground() {
    static std::atomic<bool> on{false};
    return on;
}

// Deleter for shared pointers; may be called on any thread.
struct FreeInBackground {
    template <class T>
    void operator()(T* value) const {
        if (freesInBackground()) {
            runInBackground([value] { delete value; });
        } else {
            delete value;
        }
    }
};

template <class T, class... Arguments>
std::shared_ptr<T> makeFreedInBackground(Arguments&&... arguments) {
    return std::shared_ptr<T>(new T{std::forward<Arguments>(arguments)...}, FreeInBackground{});
}

// Destroys the value in the background.
template <class T>
void discard(T value) {
    FreeInBackground{}(new T(std::move(value)));
}

}  // namespace reliefui
