// A 3-D figure, rendered off-screen by OpenGL: without a window, and without a display.
#pragma once

#include "panes/figure.h"

class vtkGenericOpenGLRenderWindow;

namespace reliefui {

class SpaceFigure : public Figure {
  public:
    bool vectors() const override { return false; }
    void paint(QPainter& painter, const Box& page, const Style& style) const override;
    // Throws WorkError where there is no OpenGL.
    QImage image(const FigurePage& page, const QSize& size) const override;

  protected:
    // Puts what it shows into the window, so many pixels large, renders it and takes it out again.
    virtual QImage draw(vtkGenericOpenGLRenderWindow& window, const Style& style, const QSize& pixels) const = 0;
    static QImage rendered(vtkGenericOpenGLRenderWindow& window, const QSize& pixels);
};

}  // namespace reliefui
