#include "windows/display_check.h"

#include <cstdlib>

#include <X11/Xlib.h>

namespace reliefui {

std::string displayProblem() {
    const char* const name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0') return "there is no display (DISPLAY is not set)";
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return std::string("the display ") + name + " cannot be opened";
    int opcode = 0;
    int event = 0;
    int error = 0;
    const bool glx = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
    XCloseDisplay(display);
    return glx ? std::string() : std::string("the display ") + name + " has no OpenGL (extension GLX)";
}

}  // namespace reliefui
