// The pyramid as a drawing: all levels side by side, values printed in the texels, and on each level the texels that
// the ray visited, in the order of its steps. [MIP18] figs. 2 to 5.
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

// Input of the drawing; holds references, not copies.
struct PyramidSource {
    const relief::HeightField* field = nullptr;
    // its kind determines whether its texels lie over cells or texels of the field
    std::shared_ptr<const relief::Pyramid> pyramid;
    int baseLevel = 0;      // of the steps, see stepBox()
    bool overCells = true;  // over the field's cells (maxima) or its texels (means)
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    const std::vector<relief::Step>* steps = nullptr;
    // show only the surroundings of the ray on all levels, if the ray is not longer than the texture
    bool nearRay = false;
    bool slender = false;  // limit the surroundings to what the ray needs, however long and narrow
};

// Lambda at the end of the ray: its hit, or where the tracer gave up.
double rayEnd(const PyramidSource& source);

// The levels alone; built again only if the map or the size (in points) changes.
struct PyramidPicture {
    std::vector<LevelBlock> blocks;
    Drawing levels;
    bool wraps = false;  // the blocks show one period, into which the ray is wrapped
};
// origin: upper left corner.
PyramidPicture pyramidPicture(const PyramidSource& source, double width, double height, Point origin = {});

// The ray and its steps on the blocks. Steps after the chosen one are drawn faintly.
Drawing pyramidMarks(const PyramidSource& source, const PyramidPicture& picture, int step);

// Legend of heights and of the decisions that occur, at most `width` points wide. brief: without the histogram.
Drawing pyramidLegend(const PyramidSource& source, const RangedValues& heights, double width, relief::Language language,
                      bool brief = false);

}  // namespace reliefui
