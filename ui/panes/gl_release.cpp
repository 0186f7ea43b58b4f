#include "panes/gl_release.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>
#include <QCoreApplication>
#include <QResizeEvent>

namespace reliefui {

namespace {

constexpr QSize kLittle(8, 8);

// Qt recreates the OpenGL context of a widget only when it has a non-empty size, but while many panes are laid out it
// may be shown without one. Qt would then compose the window with a context that does not exist yet. Giving the widget
// a size for a moment creates the context at once.
class RecreateContextOnShow : public QObject {
  public:
    explicit RecreateContextOnShow(QVTKOpenGLNativeWidget& widget) : QObject(&widget), widget_(widget) {
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
    // Must be called while the context exists and is current: if only Qt reports the end of the context, VTK leaves
    // buffers and text textures in the shared contexts for as long as the window lives.
    widget.makeCurrent();
    widget.renderWindow()->ReleaseGraphicsResources(widget.renderWindow());
    widget.doneCurrent();
    const QSize before = widget.size();
    // Qt would delay the resize event of a hidden widget until it is shown, so it is sent explicitly.
    widget.resize(kLittle);
    QResizeEvent event(kLittle, before);
    QCoreApplication::sendEvent(&widget, &event);
    // The event that Qt sends to an OpenGL widget that moves to another window; the widget releases its context. It is
    // hidden meanwhile, because it would otherwise recreate the context at once.
    const bool shown = !widget.isHidden();
    widget.hide();
    QEvent other(QEvent::WindowChangeInternal);
    QCoreApplication::sendEvent(&widget, &other);
    new RecreateContextOnShow(widget);
    if (shown) widget.show();
    // Makes the layout restore the original size.
    widget.updateGeometry();
}

}  // namespace reliefui
