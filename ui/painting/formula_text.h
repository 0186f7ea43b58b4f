// Formulas as text: _ lowers and ^ raises what follows, one sign or what stands between { and }.
#pragma once

#include <string>
#include <vector>

#include "painting/text_width.h"

namespace reliefui {

// A piece of a formula in one size. level: 0 on the line, -1 below it, 1 above it.
struct FormulaRun {
    std::string text;
    int level = 0;
};
// "V_{i+1} = 2 V_i^2": "V", "i+1" below, " = 2 V", "i" below, "2" above.
std::vector<FormulaRun> formulaRuns(const std::string& formula);
// The same words in one line, for reading out and copying: "V_(i+1) = 2 V_i^2".
std::string formulaWords(const std::string& formula);

// Of a lowered or raised piece: its size, times that of the line, and how far it is moved, of the line's size.
inline constexpr double kScriptSize = 0.72;
inline constexpr double kLowered = 0.20;
inline constexpr double kRaised = 0.34;

// As textWidth().
double formulaWidth(const std::string& formula, double size = kChartText, bool bold = false);

// A number of formulas: four significant digits, "0.4012", "1.250×10^{−5}", "−3", "∞", and "—" where it is none.
std::string formulaNumber(double value);

}  // namespace reliefui
