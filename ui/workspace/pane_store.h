// What is chosen in the panes: an object for each, by its name, which a scenario carries in its object `ui` and which
// only the pane can read. Nothing is rendered or traced anew when it changes. The state of a pane is a struct with
//   static constexpr const char* kName               its name in files
//   void read(relief::JsonReader)                    throws relief::InputError with the line of a fault
//   void check(const std::string& subject) const     the same, of values out of range
//   relief::Json json() const
// and operator==. Nothing is kept of a state that is as it is made.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scenario/json_reader.h"
#include "scenario/scenario.h"

namespace reliefui {

void readState(const relief::Scenario& scenario, const char* name, const std::function<void(relief::JsonReader)>& read);
// Empty: nothing is kept.
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

// Reads a state, checks it, and returns it as it is kept. subject: of what the errors speak.
using StateReader = std::function<relief::Json(relief::JsonReader reader, const std::string& subject)>;
// By the states' names. None at all: everything is taken as it stands.
struct StateReaders : std::map<std::string, StateReader> {
    using map::map;
};

// An entry of them.
template <class State>
StateReaders::value_type readerOf() {
    return {State::kName, [](relief::JsonReader reader, const std::string& subject) {
                State state;
                state.read(reader);
                state.check(subject);
                return state == State{} ? relief::Json() : state.json();
            }};
}

// relief::InputError for a state that no reader knows, and for the first value that is unknown or out of range.
void checkStates(const relief::Scenario& scenario, const StateReaders& readers, const std::string& subject);
// As parseScenario() and loadScenario(); the states are checked, too, and a fault in them names its line.
relief::Scenario parseWindowScenario(const std::string& text, const std::string& fileName, const StateReaders& readers);
relief::Scenario loadWindowScenario(const std::string& path, const StateReaders& readers);

// What states check with: relief::InputError that says what is known, or the range.
void checkName(const std::string& what, const std::string& name, const std::vector<std::string>& known);
void checkWithin(const std::string& subject, const std::string& what, double value, double low, double high);

}  // namespace reliefui
