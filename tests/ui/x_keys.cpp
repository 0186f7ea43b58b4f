#include "x_keys.h"

#include <memory>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace reliefui {

namespace {

// Returns 0 for windows without that property.
long long processOf(Display* display, Window window) {
    Atom type = 0;
    int format = 0;
    unsigned long count = 0;
    unsigned long rest = 0;
    unsigned char* data = nullptr;
    const Atom name = XInternAtom(display, "_NET_WM_PID", False);
    XGetWindowProperty(display, window, name, 0, 1, False, XA_CARDINAL, &type, &format, &count, &rest, &data);
    const long long process = data != nullptr && count == 1 ? *reinterpret_cast<long*>(data) : 0;
    if (data != nullptr) XFree(data);
    return process;
}

Window largestOf(Display* display, long long process) {
    Window root = 0;
    Window parent = 0;
    Window* windows = nullptr;
    unsigned int count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &windows, &count);
    Window found = 0;
    int largest = 0;
    for (unsigned int i = 0; i < count; ++i) {
        XWindowAttributes attributes;
        if (XGetWindowAttributes(display, windows[i], &attributes) == 0) continue;
        const int size = attributes.width * attributes.height;
        if (attributes.map_state != IsViewable || size <= largest || processOf(display, windows[i]) != process)
            continue;
        found = windows[i];
        largest = size;
    }
    if (windows != nullptr) XFree(windows);
    return found;
}

}  // namespace

bool sendKey(long long process, const char* name) {
    const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
    if (!display) return false;
    const Window window = largestOf(display.get(), process);
    if (window == 0) return false;
    XSetInputFocus(display.get(), window, RevertToParent, CurrentTime);
    XKeyEvent event{};
    event.display = display.get();
    event.window = window;
    event.root = DefaultRootWindow(display.get());
    event.same_screen = True;
    event.keycode = XKeysymToKeycode(display.get(), XStringToKeysym(name));
    for (const int type : {KeyPress, KeyRelease}) {
        event.type = type;
        XSendEvent(display.get(), window, True, type == KeyPress ? KeyPressMask : KeyReleaseMask,
                   reinterpret_cast<XEvent*>(&event));
    }
    XSync(display.get(), False);
    return true;
}

}  // namespace reliefui
