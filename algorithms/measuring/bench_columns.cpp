#include "measuring/bench_columns.h"

#include <cmath>

#include "errors.h"

namespace relief {

namespace {

std::string quotedField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

}  // namespace

std::string benchField(const BenchValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quotedField(*text);
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* whole = std::get_if<std::uint64_t>(&value)) return std::to_string(*whole);
    const double number = std::get<double>(value);
    return std::isfinite(number) ? numberText(number) : "";
}

}  // namespace relief
