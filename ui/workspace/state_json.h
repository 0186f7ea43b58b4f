// Forward declarations for headers of panes' states that declare how they are read and written; see
// workspace/pane_store.h.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace relief {

using Json = nlohmann::ordered_json;
class JsonReader;

}  // namespace relief
