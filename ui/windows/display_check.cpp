#include "windows/display_check.h"

#include <cstdlib>

#include "panes/screen_gl.h"
#include "workspace/language.h"

// Included after Qt, because it defines the macro Bool.
#include <X11/Xlib.h>

namespace reliefui {

namespace {

std::string problemText(relief::MessageId what, const char* name = "") {
    return relief::sentence(relief::Message(what, {{"name", name}}), uiLanguage());
}

}  // namespace

std::string displayProblem() {
    const char* const name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0') return problemText(relief::MessageId::DisplayNone);
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return problemText(relief::MessageId::DisplayClosed, name);
    XCloseDisplay(display);
    return {};
}

std::string glProblem() {
    return screenHasGl() ? std::string() : problemText(relief::MessageId::DisplayNoGl, std::getenv("DISPLAY"));
}

bool needsDoubleScale() {
    constexpr int kWide = 3200;
    constexpr int kHigh = 2000;
    constexpr double kPlainDpi = 96;
    for (const char* const variable : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"}) {
        const char* const value = std::getenv(variable);
        if (value != nullptr && *value != '\0') return false;
    }
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return false;
    const int screen = DefaultScreen(display);
    const bool large = DisplayWidth(display, screen) >= kWide && DisplayHeight(display, screen) >= kHigh;
    const char* const dpi = XGetDefault(display, "Xft", "dpi");
    const bool silent = dpi == nullptr || std::atof(dpi) <= kPlainDpi;
    XCloseDisplay(display);
    return large && silent;
}

}  // namespace reliefui
