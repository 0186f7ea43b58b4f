#include "panes/rows/rows_state.h"

#include "measuring/bench/bench_rows.h"
#include "scenario/row_methods.h"
#include "workspace/pane_store.h"

namespace reliefui {

void RowsPane::read(relief::JsonReader reader) {
    if (reader.has("variants")) variants.clear();
    reader.readTexts("variants", [&](const std::string& text) {
        relief::parseRowMethod(text, "variants");
        variants.push_back(text);
    });
    reader.readWhole("pixels", pixels);
    reader.read("double", inDouble);
    reader.read("logarithmic", logarithmic);
    reader.finish();
}

void RowsPane::check(const std::string& subject) const {
    checkWithin(subject, "variants", static_cast<double>(variants.size()), 0, kMostRowVariants);
    for (const std::string& variant : variants) relief::parseRowMethod(variant, "variants");
    checkWithin(subject, "pixels", pixels, 0, static_cast<double>(relief::kWidestRow));
}

relief::Json RowsPane::json() const {
    return {{"variants", variants}, {"pixels", pixels}, {"double", inDouble}, {"logarithmic", logarithmic}};
}

}  // namespace reliefui
