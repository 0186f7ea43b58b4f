// Texts for LaTeX: characters that TeX treats specially are escaped, and Greek letters, subscripts, superscripts and
// signs of arithmetic become mathematics. Letters of other alphabets stay as they are (UTF-8).
#pragma once

#include <string>

namespace reliefui {

std::string texText(const std::string& text);
// A formula (formula_text.h) in mathematics: single letters in italics, words and numbers upright.
std::string texFormula(const std::string& formula);

}  // namespace reliefui
