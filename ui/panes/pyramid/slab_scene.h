// The pyramid in three dimensions (SlabTower) in a VTK renderer, for the pane and for files: slabs coloured by height
// and outlined by decision, and the ray's path over, into and between the levels, faint where slabs hide it. It is
// independent of any window.
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
    // Builds the slabs; call it again if the map, the ray or the style (in the window's pixels) changes. Keeps a
    // reference to the parts.
    void show(const PyramidParts& parts, const Style& style);
    // Shows the marks up to this step.
    void showStep(int step);
    void releaseContents();
    // Moves the camera so that all slabs and titles are visible in a view of this size in pixels, without rotating it.
    void showAll(double width, double height);
    // Sets the initial direction: from above, with the ray from left to right.
    void lookFromHome();
    // Applies the camera to the renderer, and hides the outlines of slabs that they would cover; call it before each
    // rendering.
    void place();

    const SlabTower& tower() const { return tower_; }
    // Position of a texel of a level of pyramid `part`, on the slab there, in pixels of the renderer, y upwards.
    std::array<double, 2> toPixel(std::size_t part, int level, Point texel) const;
    // Finds the foremost slab at such a pixel, and returns the corresponding place on the flat drawing; std::nullopt if
    // there is none.
    std::optional<Point> drawingAt(double x, double y) const;

    Turntable camera{kHalfView};

  private:
    using Line = std::pair<Turntable::Place, Turntable::Place>;
    static constexpr double kHalfView = 0.06;  // narrow angle, so that upper levels look like lower ones

    void addBodies(std::size_t part);
    void addGround(std::size_t part);
    void addTitles();
    // Corners of a pyramid's ground that are leftmost, and nearest, in the initial view.
    Point leftCorner(std::size_t part) const;
    Point nearCorner(std::size_t part) const;
    vtkSmartPointer<vtkTextActor> words(const std::string& content) const;
    // Adds text next to a place: left of it (`beside`), or below it.
    void addWords(const std::string& content, const Turntable::Place& at, bool beside);
    vtkSmartPointer<vtkActor> addLines(const std::vector<Line>& lines, Rgba color, double width, bool before = false);
    void addMarks(std::size_t part, std::size_t chosen);
    void addRayPath(std::size_t part, std::size_t chosen);
    // Registers a mark, which the next step removes.
    void keep(const vtkSmartPointer<vtkActor>& mark);
    std::vector<Line> rim(std::size_t part, const Box& ground, double z) const;

    vtkSmartPointer<vtkRenderer> renderer_;
    Style style_;
    const PyramidParts* parts_ = nullptr;
    SlabTower tower_;
    double titleWidth_ = 0;  // in pixels
    // The slabs' outlines, by level, with the slabs' side in texels.
    std::vector<std::pair<double, vtkSmartPointer<vtkActor>>> outlines_;
    std::vector<vtkSmartPointer<vtkProp>> marks_;
};

}  // namespace reliefui
