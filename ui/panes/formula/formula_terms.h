// Formatting of numbers as terms of formulas, with conventional placement of signs.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "painting/formula_text.h"

namespace reliefui::term {

inline bool negative(const std::string& text) {
    return text.starts_with("−");
}
// Adds parentheses if a power or quotient would otherwise bind to only part of the number.
inline std::string atom(double value) {
    const std::string text = formulaNumber(value);
    return negative(text) || text.find("×") != std::string::npos ? "(" + text + ")" : text;
}
// Product with the combined sign in front: "−0.5 · 12".
inline std::string product(double a, double b) {
    const std::string text = formulaNumber(std::abs(a)) + " · " + formulaNumber(std::abs(b));
    return a * b < 0 ? "−" + text : text;  // nothing is not negative
}
inline std::string square(double value) {
    return atom(value) + "²";
}
inline std::string withoutSign(const std::string& text) {
    return text.substr(std::string("−").size());
}
inline std::string plus(const std::string& text) {
    return negative(text) ? " − " + withoutSign(text) : " + " + text;
}
inline std::string minus(const std::string& text) {
    return negative(text) ? " + " + withoutSign(text) : " − " + text;
}
inline std::string pair(double a, double b) {
    return "(" + formulaNumber(a) + ", " + formulaNumber(b) + ")";
}

}  // namespace reliefui::term
