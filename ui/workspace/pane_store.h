// The user's choices in the panes: one JSON object per pane, by the pane's name, stored in the scenario's object `ui`.
// Only the pane can interpret it, and changing it causes no rendering or tracing. The state of a pane is a struct with
//   static constexpr const char* kName               name in files
//   void read(relief::JsonReader)                    throws relief::InputError with the line of the fault
//   void check(const std::string& subject) const     the same for values out of range
//   relief::Json json() const
// and operator==. A state equal to the default-constructed one is not stored.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scenario/json_reader.h"
#include "scenario/scenario.h"

namespace reliefui {

void readState(const relief::Scenario& scenario, const char* name, const std::function<void(relief::JsonReader)>& read);
// Stores a pane's state; an empty object removes it.
void keepState(relief::Scenario& scenario, const char* name, const relief::Json& state);

template <class State>
State stateOf(const relief::Scenario& scenario) {
    State state;
    readState(scenario, State::kName, [&](relief::JsonReader reader) { state.read(reader); });
    return state;
}
template <class State>
void setState(relief::Scenario& scenario, const State& state) {
    keepState(scenario, State::kName, state == State{} ? relief::Json() : state.json());
}
template <class State>
relief::Scenario withState(relief::Scenario scenario, const State& state) {
    setState(scenario, state);
    return scenario;
}

// Reads a state, checks it, and returns it in the form in which it is stored. subject: the subject of error messages.
using StateReader = std::function<relief::Json(relief::JsonReader reader, const std::string& subject)>;
// The readers by the states' names. An empty map accepts all states unchecked.
struct StateReaders : std::map<std::string, StateReader> {
    using map::map;
};

// Creates the map entry for a type of state.
template <class State>
StateReaders::value_type readerOf() {
    return {State::kName, [](relief::JsonReader reader, const std::string& subject) {
                State state;
                state.read(reader);
                state.check(subject);
                return state == State{} ? relief::Json() : state.json();
            }};
}

// Throws relief::InputError for a state without a reader, and for the first unknown or out-of-range value.
void checkStates(const relief::Scenario& scenario, const StateReaders& readers, const std::string& subject);
// As parseScenario() and loadScenario(), but the panes' states are checked as well; errors in them name the line.
relief::Scenario parseWindowScenario(const std::string& text, const std::string& fileName, const StateReaders& readers);
relief::Scenario loadWindowScenario(const std::string& path, const StateReaders& readers);
// Returns an error's message without the line that it names, for scenarios whose text is not that of a file.
relief::Message withoutLine(const relief::Message& message);

// Helpers for check(): throw relief::InputError that lists the known names, or states the range.
void checkName(const std::string& what, const std::string& name, const std::vector<std::string>& known);
void checkWithin(const std::string& subject, const std::string& what, double value, double low, double high);

}  // namespace reliefui
