// A pane with the pyramid in three dimensions (SlabScene). Drag rotates, right drag moves, the wheel zooms, R resets
// the view, a click chooses a step.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include <vtkSmartPointer.h>
#include <QWidget>

#include "panes/deferred_call.h"
#include "panes/pyramid/slab_scene.h"

class QMouseEvent;
class QVTKOpenGLNativeWidget;
class vtkGenericOpenGLRenderWindow;

namespace reliefui {

class PyramidStack : public QWidget {
    Q_OBJECT
  public:
    explicit PyramidStack(QWidget* parent = nullptr);
    ~PyramidStack() override;

    // Builds the slabs; call it again if the map, the ray or the style changes. Keeps a reference to the parts.
    void show(const PyramidParts& parts, const Style& style);
    // Shows the marks up to this step.
    void showStep(int step);
    void releaseContents();
    void fit();
    const Turntable& camera() const { return scene_.camera; }

    // Position, in pixels of this widget, of a texel of a level of pyramid `part`.
    QPointF toWidget(std::size_t part, int level, Point texel) const;
    // Finds the foremost slab at the point and the corresponding place on the flat drawing; returns false if there is
    // none.
    bool drawingAt(QPointF widget, Point& drawing) const;

  signals:
    // The slabs have to be shown again.
    void resized();
    void clickedAt(const reliefui::Point& drawing);
    void hoveredAt(const reliefui::Point& drawing);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool handleMouse(QMouseEvent* event, bool released);
    void showAll();
    void render();
    void readAgain();

    QVTKOpenGLNativeWidget* widget_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    SlabScene scene_;
    QPointF pressed_;
    bool turned_ = false;  // rotated by the user; kept for other rays
    QPointF last_;
    std::optional<QPointF> pointer_;  // where the pointer is; none while it is elsewhere
    // Size of the view, and ground and number of levels, for which the camera was placed.
    std::pair<QSize, std::array<double, 3>> placedFor_;
    DeferredCall deferredRender_{this, [this] { render(); }};
};

}  // namespace reliefui
