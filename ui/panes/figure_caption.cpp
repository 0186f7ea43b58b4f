#include "panes/figure_caption.h"

#include <algorithm>
#include <filesystem>

#include "measuring/bench/measured_method.h"
#include "scenario/variation.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

// File name with its folder, because all shipped pictures are called height.png.
std::string heightsOf(const relief::Pictures& pictures) {
    const std::string name = relief::heightsName(pictures);
    if (pictures.height.empty() || !pictures.drawn.empty()) return name;
    const std::filesystem::path path(name);
    return (path.parent_path().filename() / path.filename()).string();
}

// The filter with its settings, also those that are no options of the filter.
std::string filterOf(const relief::Scenario& scenario) {
    constexpr auto kFilter = relief::CompareSubject::Filters;
    return relief::variationText(kFilter, relief::ownVariation(scenario, kFilter));
}

}  // namespace

void requireRay(const char* figure, const Snapshot& snapshot) {
    if (snapshot.trace.onRelief) return;
    throw EmptyFigure(figure, snapshot.scenario.pixel ? MessageId::ExportNoRelief : MessageId::ExportNoPixel);
}

FigureCaption figureCaption(std::shared_ptr<const Snapshot> snapshot, std::optional<int> step,
                            const std::string& methods, const std::string& filters) {
    return [snapshot = std::move(snapshot), step, methods, filters](relief::Language language) {
        const relief::Scenario& s = snapshot->scenario;
        const auto say = [&](const Message& message) { return relief::sentence(message, language); };
        const PixelTrace& trace = snapshot->trace;
        const relief::Message heights(MessageId::CaptionHeights,
                                      {{"heights", heightsOf(s.pictures)},
                                       {"depth", relief::numberText(s.reliefDepth, 3)},
                                       {"surface", std::string(relief::surfaceName(s.surface))}});
        std::string text = say(heights);
        // For a ray of another program's tracer, the scenario's method and view do not apply.
        if (trace.fromFile) {
            const std::string file = std::filesystem::path(s.other.steps).filename().string();
            text += " · " + say(Message(MessageId::CaptionOtherRay, {{"ray", s.other.ray}, {"file", file}}));
        } else {
            text += " · " + (methods.empty() ? relief::methodText(s.method) : methods) + " · " +
                    say(Message(MessageId::CaptionFilter, {{"filter", filters.empty() ? filterOf(s) : filters}}));
            if (s.mapping != "direct") text += " · " + s.mapping;
            if (s.camera.kind == relief::Camera::Kind::Orbit) {
                text += " · " + say(Message(MessageId::CaptionElevation,
                                            {{"elevation", relief::numberText(s.camera.elevation, 3)}}));
            }
            if (s.pixel) {
                text += " · " +
                        say(Message(MessageId::CaptionPixel,
                                    {{"x", s.pixel->x}, {"y", s.pixel->y}, {"width", s.width}, {"height", s.height}}));
            }
        }
        if (step && !trace.steps.empty() && !trace.hidden) {
            const int steps = static_cast<int>(trace.steps.size());
            text += " · " + say(Message(MessageId::CaptionStep,
                                        {{"step", std::clamp(*step, 0, steps - 1) + 1}, {"steps", steps}}));
        }
        return text;
    };
}

FigureCaption redrawnCaption(FigureCaption caption) {
    return [caption = std::move(caption)](relief::Language language) {
        return caption(language) + " · " + relief::sentence(Message(MessageId::CaptionRedrawn), language);
    };
}

}  // namespace reliefui
