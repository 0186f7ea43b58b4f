// Methods and their options described once: sliders, flags, help texts and tables derive from this.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "relief/errors.h"
#include "relief/height_field.h"

namespace relief {

enum class OptionKind : std::uint8_t { Integer, Real, Choice, Method };

// One setting: name as in --set NAME=VALUE, unit ("texels", "texture widths", ""), range and step of its slider.
struct OptionDescription {
    std::string name;
    OptionKind kind = OptionKind::Real;
    std::string unit;
    double low = 0;
    double high = 1;
    double step = 0.01;
    // Choice: the names; Method: which may stand here; Integer: words that may stand instead of a number.
    std::vector<std::string> choices;
    std::string help;
};

// A described field of a plain struct of options. Its default is what a fresh struct holds.
template <class Options>
struct OptionField {
    OptionDescription description;
    std::variant<int Options::*, double Options::*, std::string Options::*> member;
};

// What tracers promise. Exact: the first hit. Conservative: never past the first hit. Approximate: no promise.
enum class Guarantee : std::uint8_t { Exact, Conservative, Approximate };
// Tracer: where rays meet the relief. Shading: the ray stays on the polygon. Mesh: the relief made of triangles, which
// frames rasterise instead of tracing rays.
enum class MethodKind : std::uint8_t { Tracer, Shading, AnyHit, Mesh };
// Whose normal lights what a method found. Relief: the normal picture's if there is one, else the surface's, at the
// hit. Plane: the polygon's. Heights: the surface's slope. NormalMap: the normal picture's, or one made from the
// heights.
enum class ShadingNormal : std::uint8_t { Relief, Plane, Heights, NormalMap };
// Which implementation runs. Simd: the method's SIMD version. Scalar: the reference, one ray after the other.
enum class Form : std::uint8_t { Simd, Scalar };
// Which rays a method (its maps) is valid for.
enum class RayClass : std::uint8_t { ViewRays, AnyRays };

struct MethodDescription {
    std::string name;   // as on the command line
    std::string title;  // a few words
    std::string help;   // one line
    std::string source;
    MethodKind kind = MethodKind::Tracer;
    Guarantee guarantee = Guarantee::Approximate;
    RayClass rayClass = RayClass::ViewRays;
    ShadingNormal shading = ShadingNormal::Relief;
    std::vector<Surface> surfaces{Surface::Bilinear, Surface::Columns};
    std::vector<Address> addresses{Address::Repeat, Address::Clamp, Address::Border};
    std::vector<std::string> maps;       // names of the maps needed
    std::vector<std::string> otherMaps;  // which it accepts in place of the first, chosen by the option `map`
    std::vector<OptionDescription> options;
    std::map<std::string, std::string> defaults;  // of the options, as text
};

// Options as given: name to text ("layers" to "64"), as on the command line and in scenarios.
using OptionValues = std::map<std::string, std::string>;

// The method by name, and its options.
struct MethodChoice {
    std::string name = "max-pyramid";
    OptionValues options;
    bool operator==(const MethodChoice&) const = default;
};

// "NAME:OPTION=VALUE:OPTION=VALUE" taken apart, not checked. Throws InputError naming `option`.
MethodChoice splitMethodChoice(const std::string& text, const std::string& option);

// "a, b, c", for messages and help.
std::string commaList(const std::vector<std::string>& names);
// The same of what has a name.
template <class Named>
std::string namesOf(const std::vector<Named>& list) {
    std::vector<std::string> names;
    for (const Named& one : list) names.push_back(one.name);
    return commaList(names);
}

std::string_view surfaceName(Surface surface);
std::string_view addressName(Address address);
std::string_view guaranteeName(Guarantee guarantee);
std::string_view methodKindName(MethodKind kind);
std::string_view rayClassName(RayClass rayClass);
std::string_view formName(Form form);
// "simd" or "scalar"; "lanes", as earlier versions had it, is simd. Throws InputError naming the option.
Form parseForm(std::string_view text, const std::string& option);
// Throw InputError("--surface", ...) and ("--address", ...) with the known names.
Surface parseSurface(std::string_view text);
Address parseAddress(std::string_view text);

// A finite number, the whole text, independent of the locale; InputError naming the subject otherwise.
double parseNumber(std::string_view text, const std::string& subject);
// Checks the text against kind, range and choices; throws InputError naming the subject.
void checkOption(const OptionDescription& option, const std::string& text, const std::string& subject = "--set");

// Checks the text and puts its value into the member. Not inlined: see optionText.
template <class Options>
[[gnu::noinline]] void assignOption(const OptionField<Options>& field, const std::string& text, Options& options,
                                    const std::string& subject) {
    checkOption(field.description, text, subject);
    if (const auto* integer = std::get_if<int Options::*>(&field.member)) {
        options.*(*integer) = static_cast<int>(parseNumber(text, field.description.name));
    } else if (const auto* real = std::get_if<double Options::*>(&field.member)) {
        options.*(*real) = parseNumber(text, field.description.name);
    } else {
        options.*(std::get<std::string Options::*>(field.member)) = text;
    }
}

// The option by which a method is given one of its MethodDescription::otherMaps.
inline constexpr std::string_view kMapOption = "map";
// The option by which a method chooses how its map lies in memory, and the layout that files hold.
inline constexpr std::string_view kLayoutOption = "layout";
inline constexpr std::string_view kStoredLayout = "texel";
// Options of a method inside another one: "inner.layers".
inline constexpr std::string_view kInnerPrefix = "inner.";

// The plain struct from what was given; unknown names and values out of range are errors.
template <class Options>
Options parseOptions(const std::string& method, const OptionValues& values, const std::string& subject = "--set") {
    Options options;
    const auto fields = Options::fields();
    for (const auto& [name, text] : values) {
        if constexpr (requires { options.innerOptions; }) {
            if (name.starts_with(kInnerPrefix)) {
                options.innerOptions[name.substr(kInnerPrefix.size())] = text;
                continue;
            }
        }
        const OptionField<Options>* found = nullptr;
        std::string known;
        for (const auto& field : fields) {
            if (field.description.name == name) found = &field;
            known += (known.empty() ? "" : ", ") + field.description.name;
        }
        if (found == nullptr) {
            throw InputError(
                subject, unknownName({"what", Message(MessageId::WordOptionOf, {{"method", method}})}, name, known));
        }
        if constexpr (!std::is_empty_v<Options>) assignOption(*found, text, options, subject);
    }
    return options;
}

// The field's value as text. Not inlined: g++ 12 otherwise warns of the text member that this struct has none of.
template <class Options>
[[gnu::noinline]] std::string optionText(const OptionField<Options>& field, const Options& options) {
    return std::visit(
        [&](auto member) -> std::string {
            const auto& value = options.*member;
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
                return value;
            else
                return MessageValue("", value).text;
        },
        field.member);
}

// Descriptions and defaults of the fields, for the method's own description.
template <class Options>
void describeOptions(MethodDescription& method) {
    if constexpr (std::is_empty_v<Options>) return;
    const Options defaults;
    for (const auto& field : Options::fields()) {
        method.options.push_back(field.description);
        method.defaults[field.description.name] = optionText(field, defaults);
    }
}

}  // namespace relief
