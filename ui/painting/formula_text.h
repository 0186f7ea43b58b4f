// Formulas as text: _ makes a subscript and ^ a superscript of the next character or of a group in { and }.
#pragma once

#include <string>
#include <vector>

#include "painting/text_width.h"

namespace reliefui {

// Part of a formula set in one size. level: 0 on the baseline, -1 subscript, 1 superscript.
struct FormulaRun {
    std::string text;
    int level = 0;
};
// Splits a formula into runs: "V_{i+1} = 2 V_i^2" gives "V", "i+1" (level -1), " = 2 V", "i" (-1), "2" (1).
std::vector<FormulaRun> formulaRuns(const std::string& formula);
// The formula as plain text, for screen readers and for copying: "V_(i+1) = 2 V_i^2".
std::string formulaWords(const std::string& formula);

// Font size of a subscript or superscript, and its vertical shift, both relative to the font size of the baseline.
inline constexpr double kScriptSize = 0.72;
inline constexpr double kLowered = 0.20;
inline constexpr double kRaised = 0.34;

// Width of the typeset formula; units and arguments as in textWidth().
double formulaWidth(const std::string& formula, double size = kChartText, bool bold = false);

// Formats a number with four significant digits: "0.4012", "1.250×10^{−5}", "−3", "∞"; "—" for NaN.
std::string formulaNumber(double value);

}  // namespace reliefui
