#include "panes/offscreen_gl.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "painting/drawing.h"
#include "panes/screen_gl.h"
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

OffscreenGl::OffscreenGl() {
    // Qt's offscreen platform does not support OpenGL, and VTK does not draw in what Qt finds without GLX.
    if (QGuiApplication::platformName() == QLatin1String("xcb") && screenHasGl()) {
        qt_ = std::make_unique<ByQt>();
    } else {
        EglProblem problem{};
        egl_ = EglContext::make(kMajor, kMinor, EglPlace::Nowhere, problem);
        if (!egl_) fail();
    }
}

OffscreenGl::~OffscreenGl() = default;

void OffscreenGl::makeCurrent() {
    if (qt_) qt_->context.makeCurrent(&qt_->surface);
    if (egl_) egl_->makeCurrent();
}

}  // namespace reliefui
