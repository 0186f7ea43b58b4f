#include "panes/profile/profile_state.h"

#include "workspace/pane_store.h"

namespace reliefui {

void ProfilePane::read(relief::JsonReader reader) {
    reader.read("all-levels", allLevels);
    reader.read("near-ray", nearRay);
    reader.read("true-aspect", trueAspect);
    reader.finish();
}

void ProfilePane::check(const std::string&) const {}

relief::Json ProfilePane::json() const {
    return {{"all-levels", allLevels}, {"near-ray", nearRay}, {"true-aspect", trueAspect}};
}

}  // namespace reliefui
