// The user's choices in the profile pane.
#pragma once

#include "workspace/state_json.h"

namespace reliefui {

struct ProfilePane {
    static constexpr const char* kName = "profile";
    bool allLevels = false;
    bool nearRay = true;
    bool trueAspect = false;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const ProfilePane&) const = default;
};

}  // namespace reliefui
