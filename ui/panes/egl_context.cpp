#include "panes/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace reliefui {

// The display stays initialised: other contexts of the process may use the same one, and eglTerminate() would end them.
struct EglContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

namespace {

EGLContext contextOf(EGLDisplay display, int major, int minor) {
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, attributes, &config, 1, &count);
    const std::vector<EGLint> version{EGL_CONTEXT_MAJOR_VERSION,       major,
                                      EGL_CONTEXT_MINOR_VERSION,       minor,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    const auto made = [&](std::initializer_list<EGLint> more) {
        std::vector<EGLint> all = version;
        all.insert(all.end(), more);
        all.push_back(EGL_NONE);
        return eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, all.data());
    };
    // Where the driver can: a card that is reset ends the context, not the process.
    EGLContext context = made({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    if (context == EGL_NO_CONTEXT) context = made({});
    if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) return context;
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
}

// The X screen, if wanted and present; then none, which Mesa can do without.
std::vector<EGLDisplay> displaysOf(EglPlace place) {
    std::vector<EGLDisplay> all;
    const char* const screen = std::getenv("DISPLAY");
    if (place == EglPlace::Screen && screen != nullptr && *screen != '\0') {
        all.push_back(eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, EGL_DEFAULT_DISPLAY, nullptr));
    }
    all.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    return all;
}

// The graphics cards: some drivers give a context without a display only for a card.
std::vector<EGLDisplay> displaysOfCards() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 8> cards{};
    EGLint count = 0;
    if (query == nullptr || query(static_cast<EGLint>(cards.size()), cards.data(), &count) == EGL_FALSE) return {};
    std::vector<EGLDisplay> all;
    for (EGLint n = 0; n < count; ++n) {
        all.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, cards[static_cast<std::size_t>(n)], nullptr));
    }
    return all;
}

}  // namespace

EglContext::EglContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}

std::unique_ptr<EglContext> EglContext::make(int major, int minor, EglPlace place, EglProblem& problem) {
    problem = EglProblem::NoEgl;
    const auto madeOn = [&](const std::vector<EGLDisplay>& displays) -> std::unique_ptr<EglContext> {
        for (const EGLDisplay display : displays) {
            if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) continue;
            problem = EglProblem::NoVersion;
            const EGLContext context = contextOf(display, major, minor);
            if (context == EGL_NO_CONTEXT) continue;
            return std::unique_ptr<EglContext>(new EglContext(std::make_unique<Handles>(Handles{display, context})));
        }
        return nullptr;
    };
    auto made = madeOn(displaysOf(place));
    return made ? std::move(made) : madeOn(displaysOfCards());
}

EglContext::~EglContext() {
    eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(handles_->display, handles_->context);
}

bool EglContext::makeCurrent() const {
    return eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context) == EGL_TRUE;
}

bool EglContext::anyCurrent() {
    return eglGetCurrentContext() != EGL_NO_CONTEXT;
}

void* EglContext::function(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

}  // namespace reliefui
