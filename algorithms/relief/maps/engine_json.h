// The conventions of an engine's map as JSON: the sidecar, and the metadata of the pictures. For engine_map.cpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "relief/maps/engine_map.h"

namespace relief {

inline constexpr const char* kEngineFormat = "reliefscope engine map";

// The contents of a sidecar: the conventions, and the pictures with their sizes, level 0 first.
struct EngineSidecar {
    EngineConventions conventions;
    std::vector<std::string> files;  // in the sidecar's folder
    std::vector<std::pair<int, int>> sizes;
};

nlohmann::ordered_json engineJson(const EngineSidecar& sidecar);
// Throws InputError naming `path`.
EngineSidecar parseEngineJson(const std::string& text, const std::string& path);

}  // namespace relief
