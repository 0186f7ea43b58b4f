#include "workspace/pane_store.h"

#include <algorithm>

#include "relief/describe.h"
#include "relief/files.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Json;
using relief::JsonReader;
using relief::Message;
using relief::MessageId;

// Sorted by name, so that equal states give equal text.
std::string textOf(const std::map<std::string, Json>& states) {
    Json json = Json::object();
    for (const auto& [name, state] : states) {
        if (!state.empty()) json[name] = state;
    }
    return json.empty() ? std::string() : json.dump();
}

std::string checkedStates(JsonReader reader, const StateReaders& readers, const std::string& subject) {
    std::map<std::string, Json> states;
    for (const auto& [name, read] : readers) {
        if (reader.has(name.c_str())) states[name] = read(reader.child(name.c_str()), subject);
    }
    reader.finish();
    return textOf(states);
}

}  // namespace

void readState(const relief::Scenario& scenario, const char* name, const std::function<void(JsonReader)>& read) {
    if (scenario.ui.empty()) return;
    const std::string file;
    const Json json = relief::parseJson(scenario.ui, file);
    JsonReader all({scenario.ui, file}, json, {});
    if (all.has(name)) read(all.child(name));
}

void keepState(relief::Scenario& scenario, const char* name, const Json& state) {
    std::map<std::string, Json> states;
    if (!scenario.ui.empty()) {
        const Json kept = relief::parseJson(scenario.ui, {});
        for (const auto& [key, value] : kept.items()) states[key] = value;
    }
    states[name] = state;
    scenario.ui = textOf(states);
}

void checkStates(const relief::Scenario& scenario, const StateReaders& readers, const std::string& subject) {
    if (scenario.ui.empty() || readers.empty()) return;
    const Json json = relief::parseJson(scenario.ui, subject);
    checkedStates(JsonReader({scenario.ui, subject}, json, {}), readers, subject);
}

relief::Scenario parseWindowScenario(const std::string& text, const std::string& fileName,
                                     const StateReaders& readers) {
    relief::Scenario scenario = relief::parseScenario(text, fileName);
    if (readers.empty()) return scenario;
    const Json json = relief::parseJson(text, fileName);
    JsonReader reader({text, fileName}, json, {});
    // The same members that parseScenario() selects.
    for (const char* key : {"ui", "panes"}) {
        if (!reader.has(key)) continue;
        scenario.ui = checkedStates(reader.child(key), readers, fileName);
        break;
    }
    return scenario;
}

relief::Scenario loadWindowScenario(const std::string& path, const StateReaders& readers) {
    return parseWindowScenario(relief::readTextFile(path), path, readers);
}

Message withoutLine(const Message& message) {
    const auto why = message.id == MessageId::ScenarioLine ? message.values.back().inner : nullptr;
    return why ? *why : message;
}

void checkName(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    throw InputError("panes", Message(MessageId::UnknownName,
                                      {{"what", what}, {"name", name}, {"known", relief::commaList(known)}}));
}

void checkWithin(const std::string& subject, const std::string& what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(subject, Message(MessageId::OutOfRange,
                                      {{"what", what}, {"value", value}, {"range", relief::rangeOf(low, high)}}));
}

}  // namespace reliefui
