// Frees large objects in the background: freeing 100 MB takes as long as several frames, which would block the window's
// thread.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "workspace/aside.h"

namespace reliefui {

// True while a windowed application exists, which waits for pending destruction when it ends. Without one, objects are
// freed immediately, because there is no window to block.
inline std::atomic<bool>& freesAside() {
    static std::atomic<bool> on{false};
    return on;
}

// Deleter for shared pointers; may be called on any thread.
struct FreeAside {
    template <class T>
    void operator()(T* value) const {
        if (freesAside()) {
            runAside([value] { delete value; });
        } else {
            delete value;
        }
    }
};

template <class T, class... Arguments>
std::shared_ptr<T> makeFreedAside(Arguments&&... arguments) {
    return std::shared_ptr<T>(new T{std::forward<Arguments>(arguments)...}, FreeAside{});
}

// Destroys the value in the background.
template <class T>
void discard(T value) {
    FreeAside{}(new T(std::move(value)));
}

}  // namespace reliefui
