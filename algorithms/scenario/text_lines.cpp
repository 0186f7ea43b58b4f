#include "scenario/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "relief/errors.h"

namespace relief {

namespace {

constexpr std::size_t kQuotedLength = 60;

}  // namespace

std::size_t characterCount(std::string_view text) {
    // All bytes but those that continue a character.
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string quoted(std::string_view text) {
    std::string out(text.substr(0, kQuotedLength));
    // Cut only between UTF-8 characters.
    while (text.size() > kQuotedLength && !out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0U) == 0x80U) {
        out.pop_back();
    }
    if (text.size() > kQuotedLength) {
        if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0x80U) out.pop_back();
        out += "...";
    }
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) c = '?';
    }
    return out;
}

std::string_view takeLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

double finiteNumber(std::string_view text, const std::string& fileName, std::size_t line) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end == text.data() + text.size() && !text.empty();
    if (error == std::errc::invalid_argument || !whole) {
        throw InputError(fileName, Message(MessageId::RayNumber, {{"line", line}, {"text", quoted(text)}}));
    }
    if (error == std::errc::result_out_of_range) {
        // Numbers too small for a double are read as 0; too large ones are refused as not finite.
        const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
        value = tiny ? 0 : HUGE_VAL;
    }
    if (!std::isfinite(value)) {
        throw InputError(fileName, Message(MessageId::RayNotFinite, {{"line", line}, {"text", quoted(text)}}));
    }
    return value;
}

std::string_view takeCell(std::string_view& line) {
    const std::size_t comma = line.find(',');
    const std::string_view cell = line.substr(0, comma);
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
    return cell;
}

std::optional<std::vector<std::string_view>> columnsAfter(std::string_view header, std::string_view first) {
    if (!header.starts_with(first)) return std::nullopt;
    header.remove_prefix(first.size());
    if (!header.empty() && header.front() != ',') return std::nullopt;
    std::vector<std::string_view> names;
    while (!header.empty()) {
        header.remove_prefix(1);  // skips the comma
        names.push_back(header.substr(0, header.find(',')));
        header.remove_prefix(names.back().size());
    }
    return names;
}

void requireCells(std::string_view row, std::size_t wanted, const std::string& fileName, std::size_t line) {
    const auto count = static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1;
    if (count == wanted) return;
    throw InputError(fileName, Message(MessageId::StepColumns, {{"line", line}, {"wanted", wanted}, {"count", count}}));
}

std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
    return text;
}

}  // namespace relief
