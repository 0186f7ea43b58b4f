#include "json_line.h"

namespace relief::app {

std::string asciiLine(const Json& json) {
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Json readBack(const Json& json) {
    return Json::parse(asciiLine(json));
}

const Json* member(const Json& json, const char* name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

std::int64_t numberIn(const Json& json, const char* name, std::int64_t otherwise) {
    const Json* const found = member(json, name);
    return found != nullptr && found->is_number_integer() ? found->get<std::int64_t>() : otherwise;
}

std::string textIn(const Json& json, const char* name) {
    const Json* const found = member(json, name);
    return found != nullptr && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace relief::app
