// Frees what is large aside: to give a hundred megabytes back takes the time of several pictures, and the window's
// thread has no time for it.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "workspace/aside.h"

namespace reliefui {

// While the application of the window lives, which waits for what is freed; without one there is nobody to hold.
inline std::atomic<bool>& freesAside() {
    static std::atomic<bool> on{false};
    return on;
}

// Deleter of shared pointers, whichever thread lets go last.
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

// Lets go of the value aside.
template <class T>
void discard(T value) {
    FreeAside{}(new T(std::move(value)));
}

}  // namespace reliefui
