#include "measuring/text_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "relief/messages.h"

namespace relief {

std::string textTable(const std::vector<TableRow>& rows, std::size_t left, std::size_t textFrom) {
    std::vector<std::size_t> widths;
    for (const TableRow& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string out;
    for (const TableRow& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string gap(widths[c] - row[c].size(), ' ');
            line += "  " + (c < left || c >= textFrom ? row[c] + gap : gap + row[c]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    }
    return out;
}

std::string readable(double value, int digits) {
    const double size = std::abs(value);
    if (value == 0 || !std::isfinite(value) || size < 1e-3 || size >= 1e6) return numberText(value, digits);
    const int whole = static_cast<int>(std::floor(std::log10(size))) + 1;
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed,
                                      std::max(0, digits - whole));
    return {buffer.data(), result.ptr};
}

Message bytesText(std::int64_t bytes, int digits) {
    constexpr double kKibi = 1024;
    if (static_cast<double>(bytes) < kKibi) return Message(MessageId::BytesText, {{"bytes", bytes}});
    const double kibibytes = static_cast<double>(bytes) / kKibi;
    const bool few = kibibytes < kKibi;
    return Message(few ? MessageId::KibibytesText : MessageId::MebibytesText,
                   {{"bytes", readable(few ? kibibytes : kibibytes / kKibi, digits)}});
}

}  // namespace relief
