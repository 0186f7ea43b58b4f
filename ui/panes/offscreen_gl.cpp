#include "panes/offscreen_gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <QVTKOpenGLNativeWidget.h>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "painting/drawing.h"
#include "relief/errors.h"

namespace reliefui {

namespace {

constexpr int kMajor = 3;  // version of OpenGL's core profile
constexpr int kMinor = 2;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::OffscreenGl)
};

[[noreturn]] void fail() {
    throw relief::WorkError(
        "trace", plainText(Texts::tr("this machine has no OpenGL that draws without a window").toStdString()));
}

}  // namespace

struct OffscreenGl::ByQt {
    ByQt() : before(QOpenGLContext::currentContext()), surfaceBefore(before != nullptr ? before->surface() : nullptr) {
        surface.setFormat(QVTKOpenGLNativeWidget::defaultFormat());
        surface.create();
        context.setFormat(surface.format());
        if (!context.create() || !context.makeCurrent(&surface)) fail();
    }
    ~ByQt() {
        context.doneCurrent();
        if (before != nullptr && surfaceBefore != nullptr) before->makeCurrent(surfaceBefore);
    }
    ByQt(const ByQt&) = delete;
    ByQt& operator=(const ByQt&) = delete;

    QOpenGLContext* before;
    QSurface* surfaceBefore;
    QOffscreenSurface surface;
    QOpenGLContext context;
};

struct OffscreenGl::ByEgl {
    ByEgl() : display(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) fail();
        eglBindAPI(EGL_OPENGL_API);
        const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglChooseConfig(display, attributes, &config, 1, &count);
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  kMajor,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  kMinor,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        context = eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (context != EGL_NO_CONTEXT && makeCurrent()) return;
        end();
        fail();
    }
    ~ByEgl() { end(); }
    ByEgl(const ByEgl&) = delete;
    ByEgl& operator=(const ByEgl&) = delete;

    bool makeCurrent() const { return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE; }
    void end() const {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }

    EGLDisplay display;
    EGLContext context = EGL_NO_CONTEXT;
};

OffscreenGl::OffscreenGl() {
    // Qt's offscreen platform does not support OpenGL.
    if (QGuiApplication::platformName() == QLatin1String("xcb")) {
        qt_ = std::make_unique<ByQt>();
    } else {
        egl_ = std::make_unique<ByEgl>();
    }
}

OffscreenGl::~OffscreenGl() = default;

void OffscreenGl::makeCurrent() {
    if (qt_) qt_->context.makeCurrent(&qt_->surface);
    if (egl_) egl_->makeCurrent();
}

}  // namespace reliefui
