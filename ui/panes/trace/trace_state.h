// The user's choices in the 3-D trace pane.
#pragma once

#include "workspace/state_json.h"

namespace reliefui {

struct TracePane {
    static constexpr const char* kName = "trace";
    std::string colors = "decision";  // of tracePaneColors()
    double heights = 1;               // exaggeration of the heights, 0.25 to 4
    bool follow = false;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const TracePane&) const = default;
};

}  // namespace reliefui
