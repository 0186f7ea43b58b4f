// Numbers in formulas, with their signs where a reader expects them.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "painting/formula_text.h"

namespace reliefui::term {

inline bool negative(const std::string& text) {
    return text.starts_with("−");
}
// In parentheses where a power or a quotient would take a part of it.
inline std::string atom(double value) {
    const std::string text = formulaNumber(value);
    return negative(text) || text.find("×") != std::string::npos ? "(" + text + ")" : text;
}
// "−0.5 · 12": the sign of both in front.
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
