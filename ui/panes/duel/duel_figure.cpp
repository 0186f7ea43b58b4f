#include "panes/duel/duel_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> duelFigure(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const Duel> duel,
                                         const ProfileOptions& options, std::size_t moment, double upTo) {
    std::string methods;
    for (const relief::DuelRun& run : duel->runs) methods += (methods.empty() ? "" : ", ") + run.name;
    return paintedFigure(
        [snapshot, duel = std::move(duel), options, moment, upTo](QPainter& painter, const Box& page,
                                                                  const Style& style) {
            ProfileOptions shown = options;
            shown.levels = LevelsShown::None;
            DuelSource source = duel->source();
            source.upTo = upTo;
            const double unit = style.pixelsPerPoint();
            const Drawing legend = duelLegend(source, page.width() / unit - kFigureMargins, style.language);
            const Box room = figureRoom(legend, page, style);
            const ProfileFrame frame = duelFrame(source, shown, room.width() / unit, room.height() / unit);
            const Drawing relief = profileRelief(source.profile, shown, frame);
            const Drawing axes = profileAxes(source.profile, frame);
            const auto& moments = duel->steps.moments;
            const std::size_t at = std::min(moment, moments.empty() ? 0 : moments.size() - 1);
            const Drawing marks = duelMarks(source, frame, moments.empty() ? std::vector<std::size_t>{} : moments[at]);
            paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
        },
        figureCaption(snapshot, {}, methods));
}

std::shared_ptr<const Figure> computedDuel(std::shared_ptr<const Snapshot> snapshot) {
    ProfileOptions options;
    options.nearRay = true;
    requireRay("duel", *snapshot);
    relief::Work work;
    const auto duel = makeDuel(snapshot, duelRivals(snapshot->scenario), work);
    const std::size_t own = snapshot->trace.fromFile ? duel->runs.size() - 1 : 0;
    const std::size_t moment =
        duel->steps.momentOf(own, static_cast<std::size_t>(std::max(snapshot->scenario.step, 0)));
    const double upTo = moment == duel->firstMoment() ? duel->closeUp() : 0;
    return duelFigure(std::move(snapshot), duel, options, moment, upTo);
}

}  // namespace reliefui
