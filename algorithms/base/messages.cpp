#include "relief/messages.h"

#include <array>
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
