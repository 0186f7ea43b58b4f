#include "views/gl_release.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QCoreApplication>
#include <QResizeEvent>

namespace reliefui {

void releaseGl(QVTKOpenGLNativeWidget& widget) {
    constexpr QSize kLittle(8, 8);
    if (widget.isVisible() || !widget.isValid()) return;
    const QSize before = widget.size();
    // Out of sight Qt would keep this to itself until the widget is shown.
    widget.resize(kLittle);
    QResizeEvent event(kLittle, before);
    QCoreApplication::sendEvent(&widget, &event);
    // What Qt itself tells a widget of OpenGL that comes into another window. Hidden for this moment by itself: it
    // would begin anew at once.
    const bool wanted = !widget.isHidden();
    widget.hide();
    QEvent other(QEvent::WindowChangeInternal);
    QCoreApplication::sendEvent(&widget, &other);
    if (wanted) widget.show();
    // The layout is to make it as large as it was.
    widget.updateGeometry();
}

}  // namespace reliefui
