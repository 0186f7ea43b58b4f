// The user's choices in the pyramid pane.
#pragma once

#include "workspace/state_json.h"

namespace reliefui {

struct PyramidPane {
    static constexpr const char* kName = "pyramid";
    std::string levels = "max";  // "max", "mean", "min", "all"
    bool stacked = false;        // show the levels above each other as slabs
    bool nearRay = true;
    bool follow = false;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const PyramidPane&) const = default;
};

}  // namespace reliefui
