// The point of the slab whose Euclidean and refined distances the distance map and the profile show.
#pragma once

#include <optional>

#include "workspace/state_json.h"

namespace reliefui {

// s, t in texels; height from 0 to 1. If the picture repeats, s and t may lie in any of its copies.
struct QueryPoint {
    double s = 0;
    double t = 0;
    double z = 0;
    bool operator==(const QueryPoint&) const = default;
};

struct PointState {
    static constexpr const char* kName = "query";
    std::optional<QueryPoint> point;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const PointState&) const = default;
};

}  // namespace reliefui
