// The pyramid in three dimensions, in a renderer, for the pane and for files: each level a slab above the finer one,
// with the very texels and marks that the flat pane draws, and the way of the ray from step to step between them. The
// slabs stand in as many piles beside each other as make them largest in the room there is; none hides another or its
// title. It belongs to no window.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h>

#include "painting/style.h"
#include "panes/pyramid/pyramid_parts.h"
#include "panes/turntable.h"

class vtkProp;
class vtkRenderWindow;
class vtkRenderer;

namespace reliefui {

class SlabScene {
  public:
    SlabScene();
    ~SlabScene();
    SlabScene(const SlabScene&) = delete;
    SlabScene& operator=(const SlabScene&) = delete;

    vtkRenderer* renderer() const;
    void addTo(vtkRenderWindow* window) const;
    void takeFrom(vtkRenderWindow* window) const;
    // The slabs: made anew with the map, the ray's surroundings or the style (in the pixels of the window), for a view
    // of this size in pixels. Whether they stand in the piles of before.
    bool show(const PyramidParts& parts, const Style& style, double width, double height);
    // The marks up to this step; `parts` are those shown.
    void showStep(const PyramidParts& parts, int step);
    void letGo();
    // All slabs in sight. aspect: width over height of the view.
    void showAll(double aspect);
    // Puts the camera into the renderer: before each rendering.
    void place();

    // Where a place of a level of the part-th pyramid is seen, in pixels of the renderer, y upwards.
    std::array<double, 2> toPixel(std::size_t part, int level, Point texel) const;
    // The uppermost slab under such a pixel, and the place on the flat drawing; nothing: none.
    std::optional<Point> drawingAt(double x, double y) const;

    Turntable camera{kHalfView};

  private:
    static constexpr double kHalfView = 0.06;  // slabs far up are seen as those below
    // Where a block of the flat drawing lies in space: X to the right, Y to the back, Z up; a slab is about 1 wide.
    struct Slab {
        LevelBlock block;
        double x = 0;  // of its corner
        double y = 0;
        double z = 0;
        double unit = 1;  // a unit of the drawing
        int pile = 0;
        double titleWidth = 0;  // of the text at its front edge
        double titleHeight = 0;

        Turntable::Place at(Point drawing, double above = 0) const {
            return {x + (drawing.x - block.box.x0) * unit, y - (drawing.y - block.box.y0) * unit, z + above};
        }
    };

    const Slab* slabOf(Point drawing) const;
    void layOut(const PyramidParts& parts, double width, double height);
    void addSlab(const Slab& slab, const PyramidPart& part);
    void addTitle(const Slab& slab, const Drawing& levels);
    void addWay(const PyramidPart& part, const std::vector<const Slab*>& slabs, std::size_t chosen);
    void addMark(const Item& item, const Slab& slab);
    void addLines(const std::vector<std::pair<Turntable::Place, Turntable::Place>>& lines, Rgba color, double width);

    vtkSmartPointer<vtkRenderer> renderer_;
    Style style_;
    std::vector<Slab> slabs_;
    std::vector<std::size_t> firsts_;              // of each part's slabs
    std::vector<vtkSmartPointer<vtkProp>> marks_;  // replaced by the next step's
};

}  // namespace reliefui
