// The comparison of the shader with the CPU as a figure.
#pragma once

#include "panes/figure.h"
#include "panes/shader/shader_drawing.h"

namespace reliefui {

// Without the time of a frame, which a figure of another size does not have.
std::shared_ptr<const Figure> shaderFigure(ShaderSource source);
// The figure of a snapshot, which is drawn first. Throws InputError if the shader cannot be drawn.
std::shared_ptr<const Figure> drawnShader(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario& scenario);

}  // namespace reliefui
