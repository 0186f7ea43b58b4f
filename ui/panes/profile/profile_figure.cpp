#include "panes/profile/profile_figure.h"

#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/point_asker.h"

namespace reliefui {

ProfileSource profileSource(const Snapshot& s) {
    ProfileSource source;
    source.field = &s.request->field;
    source.maxima = s.maxima;
    source.hasRay = s.trace.onRelief;
    source.ray = s.trace.ray;
    source.hit = s.trace.hit;
    if (!s.trace.hidden) source.exact = s.trace.exact;
    source.steps = &s.trace.steps;
    return source;
}

void takeProfile(ProfileOptions& options, const ProfilePane& pane) {
    options.levels = pane.allLevels ? LevelsShown::All : LevelsShown::Visited;
    options.nearRay = pane.nearRay;
    options.trueAspect = pane.trueAspect;
}

std::shared_ptr<const Figure> profileFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const ProfileOptions& options, const std::optional<QueryPoint>& point) {
    requireRay("profile", *snapshot);
    return computedFigure([snapshot, step, options, point](const FigurePage&, relief::Work& work) {
        ProfileSource source = profileSource(*snapshot);
        source.point = pointOf(*snapshot, point, work);
        const auto paint = [snapshot, source, step, options](QPainter& painter, const Box& page, const Style& style) {
            const double unit = style.pixelsPerPoint();
            const Drawing legend = profileLegend(source, options, page.width() / unit - kFigureMargins, style.language);
            const Box room = figureRoom(legend, page, style);
            const ProfileFrame frame = profileFrame(source, options, room.width() / unit, room.height() / unit);
            const Drawing relief = profileRelief(source, options, frame);
            const Drawing marks = profileMarks(source, options, frame, step);
            const Drawing axes = profileAxes(source, frame);
            paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
        };
        return paintedFigure(paint, figureCaption(snapshot, step));
    });
}

}  // namespace reliefui
