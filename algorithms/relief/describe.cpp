#include "relief/describe.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace relief {

namespace {

constexpr std::array<std::string_view, 2> kSurfaces{"bilinear", "columns"};
constexpr std::array<std::string_view, 3> kAddresses{"repeat", "clamp", "border"};
constexpr std::array<std::string_view, 3> kGuarantees{"exact", "conservative", "approximate"};
constexpr std::array<std::string_view, 4> kKinds{"tracer", "shading", "any-hit", "mesh"};
constexpr std::array<std::string_view, 2> kRayClasses{"view rays", "any rays"};

template <class Enum, std::size_t N>
Enum parseName(const std::array<std::string_view, N>& names, std::string_view text, const char* what) {
    std::string known;
    for (std::size_t i = 0; i < N; ++i) {
        if (names[i] == text) return static_cast<Enum>(i);
        known += (known.empty() ? "" : ", ") + std::string(names[i]);
    }
    throw InputError(std::string("--") + what, unknownName({"what", what}, std::string(text), known));
}

}  // namespace

std::string_view surfaceName(Surface surface) {
    return kSurfaces[static_cast<std::size_t>(surface)];
}
std::string_view addressName(Address address) {
    return kAddresses[static_cast<std::size_t>(address)];
}
std::string_view guaranteeName(Guarantee guarantee) {
    return kGuarantees[static_cast<std::size_t>(guarantee)];
}
std::string_view methodKindName(MethodKind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}
std::string_view rayClassName(RayClass rayClass) {
    return kRayClasses[static_cast<std::size_t>(rayClass)];
}

std::string_view formName(Form form) {
    return form == Form::Simd ? "simd" : "scalar";
}
Form parseForm(std::string_view text, const std::string& option) {
    if (text == "simd" || text == "lanes") return Form::Simd;
    if (text == "scalar") return Form::Scalar;
    throw InputError(option, unknownName({"what", MessageId::WordForm}, std::string(text), "simd, scalar"));
}

Surface parseSurface(std::string_view text) {
    return parseName<Surface>(kSurfaces, text, "surface");
}
Address parseAddress(std::string_view text) {
    return parseName<Address>(kAddresses, text, "address");
}

namespace {

// said: the text that an error message quotes.
double numberOf(std::string_view text, const std::string& said, const std::string& subject) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value)) {
        throw InputError(subject, Message(MessageId::NotANumber, {{"text", said}}));
    }
    return value;
}

}  // namespace

double parseNumber(std::string_view text, const std::string& subject) {
    return numberOf(text, std::string(text), subject);
}

void checkOption(const OptionDescription& option, const std::string& text, const std::string& subject) {
    if (option.kind == OptionKind::Choice || option.kind == OptionKind::Method) {
        if (std::find(option.choices.begin(), option.choices.end(), text) != option.choices.end()) return;
        throw InputError(subject, unknownName({"what", option.name}, text, commaList(option.choices)));
    }
    if (std::find(option.choices.begin(), option.choices.end(), text) != option.choices.end()) return;
    const double value = numberOf(text, option.name + "=" + text, subject);
    const bool whole = option.kind != OptionKind::Integer || value == std::floor(value);
    if (value < option.low || value > option.high || !whole) {
        const Message range(whole ? MessageId::RangeOf : MessageId::RangeWhole,
                            {{"low", option.low}, {"high", option.high}});
        throw InputError(subject,
                         Message(MessageId::OutOfRange, {{"what", option.name}, {"value", text}, {"range", range}}));
    }
}

std::string commaList(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all.append(all.empty() ? "" : ", ").append(name);
    return all;
}

MethodChoice splitMethodChoice(const std::string& text, const std::string& option) {
    std::size_t at = std::min(text.find(':'), text.size());
    MethodChoice choice{text.substr(0, at), {}};
    if (choice.name.empty()) throw InputError(option, Message(MessageId::MethodSpelling, {{"text", text}}));
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(':', at + 1), text.size());
        const std::string part = text.substr(at + 1, end - at - 1);
        at = end;
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError(option, Message(MessageId::MethodSpelling, {{"text", text}}));
        }
        choice.options[part.substr(0, equals)] = part.substr(equals + 1);
    }
    return choice;
}

}  // namespace relief
