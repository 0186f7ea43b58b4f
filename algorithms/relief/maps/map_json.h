// What the JSON descriptions of stored maps and of maps for engines share. For map_files.cpp and engine_json.cpp.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "images/system_error.h"
#include "relief/errors.h"

namespace relief {

// Throws InputError(path, MapDamaged). why: may have several lines.
[[noreturn]] inline void refuseDamaged(const std::string& path, const std::string& why) {
    throw InputError(path, Message(MessageId::MapDamaged, {{"why", oneLine(why)}}));
}

// A number, or "infinite", since JSON has no infinity. numberOf() throws nlohmann::json::exception for anything else.
inline nlohmann::ordered_json numberJson(double value) {
    return std::isinf(value) ? nlohmann::ordered_json("infinite") : nlohmann::ordered_json(value);
}
inline double numberOf(const nlohmann::ordered_json& json) {
    return json == nlohmann::ordered_json("infinite") ? std::numeric_limits<double>::infinity() : json.get<double>();
}

// Returns the kind of this name among the first `count` values of Kind; std::nullopt for any other.
template <class Kind, class Name>
std::optional<Kind> kindOf(const std::string& text, int count, const Name& name) {
    for (int k = 0; k < count; ++k) {
        if (name(static_cast<Kind>(k)) == text) return static_cast<Kind>(k);
    }
    return std::nullopt;
}

}  // namespace relief
