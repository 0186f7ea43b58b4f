#include "relief/messages.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace relief {

namespace {

struct Entry {
    std::string_view english;
    std::string_view ukrainian;
};

constexpr std::array<Entry, static_cast<std::size_t>(MessageId::Count)> kTable{{
#define RELIEF_MESSAGE(id, english, ukrainian) Entry{english, ukrainian},
#include "relief/messages.def"
#undef RELIEF_MESSAGE
}};

}  // namespace

std::string numberText(double value) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string numberText(double value, int digits) {
    std::array<char, 64> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

MessageValue::MessageValue(std::string valueName, Message message)
    : name(std::move(valueName)), inner(std::make_shared<const Message>(std::move(message))) {}

MessageValue::MessageValue(std::string valueName, MessageId word) : MessageValue(std::move(valueName), Message(word)) {}

namespace {

// Damerau-Levenshtein distance (optimal string alignment), ignoring case: the smallest number of letters inserted,
// deleted, replaced or swapped with their neighbour that turns one word into the other.
std::size_t slipsBetween(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
    };
    std::vector<std::vector<std::size_t>> slips(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                slips[i][j] = i + j;
                continue;
            }
            slips[i][j] = std::min(
                {slips[i - 1][j] + 1, slips[i][j - 1] + 1, slips[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1])) {
                slips[i][j] = std::min(slips[i][j], slips[i - 2][j - 2] + 1);
            }
        }
    }
    return slips[a.size()][b.size()];
}

}  // namespace

std::string nearestName(std::string_view name, const std::vector<std::string>& known) {
    constexpr std::size_t kLettersPerSlip = 3;
    constexpr std::size_t kLongest = 64;  // letters; longer names are not typing errors
    if (name.empty() || name.size() > kLongest) return {};
    std::size_t fewest = std::max<std::size_t>(1, name.size() / kLettersPerSlip) + 1;
    const std::string* nearest = nullptr;
    for (const std::string& one : known) {
        const std::size_t slips = slipsBetween(name, one);
        // slips >= one.size() would make every name of one or two letters similar.
        if (slips >= fewest || slips >= one.size()) continue;
        fewest = slips;
        nearest = &one;
    }
    if (nearest != nullptr) return *nearest;
    // No similar name: accept a known name that contains the given one.
    for (const std::string& one : known) {
        if (name.size() >= kLettersPerSlip && one.find(name) != std::string::npos) return one;
    }
    return {};
}

Message unknownName(MessageValue what, const std::string& name, const std::string& known) {
    if (known.empty()) return Message(MessageId::UnknownNone, {std::move(what), {"name", name}});
    std::vector<std::string> names;
    for (std::size_t at = 0; at < known.size();) {
        const std::size_t end = std::min(known.find(", ", at), known.size());
        names.push_back(known.substr(at, end - at));
        at = end + 2;
    }
    const std::string near = nearestName(name, names);
    if (near.empty()) return Message(MessageId::UnknownName, {std::move(what), {"name", name}, {"known", known}});
    return Message(MessageId::UnknownNear, {std::move(what), {"name", name}, {"near", near}, {"known", known}});
}

std::string_view messageTemplate(MessageId id, Language language) {
    const Entry& entry = kTable.at(static_cast<std::size_t>(id));
    return language == Language::Ukrainian ? entry.ukrainian : entry.english;
}

std::string sentence(const Message& message, Language language) {
    const std::string_view text = messageTemplate(message.id, language);
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t open = text.find('{', at);
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        out += text.substr(at, open - at);
        const std::string_view name = text.substr(open + 1, close - open - 1);
        bool found = false;
        for (const MessageValue& value : message.values) {
            if (value.name != name) continue;
            out += value.inner ? sentence(*value.inner, language) : value.text;
            found = true;
            break;
        }
        if (!found) out += text.substr(open, close - open + 1);
        at = close + 1;
    }
    out += text.substr(at);
    return out;
}

}  // namespace relief
