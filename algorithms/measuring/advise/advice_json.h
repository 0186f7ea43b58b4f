// What all advice as JSON begins with: what was asked about.
#pragma once

#include <nlohmann/json.hpp>

#include "measuring/advise/recommend.h"

namespace relief {

// name: of the height map.
inline nlohmann::ordered_json adviceSubject(const std::string& name, const HeightField& field,
                                            const std::vector<Elevation>& views) {
    return {{"height", name},
            {"size", std::to_string(field.width()) + "x" + std::to_string(field.height())},
            {"surface", std::string(surfaceName(field.surface()))},
            {"address", std::string(addressName(field.address()))},
            {"relief_depth", field.reliefDepth()},
            {"views", viewsText(views)}};
}

}  // namespace relief
