#include "measuring/bench/bench_columns.h"

#include <cassert>
#include <cmath>

#include <nlohmann/json.hpp>

#include "relief/errors.h"

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

std::optional<std::string_view> takeRecord(std::string_view& text) {
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '"') quoted = !quoted;
        if (text[at] != '\n' || quoted) continue;
        const std::string_view record = text.substr(0, at);
        text.remove_prefix(at + 1);
        return record;
    }
    return std::nullopt;
}

std::vector<CsvField> csvFields(std::string_view record) {
    std::vector<CsvField> fields(1);
    bool inside = false;
    for (std::size_t at = 0; at < record.size(); ++at) {
        const char c = record[at];
        if (c == '"') {
            // Two quotes inside a quoted field stand for one.
            const bool twice = inside && at + 1 < record.size() && record[at + 1] == '"';
            if (twice) fields.back().text += record[++at];
            if (!twice) inside = !inside;
            fields.back().quoted = true;
        } else if (c == ',' && !inside) {
            fields.emplace_back();
        } else {
            fields.back().text += c;
        }
    }
    return fields;
}

std::string jsonTable(std::span<const std::string_view> names, std::span<const BenchValue> values) {
    assert(!names.empty() && values.size() % names.size() == 0);
    auto all = nlohmann::ordered_json::array();
    for (std::size_t first = 0; first < values.size(); first += names.size()) {
        nlohmann::ordered_json object;
        for (std::size_t n = 0; n < names.size(); ++n) {
            std::visit([&](const auto& value) { object[std::string(names[n])] = value; }, values[first + n]);
        }
        all.push_back(std::move(object));
    }
    // File names may contain invalid UTF-8, which is replaced.
    return all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace relief
