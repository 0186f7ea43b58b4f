// The pyramid in three dimensions (SlabTower), in a renderer, for the pane and for files: slabs in the colours of their
// heights, outlined in those of the decisions about them, and the way of the ray over, into and between the levels,
// faint where slabs hide it. It belongs to no window.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h>
#include <QCoreApplication>

#include "painting/style.h"
#include "panes/pyramid/slab_tower.h"
#include "panes/turntable.h"

class vtkActor;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace reliefui {

class SlabScene {
    Q_DECLARE_TR_FUNCTIONS(reliefui::SlabScene)
  public:
    SlabScene();
    ~SlabScene();
    SlabScene(const SlabScene&) = delete;
    SlabScene& operator=(const SlabScene&) = delete;

    vtkRenderer* renderer() const;
    void addTo(vtkRenderWindow* window) const;
    void takeFrom(vtkRenderWindow* window) const;
    // The slabs: made anew with the map, the ray or the style (in the pixels of the window). The parts are referred to.
    void show(const PyramidParts& parts, const Style& style);
    // The marks up to this step.
    void showStep(int step);
    void letGo();
    // All slabs and their titles in sight, in a view of so many pixels, without turning.
    void showAll(double width, double height);
    // As at first: from above, the ray from left to right.
    void lookFromHome();
    // Puts the camera into the renderer: before each rendering.
    void place();

    const SlabTower& tower() const { return tower_; }
    // Where a place of a level of the part-th pyramid is seen, in pixels of the renderer, y upwards: on the slab there.
    std::array<double, 2> toPixel(std::size_t part, int level, Point texel) const;
    // The foremost slab under such a pixel, and the place on the flat drawing; nothing: none.
    std::optional<Point> drawingAt(double x, double y) const;

    Turntable camera{kHalfView};

  private:
    using Line = std::pair<Turntable::Place, Turntable::Place>;
    static constexpr double kHalfView = 0.06;  // levels far up are seen as those below

    void addBodies(std::size_t part);
    void addGround(std::size_t part);
    void addTitles();
    // Of a pyramid's ground those corners that are seen furthest to the left, and nearest, from home.
    Point leftCorner(std::size_t part) const;
    Point nearCorner(std::size_t part) const;
    vtkSmartPointer<vtkTextActor> words(const std::string& said) const;
    // Beside the place, left of it, or below it.
    void addWords(const std::string& said, const Turntable::Place& at, bool beside);
    vtkSmartPointer<vtkActor> addLines(const std::vector<Line>& lines, Rgba color, double width, bool before = false);
    void addMarks(std::size_t part, std::size_t chosen);
    void addWay(std::size_t part, std::size_t chosen);
    // Remembers what the next step replaces.
    void keep(const vtkSmartPointer<vtkActor>& mark);
    std::vector<Line> rim(std::size_t part, const Box& ground, double z) const;

    vtkSmartPointer<vtkRenderer> renderer_;
    Style style_;
    const PyramidParts* parts_ = nullptr;
    SlabTower tower_;
    double titleWidth_ = 0;  // pixels
    std::vector<vtkSmartPointer<vtkProp>> marks_;
};

}  // namespace reliefui
