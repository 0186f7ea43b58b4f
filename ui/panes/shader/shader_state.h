// The user's choices in the shader pane.
#pragma once

#include "panes/shader/shader_data.h"
#include "workspace/pane_store.h"

namespace reliefui {

struct ShaderPane {
    static constexpr const char* kName = "shader";
    ShaderMeasure measure = ShaderMeasure::Colors;

    void read(relief::JsonReader reader);
    void check(const std::string&) const {}
    relief::Json json() const;
    bool operator==(const ShaderPane&) const = default;
};

}  // namespace reliefui
