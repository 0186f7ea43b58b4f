// The 3-D trace and the slabs of the pyramid as pixels, without a window.
#include <algorithm>
#include <cmath>
#include <functional>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObject.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "views/figure_parts.h"
#include "views/offscreen_gl.h"
#include "views/slab_scene.h"
#include "views/trace3d_picture.h"

namespace reliefui {

namespace {

constexpr double kMmPerPoint = 25.4 / 72;
constexpr int kLargestSide = 8192;  // larger pictures are enlarged: what all drivers draw

// Thin lines and small words are smoother when they are drawn twice as large first.
int finerBy(const QSize& size) {
    constexpr int kSmall = 3000;
    return std::max(size.width(), size.height()) <= kSmall ? 2 : 1;
}

QImage pixelsOf(vtkGenericOpenGLRenderWindow* window, const QSize& size) {
    auto data = vtkSmartPointer<vtkUnsignedCharArray>::New();
    window->GetPixelData(0, 0, size.width() - 1, size.height() - 1, 0, data, 0);
    QImage image(size, QImage::Format_RGB888);
    for (int y = 0; y < size.height(); ++y) {
        const unsigned char* const row = data->GetPointer(vtkIdType{3} * size.width() * (size.height() - 1 - y));
        std::copy(row, row + 3 * size.width(), image.scanLine(y));
    }
    return image.convertToFormat(QImage::Format_RGB32);
}

// VTK's loader of functions knows GLX only and complains of EGL, though it finds them all.
class Quiet {
  public:
    Quiet() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~Quiet() { vtkObject::SetGlobalWarningDisplay(before_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    int before_;
};

// A picture that puts itself into a window: addTo, takeFrom. fill: what is drawn, in this style, on so many pixels.
template <class Picture>
QImage imageOf(const Picture& picture, const FigureRequest& request, const QSize& size,
               const std::function<void(const Style& style, const QSize& pixels)>& fill) {
    QSize drawn = size;
    if (std::max(size.width(), size.height()) > kLargestSide)
        drawn.scale(kLargestSide, kLargestSide, Qt::KeepAspectRatio);
    drawn *= finerBy(drawn);
    Style style = request.style;
    style.projector = false;
    style.screenPixelsPerPoint = drawn.width() / (request.widthMm / kMmPerPoint);
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
    picture.addTo(window);
    window->OpenGLInitContext();
    // The loader of functions, which knows GLX only, makes VTK believe that there is nothing to be asked of the
    // context.
    window->OpenGLInitState();
    fill(style, drawn);
    window->Render();
    const QImage image = pixelsOf(window, drawn);
    picture.takeFrom(window);
    window->Finalize();
    QImage result = drawn == size ? image : image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const auto dots = static_cast<int>(std::lround(size.width() / request.widthMm * 1000));
    result.setDotsPerMeterX(dots);
    result.setDotsPerMeterY(dots);
    return result;
}

}  // namespace

QImage traceImage(const Snapshot& snapshot, const FigureRequest& request, const QSize& size) {
    TracePicture picture;
    return imageOf(picture, request, size, [&](const Style& style, const QSize& pixels) {
        picture.setSize(pixels);
        picture.setColors(request.trace.colors);
        picture.show(std::make_shared<const Snapshot>(snapshot), style, request.trace.exaggeration);
        picture.showStep(snapshot.scenario.step);
        if (request.trace.camera) {
            picture.camera = *request.trace.camera;
        } else {
            constexpr double kRoom = 0.85;  // for words at the sides
            picture.fit(kRoom);
        }
        picture.place();
    });
}

QImage slabsImage(const Snapshot& snapshot, const FigureRequest& request, const QSize& size) {
    SlabScene scene;
    return imageOf(scene, request, size, [&](const Style& style, const QSize& pixels) {
        const double aspect = static_cast<double>(pixels.width()) / std::max(1, pixels.height());
        const double points = request.widthMm / kMmPerPoint;
        const PyramidParts parts = pyramidParts(snapshot, request.pyramid, points, points / aspect);
        scene.show(parts, style, points * style.screenPixelsPerPoint, points / aspect * style.screenPixelsPerPoint);
        scene.showStep(parts, snapshot.scenario.step);
        if (request.slabsCamera) scene.camera = *request.slabsCamera;
        // Seen from there; as near as the picture allows.
        scene.showAll(aspect);
        scene.place();
    });
}

}  // namespace reliefui
