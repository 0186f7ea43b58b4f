#include "panes/footprint/footprint_state.h"

#include "workspace/pane_store.h"

namespace reliefui {

void FootprintPane::read(relief::JsonReader reader) {
    reader.readWhole("neighbours", neighbours);
    reader.read("weights", weights);
    reader.finish();
}

void FootprintPane::check(const std::string&) const {
    checkName("neighbours", std::to_string(neighbours), {"0", "4", "8"});
}

relief::Json FootprintPane::json() const {
    return {{"neighbours", neighbours}, {"weights", weights}};
}

}  // namespace reliefui
