// The user's choices in the footprint pane.
#pragma once

#include "workspace/state_json.h"

namespace reliefui {

struct FootprintPane {
    static constexpr const char* kName = "footprint";
    int neighbours = 0;   // 0, 4 or 8
    bool weights = true;  // show the weight function and its map

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const FootprintPane&) const = default;
};

}  // namespace reliefui
