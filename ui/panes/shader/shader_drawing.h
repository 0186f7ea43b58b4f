// The pictures of the shader and of the CPU, and their difference, as a drawing; below them the numbers.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "painting/range_legend.h"
#include "panes/shader/shader_data.h"

namespace reliefui {

// preview: without a problem. range: of the differences. pixel: the chosen one. timed: with the time of a frame and the
// name of what draws, which differ from run to run. before: the pictures are those of an earlier view.
struct ShaderSource {
    std::shared_ptr<const ShaderPreview> preview;
    ShaderMeasure measure = ShaderMeasure::Colors;
    ColorRange range;
    std::optional<relief::PixelChoice> pixel;
    bool timed = true;
    bool before = false;
};

RangeOf shaderRangeOf(ShaderMeasure measure);
// The differences as values in colours.
RangedValues shaderValues(const ShaderSource& source, relief::Language language);

// rooms: of the three pictures.
struct ShaderPicture {
    Drawing drawing;
    std::array<Box, 3> rooms;
    double pixelSide = 1;

    // The pixel of the picture at this point of the drawing.
    std::optional<relief::PixelChoice> pixelAt(Point at) const;
};
// width, height: in points.
ShaderPicture shaderPicture(const ShaderSource& source, double width, double height, relief::Language language);
// The colour scale; the speed with the errors; what both pictures have in place of the scenario's settings.
Drawing shaderLegend(const ShaderSource& source, double width, relief::Language language);
// The lines of the legend.
std::vector<relief::Message> shaderLines(const ShaderSource& source);
// The time of a frame and the number of hits that differ, for a pane without room for more.
relief::Message shaderSummary(const ShaderPreview& preview);
// The differences of a pixel, in one line.
relief::Message shaderReadout(const ShaderPreview& preview, relief::PixelChoice pixel);

}  // namespace reliefui
