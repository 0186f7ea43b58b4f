#include "relief/maps/engine_codes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "relief/describe.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 9> kRoles{"zero",     "height",   "depth",    "apex",    "cone",
                                                 "distance", "normal-x", "normal-y", "normal-z"};
constexpr std::array<std::string_view, 2> kWhites{"high", "deep"};
constexpr std::array<std::string_view, 2> kRoundings{"outward", "nearest"};
constexpr std::array<std::string_view, 3> kUnits{"ratio", "sqrt-ratio", "slope"};
constexpr std::array<std::string_view, 2> kLengths{"uv", "width"};

template <class Value, std::size_t N>
Value parsed(std::string_view text, const std::array<std::string_view, N>& names, const std::string& option) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found != names.end()) return static_cast<Value>(found - names.begin());
    std::vector<std::string> known(names.begin(), names.end());
    throw InputError(option, unknownName({"what", option}, std::string(text), commaList(known)));
}

template <std::size_t N, class Value>
std::string_view nameOf(const std::array<std::string_view, N>& names, Value value) {
    return names[static_cast<std::size_t>(value)];
}

constexpr int kFloatBits = 32;

double mostCode(int bits) {
    return std::exp2(bits) - 1;
}
float storedCode(double code, int bits) {
    return static_cast<float>(std::clamp(code, 0.0, mostCode(bits)) / mostCode(bits));
}
double codeOf(float stored, int bits) {
    return std::round(static_cast<double>(stored) * mostCode(bits));
}

}  // namespace

std::string_view engineRoleName(EngineRole role) {
    return nameOf(kRoles, role);
}
EngineRole parseEngineRole(std::string_view text, const std::string& option) {
    return parsed<EngineRole>(text, kRoles, option);
}
std::string_view heightWhiteName(HeightWhite white) {
    return nameOf(kWhites, white);
}
HeightWhite parseHeightWhite(std::string_view text, const std::string& option) {
    return parsed<HeightWhite>(text, kWhites, option);
}
std::string_view engineRoundingName(EngineRounding rounding) {
    return nameOf(kRoundings, rounding);
}
EngineRounding parseEngineRounding(std::string_view text, const std::string& option) {
    return parsed<EngineRounding>(text, kRoundings, option);
}
std::string_view coneUnitName(ConeUnit unit) {
    return nameOf(kUnits, unit);
}
ConeUnit parseConeUnit(std::string_view text, const std::string& option) {
    return parsed<ConeUnit>(text, kUnits, option);
}
std::string_view coneLengthName(ConeLength length) {
    return nameOf(kLengths, length);
}
ConeLength parseConeLength(std::string_view text, const std::string& option) {
    return parsed<ConeLength>(text, kLengths, option);
}

std::vector<EngineRole> parseEnginePack(const std::string& text, const std::string& option) {
    std::vector<EngineRole> channels;
    std::array<bool, kEngineLetters.size()> given{};
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string part = text.substr(at, end - at);
        at = end + 1;
        const std::size_t letter = part.size() > 2 && part[1] == '=' ? kEngineLetters.find(part[0]) : std::string::npos;
        if (letter == std::string::npos) {
            throw InputError(option, Message(MessageId::NotASetting, {{"text", part}, {"example", "R=height,G=cone"}}));
        }
        if (given[letter]) throw InputError(option + " " + part[0], Message(MessageId::ArgumentRepeated));
        given[letter] = true;
        if (channels.size() <= letter) channels.resize(letter + 1, EngineRole::Zero);
        channels[letter] = parseEngineRole(part.substr(2), option);
    }
    return channels;
}

std::string enginePackText(const std::vector<EngineRole>& channels) {
    std::string text;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        text +=
            (c == 0 ? "" : ",") + std::string(1, kEngineLetters[c]) + "=" + std::string(engineRoleName(channels[c]));
    }
    return text;
}

bool packs(const std::vector<EngineRole>& channels, EngineRole role) {
    return std::find(channels.begin(), channels.end(), role) != channels.end();
}

std::string engineBitsText(int bits) {
    return bits == kFloatBits ? "float" : std::to_string(bits) + " bits";
}

float nearestCode(double x, int bits) {
    if (bits == kFloatBits) return static_cast<float>(x);
    return storedCode(std::floor(x * mostCode(bits) + 0.5), bits);
}
float lowerCode(double x, int bits) {
    const float stored = nearestCode(x, bits);
    return static_cast<double>(stored) > x ? codeBelow(stored, bits) : stored;
}
float higherCode(double x, int bits) {
    const float stored = nearestCode(x, bits);
    return static_cast<double>(stored) < x ? codeAbove(stored, bits) : stored;
}
float codeBelow(float stored, int bits) {
    if (bits == kFloatBits) return std::nextafter(stored, -std::numeric_limits<float>::infinity());
    return storedCode(codeOf(stored, bits) - 1, bits);
}
float codeAbove(float stored, int bits) {
    if (bits == kFloatBits) return std::nextafter(stored, std::numeric_limits<float>::infinity());
    return storedCode(codeOf(stored, bits) + 1, bits);
}

double ConeCoding::ratio(double stored) const {
    switch (unit) {
        case ConeUnit::Ratio:
            return stored * scale;
        case ConeUnit::SqrtRatio:
            return stored * stored * scale;
        case ConeUnit::Slope:
            break;
    }
    return stored > 0 ? 1 / (stored * scale) : std::numeric_limits<double>::infinity();
}

double ConeCoding::texelsAlong(int width, int height, bool down) const {
    return length == ConeLength::Uv && down ? height : width;
}

double ConeCoding::texels(int width, int height) const {
    return std::max(texelsAlong(width, height, false), texelsAlong(width, height, true));
}

double ConeCoding::slope(double stored, int width, int height) const {
    return 1 / (ratio(stored) * texels(width, height));
}

float ConeCoding::encode(double slope, int width, int height, int bits, EngineRounding rounding) const {
    const double perUnit = slope * texels(width, height);  // heights per unit of length
    if (unit == ConeUnit::Slope) {
        const double x = perUnit / scale;
        if (rounding == EngineRounding::Nearest) return nearestCode(x, bits);
        return higherCode(x * (1 + kEngineMargin), bits);
    }
    const double margin = rounding == EngineRounding::Nearest ? 0 : kEngineMargin;
    const double share = std::min(1.0, (1 - margin) / (perUnit * scale));
    const double x = unit == ConeUnit::SqrtRatio ? std::sqrt(share) : share;
    if (rounding == EngineRounding::Nearest) return nearestCode(x, bits);
    // The margin covers the rounding of decoding, too.
    return lowerCode(x, bits);
}

}  // namespace relief
