#include "panes/rows/rows_state.h"

#include "measuring/bench/bench_rows.h"
#include "panes/rows/rows_drawing.h"
#include "scenario/row_methods.h"
#include "workspace/pane_store.h"

namespace reliefui {

void RowsPane::read(relief::JsonReader reader) {
    if (reader.has("variants")) variants.clear();
    reader.readTexts("variants", [&](const std::string& text) {
        const relief::RowMethod method = relief::parseRowMethod(text, "variants");
        // Files of the first version may also name other row methods, of which this pane draws nothing.
        if (std::holds_alternative<relief::RowVariant>(method.description->kind)) variants.push_back(text);
    });
    reader.readWhole("pixels", pixels);
    reader.read("double", inDouble);
    reader.read("logarithmic", logarithmic);
    reader.finish();
}

void RowsPane::check(const std::string& subject) const {
    checkWithin(subject, "variants", static_cast<double>(variants.size()), 0, kMostRowVariants);
    rowMethods({.methods = variants}, "variants");  // throws
    checkWithin(subject, "pixels", pixels, 0, static_cast<double>(relief::kWidestRow));
}

relief::Json RowsPane::json() const {
    return {{"variants", variants}, {"pixels", pixels}, {"double", inDouble}, {"logarithmic", logarithmic}};
}

}  // namespace reliefui
