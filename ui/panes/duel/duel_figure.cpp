#include "panes/duel/duel_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> duelFigure(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const Duel> duel,
                                         const ProfileOptions& options, std::size_t moment, double upTo) {
    std::string methods;
    for (const relief::DuelRun& run : duel->runs) methods += (methods.empty() ? "" : ", ") + run.name;
    const auto sourceOf = [snapshot, duel = std::move(duel), upTo] {
        DuelSource source = duel->source();
        source.upTo = upTo;
        return std::pair(source, duel);
    };
    const auto legend = [sourceOf](double width, relief::Language language) {
        return duelLegend(sourceOf().first, width, language);
    };
    const auto layers = [sourceOf, options, moment](double width, double height, const Style&) {
        ProfileOptions shown = options;
        shown.levels = LevelsShown::None;
        const auto [source, duel] = sourceOf();
        const ProfileFrame frame = duelFrame(source, shown, width, height);
        const auto& moments = duel->steps.moments;
        const std::vector<std::size_t> now =
            moments.empty() ? std::vector<std::size_t>{} : moments[std::min(moment, moments.size() - 1)];
        return std::vector{profileRelief(source.profile, shown, frame), profileAxes(source.profile, frame, 0),
                           duelMarks(source, frame, now)};
    };
    return chartFigure({legend, layers, kFigureAspect, 0.5}, figureCaption(snapshot, {}, methods));
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
