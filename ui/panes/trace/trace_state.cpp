#include "panes/trace/trace_state.h"

#include "panes/step_colors.h"
#include "workspace/pane_store.h"

namespace reliefui {

void TracePane::read(relief::JsonReader reader) {
    reader.named("colors", [&](const std::string& name) {
        checkName("colors", name, tracePaneColors());
        colors = name;
    });
    reader.read("heights", heights);
    reader.read("follow", follow);
    reader.finish();
}

void TracePane::check(const std::string& subject) const {
    constexpr double kLeastHeights = 0.25;
    constexpr double kMostHeights = 4;
    checkName("colors", colors, tracePaneColors());
    checkWithin(subject, "heights", heights, kLeastHeights, kMostHeights);
}

relief::Json TracePane::json() const {
    return {{"colors", colors}, {"heights", heights}, {"follow", follow}};
}

}  // namespace reliefui
