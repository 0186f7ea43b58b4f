// The picture that the exported shader of the scenario's method draws, compared with the CPU's.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measuring/compare/shader_side.h"
#include "painting/color_range.h"
#include "panes/shader/shader_gl.h"
#include "workspace/snapshot.h"

namespace reliefui {

enum class ShaderMeasure : std::uint8_t { Colors, Hits };
inline constexpr std::size_t kShaderMeasures = 2;

// problem: why there is no picture of the shader; all members below are then empty.
// shader, cpu: colours, encoded as ColorMap::Picture has them. seconds: median time of a frame; spread: half the range
// of the frames' times, relative to the median; frames: number of them. spreads: of the differences, by the measure.
struct ShaderPreview {
    std::shared_ptr<const Snapshot> snapshot;
    std::optional<relief::Message> problem;
    std::string renderer;
    std::vector<relief::Message> notes;  // see relief::ShaderRequest
    std::shared_ptr<const relief::FloatImage> shader, cpu;
    std::shared_ptr<const relief::FloatImage> colors, hits;  // see relief::ShaderDifferences
    std::array<std::shared_ptr<const ValueSpread>, kShaderMeasures> spreads;
    relief::ShaderDifferences found;  // its numbers; the pictures are above
    double seconds = 0;
    double spread = 0;
    int frames = 0;

    const std::shared_ptr<const relief::FloatImage>& differences(ShaderMeasure measure) const {
        return measure == ShaderMeasure::Colors ? colors : hits;
    }
    std::optional<relief::PixelChoice> worst(ShaderMeasure measure) const {
        return measure == ShaderMeasure::Colors ? found.worstColor : found.worstHit;
    }
};

// Opens OpenGL on the calling thread; null, with the reason, if there is none.
using ShaderGlSource = std::function<std::unique_ptr<ShaderGl>(EglProblem&)>;
std::unique_ptr<ShaderGl> openShaderGl(EglProblem& problem);

// Draws and compares. snapshot: with a full frame. May be called on any thread; takes a second, with progress. Throws
// Cancelled; what OpenGL or the maps refuse becomes the preview's problem.
std::shared_ptr<const ShaderPreview> shaderPreview(std::shared_ptr<const Snapshot> snapshot, const ShaderGlSource& open,
                                                   relief::Work& work);

}  // namespace reliefui
