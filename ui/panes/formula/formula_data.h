// Content of the formula pane: the papers' equations with the chosen pixel's numbers. All numbers come from the core:
// the pixel's coefficients, the filter's log, the step's record. A pure function of a snapshot.
//
// Formulas use the markup of painting/formula_text.h: u_x, q^2, V_{i+1}.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workspace/snapshot.h"

namespace reliefui {

struct FormulaValue {
    std::string symbol;  // "u_x"
    double number = 0;
};

// An equation, or a list of named values without one.
struct FormulaRow {
    std::string formula;               // "u = (A x + B y + C) / q"; empty: values alone
    std::string numbers;               // right-hand side with numbers substituted; empty: none
    std::string result;                // "123.4 texels"; empty: the formula says a relation, not a value
    std::string source;                // "[PERSP] (1)"
    std::vector<FormulaValue> values;  // unrounded results: several for a point, or the entries of a list
};

// Subject of a group.
enum class FormulaPart : std::uint8_t { Mapping, Ray, Footprint };

struct FormulaGroup {
    FormulaPart part = FormulaPart::Mapping;
    std::string title;
    std::string note;  // text below the title
    std::vector<FormulaRow> rows;
};

// All groups for this step of the ray. Empty if no polygon covers the pixel, see formulasMissing(). texel: index, in
// the footprint's list, of the texel whose weight is shown; std::nullopt: the visible one with the largest weight.
std::vector<FormulaGroup> formulas(const Snapshot& snapshot, int step, relief::Language language,
                                   std::optional<std::size_t> texel = {});
// Explains why a snapshot has no formulas.
relief::MessageId formulasMissing(const Snapshot& snapshot);

// Formulas of this step according to its record; without rows if there are none. The step must exist.
FormulaGroup stepFormulas(const Snapshot& snapshot, int step, relief::Language language);

// The texel whose weight is shown by default: the visible one with the largest weight; null: none.
const relief::FootprintTexel* heaviestTexel(const PixelFootprint& footprint);

}  // namespace reliefui
