// Descriptions of methods and their options. Each is described once; sliders, command-line options, help texts and
// tables derive from the description.
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

// An option: its name as in --set NAME=VALUE, its unit ("texels", "texture widths", ""), and the range and step of its
// slider.
struct OptionDescription {
    std::string name;
    OptionKind kind = OptionKind::Real;
    std::string unit;
    double low = 0;
    double high = 1;
    double step = 0.01;
    // Choice: the names; Method: the admissible methods; Integer: words that are accepted instead of a number.
    std::vector<std::string> choices;
    std::string help;
};

// An option that is a member of a plain struct, with its description. Its default is the member's value in a
// default-constructed struct.
template <class Options>
struct OptionField {
    OptionDescription description;
    std::variant<int Options::*, double Options::*, std::string Options::*> member;
};

// The guarantee of a tracer. Exact: finds the first hit. Conservative: never passes the first hit. Approximate: no
// guarantee.
enum class Guarantee : std::uint8_t { Exact, Conservative, Approximate };
// Tracer: finds where rays meet the relief. Shading: the ray ends on the polygon. AnyHit: tests only whether a segment
// is free. Mesh: the relief as triangles, which frames rasterise instead of tracing rays.
enum class MethodKind : std::uint8_t { Tracer, Shading, AnyHit, Mesh };
// The normal that lights the result of a method. Relief: that of the normal picture if there is one, otherwise the
// surface's normal at the hit. Plane: the polygon's. Heights: from the surface's slope. NormalMap: that of the normal
// picture, or of one made from the heights.
enum class ShadingNormal : std::uint8_t { Relief, Plane, Heights, NormalMap };
// The implementation that runs. Simd: the method's SIMD version. Scalar: the reference implementation, ray by ray.
enum class Form : std::uint8_t { Simd, Scalar };
// The rays for which a method and its maps are valid.
enum class RayClass : std::uint8_t { ViewRays, AnyRays };

struct MethodDescription {
    std::string name;   // as on the command line
    std::string title;  // human-readable, a few words
    std::string help;   // one line
    std::string source;
    MethodKind kind = MethodKind::Tracer;
    Guarantee guarantee = Guarantee::Approximate;
    RayClass rayClass = RayClass::ViewRays;
    ShadingNormal shading = ShadingNormal::Relief;
    std::vector<Surface> surfaces{Surface::Bilinear, Surface::Columns};
    std::vector<Address> addresses{Address::Repeat, Address::Clamp, Address::Border};
    std::vector<std::string> maps;       // names of the maps that the method needs
    std::vector<std::string> otherMaps;  // maps that it accepts in place of the first, chosen by the option `map`
    bool tiled = false;                  // whether it traces height maps that are read by tiles (HeightField::tiles())
    std::vector<OptionDescription> options;
    std::map<std::string, std::string> defaults;  // of the options, as text
};

// Options by name, as text ("layers": "64"), as on the command line and in scenarios.
using OptionValues = std::map<std::string, std::string>;

// A method's name with options; options that are not set have their defaults.
struct MethodChoice {
    std::string name = "max-pyramid";
    OptionValues options;
    bool operator==(const MethodChoice&) const = default;
};

// Splits "NAME:OPTION=VALUE:OPTION=VALUE" without checking the names. Throws InputError naming `option`.
MethodChoice splitMethodChoice(const std::string& text, const std::string& option);

// Returns "a, b, c", for messages and help.
std::string commaList(const std::vector<std::string>& names);
// Returns the comma-separated names of the elements.
template <class Named>
std::string namesOf(const std::vector<Named>& list) {
    std::vector<std::string> names;
    for (const Named& one : list) names.push_back(one.name);
    return commaList(names);
}

// The names of the values, as on the command line and in files.
std::string_view surfaceName(Surface surface);
std::string_view addressName(Address address);
std::string_view guaranteeName(Guarantee guarantee);
std::string_view methodKindName(MethodKind kind);
std::string_view rayClassName(RayClass rayClass);
std::string_view formName(Form form);
// Parses "simd" or "scalar"; "lanes", the spelling of earlier versions, means simd. Throws InputError naming the
// option.
Form parseForm(std::string_view text, const std::string& option);
// These throw InputError("--surface", ...) and InputError("--address", ...) with the known names.
Surface parseSurface(std::string_view text);
Address parseAddress(std::string_view text);

// Parses the whole text as a finite number, independent of the locale. Throws InputError naming the subject.
double parseNumber(std::string_view text, const std::string& subject);
// Checks the text against the option's kind, range and choices. Throws InputError naming the subject.
void checkOption(const OptionDescription& option, const std::string& text, const std::string& subject = "--set");

// Checks the text and assigns its value to the member. Throws InputError naming the subject. Not inlined, for the
// reason given at optionText().
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

// The option that selects one of MethodDescription::otherMaps.
inline constexpr std::string_view kMapOption = "map";
// The option that selects the memory layout of a method's map, and the layout that files use.
inline constexpr std::string_view kLayoutOption = "layout";
inline constexpr std::string_view kStoredLayout = "texel";
// Prefix of the options of an inner method: "inner.layers".
inline constexpr std::string_view kInnerPrefix = "inner.";

// Returns the method's option struct with the given values. Throws InputError naming the subject for unknown names and
// values out of range.
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

// Returns the member's value as text. Not inlined, because g++ 12 otherwise warns about the std::string member that the
// struct does not have.
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

// Appends the descriptions and defaults of the fields to the method's description.
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
