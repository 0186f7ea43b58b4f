#include "panes/gl_release.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>
#include <QCoreApplication>
#include <QResizeEvent>

namespace reliefui {

namespace {

constexpr QSize kLittle(8, 8);

// Shown without any room, as while many panes are laid out, a widget of OpenGL would begin anew only when it has some.
// But Qt composes the window before that, and asks a context that is still to come. So it begins at once.
class BeginAtOnce : public QObject {
  public:
    explicit BeginAtOnce(QVTKOpenGLNativeWidget& widget) : QObject(&widget), widget_(widget) {
        widget.installEventFilter(this);
    }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::Show) return false;
        if (const QSize room = widget_.size(); !widget_.isValid() && room.isEmpty()) {
            widget_.resize(kLittle);
            widget_.resize(room);
        }
        deleteLater();
        return false;
    }

  private:
    QVTKOpenGLNativeWidget& widget_;
};

}  // namespace

void releaseGl(QVTKOpenGLNativeWidget& widget) {
    if (widget.isVisible() || !widget.isValid()) return;
    // While the context is there and current: told of its end by Qt alone, VTK leaves buffers and textures of text with
    // those that share it, as long as the window lives.
    widget.makeCurrent();
    widget.renderWindow()->ReleaseGraphicsResources(widget.renderWindow());
    widget.doneCurrent();
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
    new BeginAtOnce(widget);
    if (wanted) widget.show();
    // The layout is to make it as large as it was.
    widget.updateGeometry();
}

}  // namespace reliefui
