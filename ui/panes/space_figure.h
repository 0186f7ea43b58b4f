// A 3-D figure, rendered off-screen with OpenGL, without a window or display.
#pragma once

#include "panes/figure.h"

class vtkGenericOpenGLRenderWindow;

namespace reliefui {

class Turntable;

// Turns the camera by this angle in degrees, and moves it back to where all is visible from every angle. fit: moves the
// camera as close as the present angle allows.
void turnForOrbit(Turntable& camera, double degrees, const std::function<void()>& fit);

class SpaceFigure : public Figure {
  public:
    bool vectors() const override { return false; }
    void paint(QPainter& painter, const Box& page, const Style& style) const override;
    // Throws WorkError if OpenGL is not available.
    QImage image(const FigurePage& page, const QSize& size) const override;

  protected:
    // Adds the scene to the render window, renders it at this size in pixels, and removes it again.
    virtual QImage draw(vtkGenericOpenGLRenderWindow& window, const Style& style, const QSize& pixels) const = 0;
    static QImage rendered(vtkGenericOpenGLRenderWindow& window, const QSize& pixels);
};

}  // namespace reliefui
