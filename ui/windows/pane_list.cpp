#include "windows/pane_list.h"

#include <algorithm>

#include "panes/charts/charts_pane.h"
#include "panes/compare/compare_pane.h"
#include "panes/distance/distance_pane.h"
#include "panes/doctor/doctor_pane.h"
#include "panes/drawn/drawn_pane.h"
#include "panes/duel/duel_pane.h"
#include "panes/footprint/footprint_pane.h"
#include "panes/formula/formula_pane.h"
#include "panes/profile/profile_pane.h"
#include "panes/pyramid/pyramid_pane.h"
#include "panes/result/result_pane.h"
#include "panes/rows/rows_pane.h"
#include "panes/shader/shader_pane.h"
#include "panes/skipped/skipped_pane.h"
#include "panes/trace/trace_pane.h"
#include "panes/watch/watch_pane.h"
#include "panes/why/why_pane.h"
#include "relief/errors.h"
#include "windows/scene_panel.h"
#include "windows/time_pane.h"
#include "workspace/annotation_state.h"
#include "workspace/range_json.h"

namespace reliefui {

std::vector<PaneKind> paneList() {
    return {
        resultPane(),     //
        tracePane(),      //
        pyramidPane(),    //
        timePane(),       //
        scenePane(),      //
        profilePane(),    //
        distancePane(),   //
        footprintPane(),  //
        rowsPane(),       //
        chartsPane(),     //
        comparePane(),    //
        drawnPane(),      //
        duelPane(),       //
        skippedPane(),    //
        formulaPane(),    //
        watchPane(),      //
        whyPane(),        //
        shaderPane(),     //
        doctorPane(),     //
    };
}

StateReaders stateReaders() {
    StateReaders readers{readerOf<RangesState>(), readerOf<AnnotationState>()};
    for (const PaneKind& pane : paneList()) readers.insert(pane.states.begin(), pane.states.end());
    return readers;
}

std::vector<FigureKind> figureList() {
    std::vector<FigureKind> list;
    for (const PaneKind& pane : paneList()) list.insert(list.end(), pane.figures.begin(), pane.figures.end());
    std::sort(list.begin(), list.end(), [](const FigureKind& a, const FigureKind& b) { return a.name < b.name; });
    return list;
}

FigureKind figureKind(const std::string& name) {
    const auto list = figureList();
    const auto at = std::find_if(list.begin(), list.end(), [&](const FigureKind& kind) { return kind.name == name; });
    if (at != list.end()) return *at;
    std::vector<std::string> names;
    for (const FigureKind& kind : list) names.push_back(kind.name);
    throw relief::InputError(
        "--export", relief::unknownName({"what", relief::MessageId::WordView}, name, relief::commaList(names)));
}

}  // namespace reliefui
