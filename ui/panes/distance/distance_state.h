// The user's choices in the distance pane.
#pragma once

#include <optional>

#include "workspace/state_json.h"

namespace reliefui {

struct DistancePane {
    static constexpr const char* kName = "distance";
    std::string map;            // one of mapKinds(); empty: the method's own
    std::string minus;          // kind of the map to subtract; empty: none
    std::string axis;           // "x", "y", "z"; empty: as the ray runs
    std::optional<int> slice;   // zero-based; default: the slice at the step
    std::optional<int> sector;  // zero-based; default: the ray's
    bool lines = true;
    bool nearRay = true;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const DistancePane&) const = default;
};

}  // namespace reliefui
