#include "panes/pyramid/pyramid_state.h"

#include "workspace/pane_store.h"

namespace reliefui {

void PyramidPane::read(relief::JsonReader reader) {
    reader.named("levels", [&](const std::string& name) {
        levels = name;
        check({});
    });
    reader.read("stacked", stacked);
    reader.read("near-ray", nearRay);
    reader.read("follow", follow);
    reader.finish();
}

void PyramidPane::check(const std::string&) const {
    checkName("levels", levels, {"max", "mean", "min", "all"});
}

relief::Json PyramidPane::json() const {
    return {{"levels", levels}, {"stacked", stacked}, {"near-ray", nearRay}, {"follow", follow}};
}

}  // namespace reliefui
