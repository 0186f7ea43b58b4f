// What is chosen in the footprint's pane.
#pragma once

#include "workspace/state_json.h"

namespace reliefui {

struct FootprintPane {
    static constexpr const char* kName = "footprint";
    int neighbours = 0;   // 0, 4 or 8
    bool weights = true;  // the weight function and its map beside it

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const FootprintPane&) const = default;
};

}  // namespace reliefui
