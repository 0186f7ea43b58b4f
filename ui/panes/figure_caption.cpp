#include "panes/figure_caption.h"

#include <filesystem>

#include "measuring/bench/measured_method.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

// The file and its folder: every shipped picture is a height.png.
std::string heightsOf(const relief::Pictures& pictures) {
    const std::string name = relief::heightsName(pictures);
    if (pictures.height.empty() || !pictures.drawn.empty()) return name;
    const std::filesystem::path path(name);
    return (path.parent_path().filename() / path.filename()).string();
}

}  // namespace

void requireRay(const char* figure, const Snapshot& snapshot) {
    if (snapshot.trace.onRelief) return;
    emptyFigure(figure, snapshot.scenario.pixel ? MessageId::ExportNoRelief : MessageId::ExportNoPixel);
}

FigureCaption figureCaption(std::shared_ptr<const Snapshot> snapshot, std::optional<int> step,
                            const std::string& methods, const std::string& filters) {
    return [snapshot = std::move(snapshot), step, methods, filters](relief::Language language) {
        const relief::Scenario& s = snapshot->scenario;
        const auto say = [&](const Message& message) { return relief::sentence(message, language); };
        std::string text = say(
            Message(MessageId::CaptionView, {{"heights", heightsOf(s.pictures)},
                                             {"depth", relief::numberText(s.reliefDepth, 3)},
                                             {"surface", std::string(relief::surfaceName(s.surface))},
                                             {"method", methods.empty() ? relief::methodText(s.method) : methods},
                                             {"filter", filters.empty() ? relief::filterText(s.filter) : filters}}));
        if (s.camera.kind == relief::Camera::Kind::Orbit) {
            text += " · " + say(Message(MessageId::CaptionElevation,
                                        {{"elevation", relief::numberText(s.camera.elevation, 3)}}));
        }
        const PixelTrace& trace = snapshot->trace;
        if (trace.fromFile) {
            text += " · " + say(Message(MessageId::CaptionOtherRay, {{"ray", s.other.ray + 1}}));
        } else if (s.pixel) {
            text +=
                " · " + say(Message(MessageId::CaptionPixel,
                                    {{"x", s.pixel->x}, {"y", s.pixel->y}, {"width", s.width}, {"height", s.height}}));
        }
        if (step && !trace.steps.empty() && !trace.hidden) {
            text += " · " + say(Message(MessageId::CaptionStep,
                                        {{"step", *step + 1}, {"steps", static_cast<int>(trace.steps.size())}}));
        }
        return text;
    };
}

}  // namespace reliefui
