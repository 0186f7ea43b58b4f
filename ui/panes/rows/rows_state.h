// What is chosen in the pane of rows.
#pragma once

#include <string>
#include <vector>

#include "workspace/state_json.h"

namespace reliefui {

inline constexpr std::size_t kMostRowVariants = 4;  // what can be told apart

struct RowsPane {
    static constexpr const char* kName = "rows";
    // As `relief bench rows` spells them.
    std::vector<std::string> variants{"affine", "direct", "incremental:anchor=0", "streams:streams=4"};
    int pixels = 0;  // of the row, up to kWidestRow; 0: the picture's
    bool inDouble = false;
    bool logarithmic = true;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const RowsPane&) const = default;
};

}  // namespace reliefui
