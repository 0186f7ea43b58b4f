#include "views/figure_parts.h"

#include <algorithm>

#include "drawings/qpainter_painter.h"
#include "views/compare_painting.h"
#include "views/drawn_view.h"
#include "views/duel_data.h"
#include "views/table_figures.h"

namespace reliefui {

using relief::MessageId;

namespace {

constexpr double kMmPerPoint = 25.4 / 72;
constexpr double kMargins = 12;  // points, of a figure

TableSource tableOf(const Snapshot& snapshot, const FigureRequest& request) {
    return request.view == "steps" ? stepTable(snapshot, request.style.language)
                                   : skippedTable(snapshot, request.style.language);
}

}  // namespace

// Nothing to draw: says so.
Drawing emptyDrawing(MessageId why) {
    Drawing drawing;
    drawing.bounds = {0, 0, 300, 100};
    Label label;
    label.at = drawing.bounds.center();
    label.text = relief::Message(why);
    label.anchor = Anchor::Center;
    drawing.add({}, Role::Label, std::move(label));
    return drawing;
}

// Pictures in two columns where there are more than three, with their numbers.
double compareAspect(const ComparedView& view, relief::CompareMode mode) {
    const double picture = static_cast<double>(view.scenario.height) / view.scenario.width;
    const std::size_t count = view.methods.size();
    constexpr double kText = 0.12;
    const bool beside = mode == relief::CompareMode::Tiles || mode == relief::CompareMode::Difference;
    if (!beside) return picture + kText;
    const double columns = count == 4 ? 2 : static_cast<double>(count);
    return picture * (count == 4 ? 2 : 1) / columns + kText;
}

double tableAspect(const Snapshot& snapshot, const FigureRequest& request) {
    const double points = request.widthMm / kMmPerPoint - kMargins;
    const Drawing table = tableDrawing(tableOf(snapshot, request), points);
    // A table that wants more room is fitted into the page.
    const double height = table.bounds.height() * points / std::max(table.bounds.width(), 1.0);
    return (height + kMargins) / (points + kMargins);
}

void paintComparison(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                     const Style& style) {
    if (!request.compare) {
        const Drawing empty = emptyDrawing(MessageId::DrawCompareOne);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const relief::Comparison& how = snapshot.scenario.comparison;
    const ComparePage parts = comparePage(compareSource(*request.compare, how, request.compareShown), page, style);
    paintCompare(painter, *request.compare, how, parts, page, style, snapshot.scenario.pixel, {});
}

void paintByHand(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style) {
    const DrawnSource source = drawnSource(snapshot);
    if (source.relief.empty()) {
        const Drawing empty = emptyDrawing(MessageId::DrawDrawnNone);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    paintDrawn(painter, source, page, style);
}

void paintDuel(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
               const Style& style) {
    if (!request.duel) {
        const bool pixel = snapshot.scenario.pixel.has_value();
        const Drawing empty = emptyDrawing(pixel ? MessageId::DrawNoRelief : MessageId::DrawDuelNoRay);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const Duel& duel = *request.duel;
    const DuelSource source = duel.source();
    const double unit = style.pixelsPerPoint();
    const Drawing legend = duelLegend(source, page.width() / unit - kMargins, style.language);
    const Box room = figureRoom(legend, page, style);
    ProfileOptions options = request.profile;
    options.levels = LevelsShown::None;
    const ProfileFrame frame = duelFrame(source, options, room.width() / unit, room.height() / unit);
    const Drawing relief = profileRelief(source.profile, options, frame);
    const Drawing axes = profileAxes(source.profile, frame);
    const auto& moments = duel.steps.moments;
    const std::size_t at = std::min(request.duelMoment, moments.empty() ? 0 : moments.size() - 1);
    const Drawing marks = duelMarks(source, frame, moments.empty() ? std::vector<std::size_t>{} : moments[at]);
    paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
}

void paintTable(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                const Style& style) {
    const double points = page.width() / style.pixelsPerPoint() - kMargins;
    const Drawing table = tableDrawing(tableOf(snapshot, request), points);
    paintFigure(painter, {&table}, {}, page, style);
}

}  // namespace reliefui
