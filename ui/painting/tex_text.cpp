#include "painting/tex_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "painting/formula_text.h"
#include "scenario/text_lines.h"

namespace reliefui {

namespace {

struct TexSign {
    std::string_view sign;
    std::string_view tex;
};

// Signs set in mathematics.
constexpr std::array kMathSigns = std::to_array<TexSign>({
    {"−", "-"},
    {"×", "\\times "},
    {"÷", "\\div "},
    {"±", "\\pm "},
    {"·", "\\cdot "},
    {"⋅", "\\cdot "},
    {"≤", "\\le "},
    {"≥", "\\ge "},
    {"≠", "\\ne "},
    {"≈", "\\approx "},
    {"∞", "\\infty "},
    {"√", "\\surd "},
    {"→", "\\to "},
    {"°", "^{\\circ}"},
    {"′", "'"},
    {"∈", "\\in "},
    {"∑", "\\sum "},
    {"∂", "\\partial "},
    {"●", "\\bullet "},
    {"○", "\\circ "},
    {"▶", "\\triangleright "},
    {"▷", "\\triangleright "},
    {"◀", "\\triangleleft "},
    {"□", "\\square "},
    {"✓", "\\surd "},
    {"<", "<"},
    {">", ">"},
    {"|", "|"},
    {"²", "^{2}"},
    {"³", "^{3}"},
    {"¹", "^{1}"},
    {"⁰", "^{0}"},
    {"⁴", "^{4}"},
    {"⁵", "^{5}"},
    {"⁶", "^{6}"},
    {"⁷", "^{7}"},
    {"⁸", "^{8}"},
    {"⁹", "^{9}"},
    {"⁻", "^{-}"},
    {"₀", "_{0}"},
    {"₁", "_{1}"},
    {"₂", "_{2}"},
    {"₃", "_{3}"},
    {"₄", "_{4}"},
    {"₅", "_{5}"},
    {"₆", "_{6}"},
    {"₇", "_{7}"},
    {"₈", "_{8}"},
    {"₉", "_{9}"},
    {"α", "\\alpha "},
    {"β", "\\beta "},
    {"γ", "\\gamma "},
    {"δ", "\\delta "},
    {"ε", "\\varepsilon "},
    {"ζ", "\\zeta "},
    {"η", "\\eta "},
    {"θ", "\\theta "},
    {"ι", "\\iota "},
    {"κ", "\\kappa "},
    {"λ", "\\lambda "},
    {"μ", "\\mu "},
    {"µ", "\\mu "},
    {"ν", "\\nu "},
    {"ξ", "\\xi "},
    {"π", "\\pi "},
    {"ρ", "\\rho "},
    {"σ", "\\sigma "},
    {"τ", "\\tau "},
    {"υ", "\\upsilon "},
    {"φ", "\\varphi "},
    {"χ", "\\chi "},
    {"ψ", "\\psi "},
    {"ω", "\\omega "},
    {"Γ", "\\Gamma "},
    {"Δ", "\\Delta "},
    {"Θ", "\\Theta "},
    {"Λ", "\\Lambda "},
    {"Ξ", "\\Xi "},
    {"Π", "\\Pi "},
    {"Σ", "\\Sigma "},
    {"Φ", "\\Phi "},
    {"Ψ", "\\Psi "},
    {"Ω", "\\Omega "},
});
// Signs set as text. A quotation mark is active under some languages of babel.
constexpr std::array kTextSigns = std::to_array<TexSign>({
    {"\\", "\\textbackslash{}"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"#", "\\#"},
    {"$", "\\$"},
    {"%", "\\%"},
    {"&", "\\&"},
    {"_", "\\_"},
    {"\"", "''"},
    {"—", "---"},
    {"–", "--"},
    {"’", "'"},
    {"“", "``"},
    {"”", "''"},
    {"\u00A0", "~"},
    {"…", "\\ldots{}"},
    {"~", "\\textasciitilde{}"},
    {"^", "\\textasciicircum{}"},
    {"`", "\\textasciigrave{}"},
});

// Number of bytes of the UTF-8 character that begins with this byte.
std::size_t signBytes(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

template <std::size_t N>
const TexSign* signOf(const std::array<TexSign, N>& signs, std::string_view sign) {
    const auto found = std::find_if(signs.begin(), signs.end(), [&](const TexSign& s) { return s.sign == sign; });
    return found != signs.end() ? &*found : nullptr;
}

bool isLetter(std::string_view sign) {
    return sign.size() > 1 || std::isalpha(static_cast<unsigned char>(sign.front())) != 0;
}

// Calls `use` for each character of a UTF-8 text.
template <class Use>
void eachSign(const std::string& text, const Use& use) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t bytes = std::min(signBytes(text[at]), text.size() - at);
        use(std::string_view(text).substr(at, bytes));
        at += bytes;
    }
}

// One run of a formula, within mathematics.
std::string texRun(const std::string& text) {
    std::string tex;
    std::string word;  // letters that were not written yet
    const auto endWord = [&] {
        const std::size_t letters = relief::characterCount(word);
        const bool ascii = letters == word.size();
        if (letters == 0) return;
        if (!ascii) tex += "\\mbox{" + word + "}";  // fonts of mathematics have no Cyrillic letters
        if (ascii && letters == 1) tex += word;
        if (ascii && letters > 1) tex += "\\mathrm{" + word + "}";
        word.clear();
    };
    eachSign(text, [&](std::string_view sign) {
        const TexSign* const math = signOf(kMathSigns, sign);
        const TexSign* const other = signOf(kTextSigns, sign);
        if (math == nullptr && other == nullptr && isLetter(sign)) {
            word += sign;
            return;
        }
        endWord();
        if (math != nullptr) {
            // On an empty base, since two superscripts of one base are an error.
            const bool script = std::string_view("^_'").find(math->tex.front()) != std::string_view::npos;
            tex += (script ? "{}" : "") + std::string(math->tex);
        } else if (other != nullptr) {
            tex += "\\mbox{" + std::string(other->tex) + "}";
        } else {
            tex += sign == " " ? "\\ " : std::string(sign);
        }
    });
    endWord();
    return tex;
}

}  // namespace

std::string texText(const std::string& text) {
    std::string tex;
    eachSign(text, [&](std::string_view sign) {
        if (const TexSign* const math = signOf(kMathSigns, sign)) {
            std::string inner(math->tex);
            if (inner.ends_with(' ')) inner.pop_back();
            tex += "\\ensuremath{" + inner + "}";
        } else if (const TexSign* const other = signOf(kTextSigns, sign)) {
            tex += other->tex;
        } else {
            if (sign == "-" && tex.ends_with('-')) tex += "{}";  // two hyphens are no dash
            tex += sign;
        }
    });
    return tex;
}

std::string texFormula(const std::string& formula) {
    std::string tex = "$";
    for (const FormulaRun& run : formulaRuns(formula)) {
        const std::string inner = texRun(run.text);
        tex += run.level == 0 ? inner : (run.level < 0 ? "_{" : "^{") + inner + "}";
    }
    return tex + "$";
}

}  // namespace reliefui
