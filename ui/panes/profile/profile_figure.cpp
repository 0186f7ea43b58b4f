#include "panes/profile/profile_figure.h"

#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/point_finder.h"

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
    source.further = &s.trace.further;
    return source;
}

void takeProfile(ProfileOptions& options, const ProfilePane& pane) {
    options.levels = pane.allLevels ? LevelsShown::All : LevelsShown::Visited;
    options.nearRay = pane.nearRay;
    options.trueAspect = pane.trueAspect;
}

std::shared_ptr<const Figure> profileFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const ProfileOptions& options, const std::optional<QueryPoint>& point,
                                            const std::vector<Annotation>& notes) {
    requireRay("profile", *snapshot);
    return computedFigure([snapshot, step, options, point, notes](const FigurePage&, relief::Work& work) {
        ProfileSource source = profileSource(*snapshot);
        source.point = pointOf(*snapshot, point, work);
        const auto legend = [source, options](double width, relief::Language language) {
            return profileLegend(source, options, width, language);
        };
        const auto layers = [snapshot, source, options, step, notes](double width, double height, const Style& style) {
            const ProfileFrame frame = profileFrame(source, options, width, height);
            // The step's name ends at the plot's right side, the title's room at the page's.
            const double reserved = kStepTitle + frame.whole.x1 - frame.plot.x1;
            return std::vector{profileRelief(source, options, frame), profileAxes(source, frame, reserved),
                               profileMarks(source, options, frame, step),
                               annotationDrawing(notes, profileAnnotations(frame), style.language)};
        };
        return chartFigure({legend, layers}, figureCaption(snapshot, step));
    });
}

AnnotationFrame profileAnnotations(const ProfileFrame& frame) {
    const double run = frame.vertical ? 1 : frame.run;
    return {"profile", [frame, run](Point p) { return frame.at(p.x / run, p.y); },
            [frame, run](Point p) {
                return Point{frame.lambdaAt(p.x) * run, frame.heightAt(p.y)};
            },
            frame.seen(), 1 / frame.zoom};
}

}  // namespace reliefui
