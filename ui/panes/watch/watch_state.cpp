#include "panes/watch/watch_state.h"

#include "scenario/expression.h"
#include "workspace/pane_store.h"

namespace reliefui {

void WatchPane::read(relief::JsonReader reader) {
    if (reader.has("values")) values.clear();
    reader.readTexts("values", [&](const std::string& text) {
        const relief::Expression parsed(text);  // refuses what is none
        values.push_back(text);
    });
    reader.readWhole("chosen", chosen);
    reader.finish();
}

void WatchPane::check(const std::string& subject) const {
    checkWithin(subject, "values", static_cast<double>(values.size()), 0, static_cast<double>(kMostWatched));
    checkWithin(subject, "chosen", chosen, 0, static_cast<double>(kMostWatched));
    for (const std::string& value : values) {
        const relief::Expression parsed(value);  // refuses what is none
    }
}

relief::Json WatchPane::json() const {
    return {{"values", values}, {"chosen", chosen}};
}

std::string WatchPane::chosenValue() const {
    const auto at = static_cast<std::size_t>(chosen);
    return at < values.size() ? values[at] : std::string();
}

}  // namespace reliefui
