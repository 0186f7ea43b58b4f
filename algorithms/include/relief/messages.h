// Messages independent of the language: an identifier with values, which is formatted as a sentence only when it is
// shown, in the user's language. The sentences are in messages.def, in English and Ukrainian. Numbers are formatted
// independently of the locale, so that "0.5" is always "0.5".
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relief {

enum class Language : std::uint8_t { English, Ukrainian };

enum class MessageId : std::uint16_t {
#define RELIEF_MESSAGE(id, english, ukrainian) id,
#include "relief/messages.def"
#undef RELIEF_MESSAGE
    Count
};

// Returns the shortest text that reads back as the same number (std::to_chars); "nan" and "inf" for such values.
std::string numberText(double value);
// Returns the number rounded to `digits` significant digits, for sentences.
std::string numberText(double value, int digits);

struct Message;

// A value in a message: a text, or another message, which is formatted in the same language.
struct MessageValue {
    std::string name;
    std::string text;
    std::shared_ptr<const Message> inner;

    MessageValue(std::string valueName, std::string valueText)
        : name(std::move(valueName)), text(std::move(valueText)) {}
    MessageValue(std::string valueName, const char* valueText) : name(std::move(valueName)), text(valueText) {}
    template <std::integral T>
    MessageValue(std::string valueName, T value) : name(std::move(valueName)), text(std::to_string(value)) {}
    template <std::floating_point T>
    MessageValue(std::string valueName, T value)
        : name(std::move(valueName)), text(numberText(static_cast<double>(value))) {}
    // A message, or a word from the table, as the value.
    MessageValue(std::string valueName, Message message);
    MessageValue(std::string valueName, MessageId word);
};

struct Message {
    MessageId id{};
    std::vector<MessageValue> values;

    Message() = default;
    explicit Message(MessageId messageId, std::vector<MessageValue> messageValues = {})
        : id(messageId), values(std::move(messageValues)) {}
};

// Returns the name in `known` of which `name` is most likely a misspelling; empty if none is similar.
std::string nearestName(std::string_view name, const std::vector<std::string>& known);
// Returns the message "There is no WHAT called NAME" with all known names (given as "a, b, c") and the most similar
// one, if there is one.
Message unknownName(MessageValue what, const std::string& name, const std::string& known);

// Returns the message "LOW to HIGH", such as "1 to 8".
template <class T>
Message rangeOf(T low, T high) {
    return Message(MessageId::RangeOf, {{"low", low}, {"high", high}});
}

// Returns the formatted message. A {name} without a value remains unchanged, which tests detect.
std::string sentence(const Message& message, Language language = Language::English);

// Returns the unformatted template, for tests of the table.
std::string_view messageTemplate(MessageId id, Language language);

}  // namespace relief
