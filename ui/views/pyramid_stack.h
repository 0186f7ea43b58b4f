// The pyramid in three dimensions: each level a slab above the finer one, with the very texels and marks that the flat
// pane draws, and the way of the ray from step to step between them. Drag turns, right drag moves, wheel zooms, R fits,
// a click chooses a step.
#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>
#include <QWidget>

#include "drawings/style.h"
#include "views/pyramid_parts.h"
#include "views/soon.h"
#include "views/turntable.h"

class QMouseEvent;
class QVTKOpenGLNativeWidget;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace reliefui {

class PyramidStack : public QWidget {
    Q_OBJECT
  public:
    explicit PyramidStack(QWidget* parent = nullptr);
    ~PyramidStack() override;

    // The slabs: made anew with the map, the ray's surroundings or the style.
    void show(const PyramidParts& parts, const Style& style);
    // The marks up to this step; `parts` are those shown.
    void showStep(const PyramidParts& parts, int step);
    void letGo();
    void fit();

    // Where a place of a level is seen; of the part-th pyramid. Pixels of this widget.
    QPointF toWidget(std::size_t part, int level, Point texel) const;
    // The uppermost slab under the point, and the place on the flat drawing; false: none.
    bool drawingAt(QPointF widget, Point& drawing) const;

  signals:
    void clickedAt(const reliefui::Point& drawing);
    void hoveredAt(const reliefui::Point& drawing);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    // Where a block of the flat drawing lies in space: X to the right, Y to the back, Z up; a slab is about 1 wide.
    struct Slab {
        LevelBlock block;
        double x = 0;  // of its corner
        double y = 0;
        double z = 0;
        double unit = 1;  // a unit of the drawing

        Turntable::Place at(Point drawing, double above = 0) const {
            return {x + (drawing.x - block.box.x0) * unit, y - (drawing.y - block.box.y0) * unit, z + above};
        }
    };

    const Slab* slabOf(Point drawing) const;
    void place(const PyramidParts& parts);
    void addSlab(const Slab& slab, const PyramidPart& part);
    void addTitle(const Slab& slab, const Drawing& levels);
    void addWay(const PyramidPart& part, const std::vector<const Slab*>& slabs, std::size_t chosen);
    void addLines(const std::vector<std::pair<Turntable::Place, Turntable::Place>>& lines, Rgba color, double width);
    bool handleMouse(QMouseEvent* event, bool released);
    void showAll();
    void render();

    QVTKOpenGLNativeWidget* widget_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> renderer_;
    Style style_;
    std::vector<Slab> slabs_;
    std::vector<std::size_t> firsts_;  // of each part's slabs
    struct Marks;
    std::unique_ptr<Marks> marks_;
    Turntable camera_;
    QPointF pressed_;
    QPointF last_;
    bool placed_ = false;
    Soon renderSoon_{this, [this] { render(); }};
};

}  // namespace reliefui
