#include "panes/space_figure.h"

#include <algorithm>
#include <cmath>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObject.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "panes/offscreen_gl.h"
#include "panes/turntable.h"

namespace reliefui {

namespace {

constexpr int kLargestSide = 8192;  // in pixels, a size that all drivers support; larger pictures are scaled up

// Supersampling factor: small pictures are rendered at twice their size, for smoother lines and text.
int finerBy(const QSize& size) {
    constexpr int kSmall = 3000;
    return std::max(size.width(), size.height()) <= kSmall ? 2 : 1;
}

QImage pixelsOf(vtkGenericOpenGLRenderWindow& window, const QSize& size) {
    auto data = vtkSmartPointer<vtkUnsignedCharArray>::New();
    window.GetPixelData(0, 0, size.width() - 1, size.height() - 1, 0, data, 0);
    QImage image(size, QImage::Format_RGB888);
    for (int y = 0; y < size.height(); ++y) {
        const unsigned char* const row = data->GetPointer(vtkIdType{3} * size.width() * (size.height() - 1 - y));
        std::copy(row, row + 3 * size.width(), image.scanLine(y));
    }
    return image.convertToFormat(QImage::Format_RGB32);
}

// Suppresses the warnings of VTK's function loader, which knows only GLX and complains about EGL although it finds all
// functions.
class Quiet {
  public:
    Quiet() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~Quiet() { vtkObject::SetGlobalWarningDisplay(before_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    int before_;
};

}  // namespace

void turnForOrbit(Turntable& camera, double degrees, const std::function<void()>& fit) {
    constexpr int kAngles = 12;  // of the circle; between them the fitted distance hardly changes
    Turntable farthest = camera;
    for (int n = 0; n < kAngles; ++n) {
        camera.rotate(2 * M_PI / kAngles);
        fit();
        farthest.keepBack(camera);
    }
    camera.rotate(degrees * M_PI / 180);
    fit();
    camera.keepBack(farthest);
}

QImage SpaceFigure::rendered(vtkGenericOpenGLRenderWindow& window, const QSize& pixels) {
    window.Render();
    return pixelsOf(window, pixels);
}

void SpaceFigure::paint(QPainter& painter, const Box& page, const Style& style) const {
    const QSize size(static_cast<int>(page.width()), static_cast<int>(page.height()));
    FigurePage pixels;
    pixels.style = style;
    pixels.widthMm = page.width() / style.pixelsPerPoint() * kMmPerPoint;
    painter.drawImage(QPointF(page.x0, page.y0), image(pixels, size));
}

QImage SpaceFigure::image(const FigurePage& page, const QSize& size) const {
    QSize drawn = size;
    if (std::max(size.width(), size.height()) > kLargestSide)
        drawn.scale(kLargestSide, kLargestSide, Qt::KeepAspectRatio);
    drawn *= finerBy(drawn);
    Style style = page.style;
    style.projector = false;
    style.screenPixelsPerPoint = drawn.width() / (page.widthMm / kMmPerPoint);
    const Quiet quiet;
    OffscreenGl gl;
    auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    auto current = vtkSmartPointer<vtkCallbackCommand>::New();
    current->SetCallback([](vtkObject*, unsigned long, void*, void* answer) { *static_cast<bool*>(answer) = true; });
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, current);
    window->SetReadyForRendering(true);
    window->SetFrameBlitModeToNoBlit();
    window->SetMultiSamples(0);
    window->SetSize(drawn.width(), drawn.height());
    window->OpenGLInitContext();
    // Called explicitly, because the loader's failure makes VTK skip querying the context's state.
    window->OpenGLInitState();
    const QImage image = draw(*window, style, drawn);
    window->Finalize();
    QImage result = drawn == size ? image : image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const auto dots = static_cast<int>(std::lround(size.width() / page.widthMm * 1000));
    result.setDotsPerMeterX(dots);
    result.setDotsPerMeterY(dots);
    return result;
}

}  // namespace reliefui
