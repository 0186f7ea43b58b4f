// The user's choices in the rows pane.
#pragma once

#include <string>
#include <vector>

#include "workspace/state_json.h"

namespace reliefui {

inline constexpr std::size_t kMostRowVariants = 4;  // more could not be distinguished

struct RowsPane {
    static constexpr const char* kName = "rows";
    // Descriptions as for `relief bench rows`.
    std::vector<std::string> variants{"affine", "direct", "incremental:anchor=0", "streams:streams=4"};
    int pixels = 0;  // of the row, up to kWidestRow; 0: the picture's width
    bool inDouble = false;
    bool logarithmic = true;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const RowsPane&) const = default;
};

}  // namespace reliefui
