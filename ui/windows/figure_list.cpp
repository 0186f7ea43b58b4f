#include "windows/figure_list.h"

#include <algorithm>

#include "panes/charts/charts_figure.h"
#include "panes/compare/compare_figure.h"
#include "panes/distance/distance_figure.h"
#include "panes/drawn/drawn_figure.h"
#include "panes/duel/duel_figure.h"
#include "panes/footprint/footprint_figure.h"
#include "panes/profile/profile_figure.h"
#include "panes/pyramid/pyramid_figure.h"
#include "panes/result/result_figure.h"
#include "panes/rows/rows_figure.h"
#include "panes/skipped/skipped_figure.h"
#include "panes/steps/steps_figure.h"
#include "panes/trace/trace_figure.h"
#include "relief/errors.h"

namespace reliefui {

namespace {

using Shown = std::shared_ptr<const Snapshot>;

// Of panes without a state that figures show.
template <std::shared_ptr<const Figure> (*make)(Shown)>
std::shared_ptr<const Figure> plain(Shown snapshot, const PaneStates&) {
    return make(std::move(snapshot));
}

std::shared_ptr<const Figure> profileOf(Shown snapshot, const PaneStates& panes) {
    ProfileOptions options;
    takeProfile(options, panes.profile);
    return profileFigure(std::move(snapshot), options, panes.query);
}

}  // namespace

const std::vector<FigureKind>& figureList() {
    static const std::vector<FigureKind> kList{
        {"charts", true, [](Shown s, const PaneStates& p) { return measuredCharts(*s, p.charts.error); }},
        {"compare", true, plain<measuredComparison>},
        {"distance", true,
         [](Shown s, const PaneStates& p) {
             return distanceFigure(std::move(s), distanceOptions(p.distance), p.query);
         }},
        {"drawn", true, plain<drawnFigure>},
        {"duel", true, plain<foughtDuel>},
        {"footprint", true,
         [](Shown s, const PaneStates& p) {
             FootprintOptions options;
             options.neighbours = p.footprint.neighbours;
             return footprintFigure(std::move(s), options);
         }},
        {"pareto", true, {}},
        {"profile", true, profileOf},
        {"pyramid", true,
         [](Shown s, const PaneStates& p) { return pyramidFigure(std::move(s), pyramidOptions(p.pyramid)); }},
        {"result", true, plain<resultFigure>},
        {"rows", true, [](Shown s, const PaneStates& p) { return rowsFigure(std::move(s), rowsOptions(p.rows), {}); }},
        {"skipped", true, plain<skippedFigure>},
        {"slabs", false,
         [](Shown s, const PaneStates& p) { return slabsFigure(std::move(s), pyramidOptions(p.pyramid), {}); }},
        {"steps", true, plain<stepsFigure>},
        {"trace", false,
         [](Shown s, const PaneStates& p) {
             return traceFigure(std::move(s), {p.trace.heights, stepColors(p.trace.colors), {}});
         }},
    };
    return kList;
}

const FigureKind& figureKind(const std::string& name) {
    const auto& list = figureList();
    const auto at = std::find_if(list.begin(), list.end(), [&](const FigureKind& kind) { return kind.name == name; });
    if (at != list.end()) return *at;
    std::vector<std::string> names;
    for (const FigureKind& kind : list) names.push_back(kind.name);
    throw relief::InputError("--export",
                             relief::Message(relief::MessageId::UnknownName,
                                             {{"what", "view"}, {"name", name}, {"known", relief::commaList(names)}}));
}

}  // namespace reliefui
