// The user's choices in the charts pane.
#pragma once

#include <string>
#include <vector>

#include "workspace/state_json.h"

namespace reliefui {

struct ChartsPane {
    static constexpr const char* kName = "charts";
    std::string shown = "all";   // of chartsPaneShown()
    std::string error = "mean";  // as of ErrorMeasure
    bool live = true;
    bool maps = false;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const ChartsPane&) const = default;
};

const std::vector<std::string>& chartsPaneShown();

}  // namespace reliefui
