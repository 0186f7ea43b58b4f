// What the formula pane sets: the papers' equations with the chosen pixel's numbers put in. Every number is the core's:
// of the pixel's coefficients, the filter's log, the step's record. A pure function of a snapshot.
//
// Formulas are marked as painting/formula_text.h says: u_x, q^2, V_{i+1}.
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

// An equation, or values by name without one.
struct FormulaRow {
    std::string formula;               // "u = (A x + B y + C) / q"; empty: values alone
    std::string numbers;               // its right side with numbers put in; empty: there is none
    std::string result;                // "123.4 texels"; empty: the formula says a relation, not a value
    std::string source;                // "[PERSP] (1)"
    std::vector<FormulaValue> values;  // what it gives, unrounded: several of a point; the names of a list
};

// What a group is about.
enum class FormulaPart : std::uint8_t { Mapping, Ray, Footprint };

struct FormulaGroup {
    FormulaPart part = FormulaPart::Mapping;
    std::string title;
    std::string note;  // in words, below the title
    std::vector<FormulaRow> rows;
};

// At this step of the ray. Empty where no polygon covers the pixel: see formulasMissing(). texel: of the footprint's
// list, whose weight is set; none: the heaviest that counts.
std::vector<FormulaGroup> formulas(const Snapshot& snapshot, int step, relief::Language language,
                                   std::optional<std::size_t> texel = {});
// Why there are none; of a snapshot without formulas.
relief::MessageId formulasMissing(const Snapshot& snapshot);

// This step, as its record says; no rows where the record has no formula. There is a step.
FormulaGroup stepFormulas(const Snapshot& snapshot, int step, relief::Language language);

// The texel that the weights are set for unless one is pointed at: the heaviest that counts; null: none counts.
const relief::FootprintTexel* heaviestTexel(const PixelFootprint& footprint);

}  // namespace reliefui
