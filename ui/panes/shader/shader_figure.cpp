#include "panes/shader/shader_figure.h"

#include "panes/figure_caption.h"
#include "panes/shader/shader_state.h"
#include "workspace/range_json.h"

namespace reliefui {

std::shared_ptr<const Figure> shaderFigure(ShaderSource source) {
    source.timed = false;
    source.before = false;
    const auto shared = std::make_shared<const ShaderSource>(std::move(source));
    ChartMaker maker;
    maker.legend = [shared](double width, relief::Language language) { return shaderLegend(*shared, width, language); };
    maker.layers = [shared](double width, double height, const Style& style) {
        return std::vector{shaderPicture(*shared, width, height, style.language).drawing};
    };
    maker.leastRoom = 0.3;
    return chartFigure(std::move(maker), figureCaption(shared->preview->snapshot));
}

std::shared_ptr<const Figure> drawnShader(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario& scenario) {
    if (!snapshot->request || !snapshot->frame) throw EmptyFigure("shader", relief::MessageId::DrawNoPicture);
    relief::Work work;
    ShaderSource source;
    source.preview = shaderPreview(std::move(snapshot), openShaderGl, work);
    if (source.preview->problem) throw relief::InputError("--export shader", *source.preview->problem);
    source.measure = stateOf<ShaderPane>(scenario).measure;
    source.range = rangesOf(scenario).of(shaderRangeOf(source.measure));
    source.pixel = scenario.pixel;
    return shaderFigure(std::move(source));
}

}  // namespace reliefui
