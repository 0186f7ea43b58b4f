#include "panes/charts/charts_state.h"

#include "measuring/bench/pareto.h"
#include "workspace/pane_store.h"

namespace reliefui {

const std::vector<std::string>& chartsPaneShown() {
    static const std::vector<std::string> names{"all", "pareto", "histograms"};
    return names;
}

void ChartsPane::read(relief::JsonReader reader) {
    reader.named("shown", [&](const std::string& name) {
        checkName("charts", name, chartsPaneShown());
        shown = name;
    });
    reader.named("error", [&](const std::string& name) {
        relief::parseErrorMeasure(name, "error");
        error = name;
    });
    reader.read("live", live);
    reader.read("maps", maps);
    reader.finish();
}

void ChartsPane::check(const std::string&) const {
    checkName("charts", shown, chartsPaneShown());
    relief::parseErrorMeasure(error, "error");
}

relief::Json ChartsPane::json() const {
    return {{"shown", shown}, {"error", error}, {"live", live}, {"maps", maps}};
}

}  // namespace reliefui
