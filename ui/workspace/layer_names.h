// Names of the layers in files and on the command line: those of relief::layerNames().
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "workspace/layers.h"

namespace reliefui {

// In the order of Layer.
inline constexpr std::array<std::string_view, kLayers> kLayerNames{"color",  "steps", "error",     "outcome", "depth",
                                                                   "normal", "uv",    "footprint", "hidden"};
// Returns std::nullopt if no layer has this name.
inline std::optional<Layer> layerNamed(const std::string& name) {
    for (std::size_t n = 0; n < kLayerNames.size(); ++n) {
        if (kLayerNames[n] == name) return static_cast<Layer>(n);
    }
    return std::nullopt;
}

}  // namespace reliefui
