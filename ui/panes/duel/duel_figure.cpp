#include "panes/duel/duel_figure.h"

#include <algorithm>

#include "painting/painter.h"

namespace reliefui {

namespace {

struct DuelFigure : Figure {
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const Duel> duel;
    ProfileOptions options;
    std::size_t moment = 0;
    double upTo = 0;

    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        using relief::MessageId;
        if (!duel) {
            return paintEmpty(painter, snapshot->scenario.pixel ? MessageId::DrawNoRelief : MessageId::DrawDuelNoRay,
                              page, style);
        }
        DuelSource source = duel->source();
        source.upTo = upTo;
        const double unit = style.pixelsPerPoint();
        const Drawing legend = duelLegend(source, page.width() / unit - kFigureMargins, style.language);
        const Box room = figureRoom(legend, page, style);
        const ProfileFrame frame = duelFrame(source, options, room.width() / unit, room.height() / unit);
        const Drawing relief = profileRelief(source.profile, options, frame);
        const Drawing axes = profileAxes(source.profile, frame);
        const auto& moments = duel->steps.moments;
        const std::size_t at = std::min(moment, moments.empty() ? 0 : moments.size() - 1);
        const Drawing marks = duelMarks(source, frame, moments.empty() ? std::vector<std::size_t>{} : moments[at]);
        paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
    }
};

}  // namespace

std::shared_ptr<const Figure> duelFigure(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const Duel> duel,
                                         const ProfileOptions& options, std::size_t moment, double upTo) {
    auto figure = std::make_shared<DuelFigure>();
    figure->snapshot = std::move(snapshot);
    figure->duel = std::move(duel);
    figure->options = options;
    figure->options.levels = LevelsShown::None;
    figure->moment = moment;
    figure->upTo = upTo;
    return figure;
}

std::shared_ptr<const Figure> computedDuel(std::shared_ptr<const Snapshot> snapshot) {
    ProfileOptions options;
    options.nearRay = true;
    if (!snapshot->trace.onRelief) return duelFigure(std::move(snapshot), nullptr, options, 0, 0);
    relief::Work work;
    const auto duel = makeDuel(snapshot, snapshot->scenario.comparison.others, work);
    const std::size_t own = snapshot->trace.fromFile ? duel->runs.size() - 1 : 0;
    const std::size_t moment =
        duel->steps.momentOf(own, static_cast<std::size_t>(std::max(snapshot->scenario.step, 0)));
    const double upTo = moment == duel->firstMoment() ? duel->closeUp() : 0;
    return duelFigure(std::move(snapshot), duel, options, moment, upTo);
}

}  // namespace reliefui
