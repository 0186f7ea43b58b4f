// The pyramid in three dimensions (SlabScene) as a pane. Drag turns, right drag moves, wheel zooms, R fits,
// a click chooses a step.
#pragma once

#include <array>
#include <utility>

#include <vtkSmartPointer.h>
#include <QWidget>

#include "panes/pyramid/slab_scene.h"
#include "panes/soon.h"

class QMouseEvent;
class QVTKOpenGLNativeWidget;
class vtkGenericOpenGLRenderWindow;

namespace reliefui {

class PyramidStack : public QWidget {
    Q_OBJECT
  public:
    explicit PyramidStack(QWidget* parent = nullptr);
    ~PyramidStack() override;

    // The slabs: made anew with the map, the ray or the style. The parts are referred to.
    void show(const PyramidParts& parts, const Style& style);
    // The marks up to this step.
    void showStep(int step);
    void letGo();
    void fit();
    const Turntable& camera() const { return scene_.camera; }

    // Where a place of a level is seen; of the part-th pyramid. Pixels of this widget.
    QPointF toWidget(std::size_t part, int level, Point texel) const;
    // The foremost slab under the point, and the place on the flat drawing; false: none.
    bool drawingAt(QPointF widget, Point& drawing) const;

  signals:
    // The slabs are to be shown anew.
    void resized();
    void clickedAt(const reliefui::Point& drawing);
    void hoveredAt(const reliefui::Point& drawing);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool handleMouse(QMouseEvent* event, bool released);
    void showAll();
    void render();

    QVTKOpenGLNativeWidget* widget_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    SlabScene scene_;
    QPointF pressed_;
    bool turned_ = false;  // by hand: another ray leaves it so
    QPointF last_;
    // What the camera was put for: a view of this size, of so much ground and so many levels.
    std::pair<QSize, std::array<double, 3>> placedFor_;
    Soon renderSoon_{this, [this] { render(); }};
};

}  // namespace reliefui
