#include "panes/shader/shader_state.h"

#include <vector>

namespace reliefui {

namespace {

const std::vector<std::string>& measureNames() {
    static const std::vector<std::string> names{"colors", "hits"};
    return names;
}

}  // namespace

void ShaderPane::read(relief::JsonReader reader) {
    reader.named("measure", [&](const std::string& name) {
        checkName("shader", name, measureNames());
        measure = name == measureNames().front() ? ShaderMeasure::Colors : ShaderMeasure::Hits;
    });
    reader.finish();
}

relief::Json ShaderPane::json() const {
    return {{"measure", measureNames()[static_cast<std::size_t>(measure)]}};
}

}  // namespace reliefui
