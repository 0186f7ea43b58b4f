#include "painting/formula_text.h"

#include <algorithm>
#include <cmath>

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// Number of bytes of the UTF-8 character that begins with this byte.
std::size_t signBytes(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

}  // namespace

std::vector<FormulaRun> formulaRuns(const std::string& formula) {
    std::vector<FormulaRun> runs;
    const auto add = [&](const std::string& text, int level) {
        if (text.empty()) return;
        if (runs.empty() || runs.back().level != level) runs.push_back({{}, level});
        runs.back().text += text;
    };
    std::size_t at = 0;
    while (at < formula.size()) {
        const bool script = (formula[at] == '_' || formula[at] == '^') && at + 1 < formula.size();
        if (!script) {
            const std::size_t next = std::min(formula.find_first_of("_^", at + 1), formula.size());
            add(formula.substr(at, next - at), 0);
            at = next;
            continue;
        }
        const int level = formula[at] == '_' ? -1 : 1;
        ++at;
        const std::size_t close = formula[at] == '{' ? formula.find('}', at) : std::string::npos;
        if (close != std::string::npos) {
            add(formula.substr(at + 1, close - at - 1), level);
            at = close + 1;
        } else {
            const std::size_t bytes = signBytes(formula[at]);
            add(formula.substr(at, bytes), level);
            at += bytes;
        }
    }
    return runs;
}

std::string formulaWords(const std::string& formula) {
    std::string words = formula;
    for (char& c : words) c = c == '{' ? '(' : c == '}' ? ')' : c;
    return words;
}

double formulaWidth(const std::string& formula, double size, bool bold) {
    double width = 0;
    for (const FormulaRun& run : formulaRuns(formula)) {
        width += textWidth(run.text, run.level == 0 ? size : size * kScriptSize, bold);
    }
    return width;
}

std::string formulaNumber(double value) {
    constexpr int kDigits = 4;
    constexpr double kSmall = 1e-3, kLarge = 1e6;
    if (std::isnan(value)) return "—";
    const std::string sign = value < 0 ? "−" : "";
    const double size = std::abs(value);
    if (std::isinf(size)) return sign + "∞";
    if (size == 0) return "0";
    const auto power = static_cast<int>(std::floor(std::log10(size)));
    if (size >= kSmall && size < kLarge) return sign + relief::fixedText(size, std::max(kDigits - 1 - power, 0));
    const std::string exponent = (power < 0 ? "−" : "") + std::to_string(std::abs(power));
    return sign + relief::fixedText(size / std::pow(10.0, power), kDigits - 1) + "×10^{" + exponent + "}";
}

}  // namespace reliefui
