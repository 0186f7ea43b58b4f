// The pyramid as a drawing: every level side by side, values in the texels, and on each level the texels that the ray
// visited, in the order of its steps. [MIP18] figs. 2 to 5.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "images/pyramid.h"
#include "painting/range_legend.h"
#include "painting/step_body.h"
#include "panes/pyramid/pyramid_layout.h"
#include "relief/height_field.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// What is drawn; referred to, not copied.
struct PyramidSource {
    const relief::HeightField* field = nullptr;
    std::shared_ptr<const relief::Pyramid> pyramid;  // its kind tells what its texels lie over
    int baseLevel = 0;                               // of the steps, see stepBox
    bool overCells = true;                           // of the field's cells (maxima), or of its texels (means)
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    const std::vector<relief::Step>* steps = nullptr;
    bool nearRay = false;  // only the surroundings of the ray, on all levels, if it is not longer than the texture
    bool slender = false;  // of these no more than the ray needs, however long and narrow that is
};

// Lambda where the ray ends: at its hit, or where it was given up.
double rayEnd(const PyramidSource& source);

// The levels alone: made anew only with the map or the room (points).
struct PyramidPicture {
    std::vector<LevelBlock> blocks;
    Drawing levels;
    bool wraps = false;  // the blocks show one period, into which the ray is wrapped
};
// origin: its upper left corner.
PyramidPicture pyramidPicture(const PyramidSource& source, double width, double height, Point origin = {});

// The ray and its steps on the blocks. Steps after the chosen one are drawn faintly.
Drawing pyramidMarks(const PyramidSource& source, const PyramidPicture& picture, int step);

// Heights and decisions, in at most `width` points; only decisions that occur. brief: without the histogram.
Drawing pyramidLegend(const PyramidSource& source, const RangedValues& heights, double width, relief::Language language,
                      bool brief = false);

}  // namespace reliefui
