// Sentences without a screen: an id and the values in it, put into words late, in the language of the listener.
// The sentences themselves stand in messages.def, English beside Ukrainian; numbers are formatted without the locale,
// so that "0.5" stays "0.5" wherever the program runs.
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

// Shortest text that reads back as the same number (std::to_chars); "nan", "inf" as they are.
std::string numberText(double value);
// The same rounded to `digits` significant digits, for sentences that people read.
std::string numberText(double value, int digits);

struct Message;

// A value inside a message: a text, or a message of its own, which is said in the listener's language as well.
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

// Of `known`, the name that `name` is most likely a slip of the finger for; empty where none is near.
std::string nearestName(std::string_view name, const std::vector<std::string>& known);
// "There is no WHAT called NAME", with the nearest of the known names ("a, b, c"), if one is near, and all of them.
Message unknownName(MessageValue what, const std::string& name, const std::string& known);

// "1 to 8".
template <class T>
Message rangeOf(T low, T high) {
    return Message(MessageId::RangeOf, {{"low", low}, {"high", high}});
}

// The message in words. A {name} without a value stays as it is (tests look for that).
std::string sentence(const Message& message, Language language = Language::English);

// The raw template, for tests of the table.
std::string_view messageTemplate(MessageId id, Language language);

}  // namespace relief
