// What is chosen in the pane of distance maps.
#pragma once

#include <optional>

#include "workspace/state_json.h"

namespace reliefui {

struct DistancePane {
    static constexpr const char* kName = "distance";
    std::string map;            // of mapKinds(); empty: the method's own
    std::string minus;          // the map that is taken away; empty: none
    std::string axis;           // "x", "y", "z"; empty: as the ray runs
    std::optional<int> slice;   // from 0; none: the one at the step
    std::optional<int> sector;  // from 0; none: the ray's
    bool lines = true;
    bool nearRay = true;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const DistancePane&) const = default;
};

}  // namespace reliefui
