#include "measuring/bench/measured_method.h"

#include <algorithm>

namespace relief {

namespace {

// Returns the ends of a number's range, or every choice, except the default. If a map is built from the number, the
// upper end is limited to twice the default, because it would take hours.
std::vector<std::string> valuesToVary(const OptionDescription& option, const std::string& defaultValue,
                                      bool buildsMaps) {
    std::vector<std::string> values = option.choices;
    if (option.kind == OptionKind::Integer || option.kind == OptionKind::Real) {
        const double twice = 2 * parseNumber(defaultValue, option.name);
        values = {numberText(option.low), numberText(buildsMaps ? std::min(option.high, twice) : option.high)};
    }
    std::erase(values, defaultValue);
    return values;
}

bool buildsMaps(const MethodChoice& choice) {
    const MethodDescription& method = findTracer(choice.name);
    if (!method.maps.empty() && method.maps.front() != "max-pyramid") return true;
    const auto standard = method.defaults.find("inner");
    if (standard == method.defaults.end()) return false;
    const auto given = choice.options.find("inner");
    return buildsMaps({given == choice.options.end() ? standard->second : given->second, {}});
}

}  // namespace

bool MeasuredMethod::supports(Surface surface, Address address) const {
    const auto has = [](const auto& all, auto value) { return std::find(all.begin(), all.end(), value) != all.end(); };
    return has(surfaces, surface) && has(addresses, address);
}

MeasuredMethod measuredMethod(const MethodChoice& choice, Form form) {
    MeasuredMethod method;
    method.choice = choice;
    method.form = form;
    method.surfaces.clear();
    method.addresses.clear();
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        if (supports(choice, surface, Address::Repeat)) method.surfaces.push_back(surface);
    }
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        if (supports(choice, method.surfaces.front(), address)) method.addresses.push_back(address);
    }
    method.buildsMaps = buildsMaps(choice);
    method.make = [choice, form](const HeightField& field, MapCache& cache, Work& work) {
        return makeTracer(choice, field, cache, work, form);
    };
    return method;
}

MethodChoice parseMethodChoice(const std::string& text, const std::string& option) {
    MethodChoice choice = splitMethodChoice(text, option);
    checkMethod(choice, option);
    return choice;
}

std::string optionsText(const MethodChoice& choice, bool all) {
    OptionValues values = choice.options;
    if (all) {
        for (const ChoiceOption& option : choiceOptions(choice)) {
            values.emplace(option.description.name, option.defaultValue);
        }
    }
    std::string text;
    for (const auto& [name, value] : values) text += (text.empty() ? "" : ":") + name + "=" + value;
    return text;
}

std::string methodText(const MethodChoice& choice) {
    return choice.options.empty() ? choice.name : choice.name + ":" + optionsText(choice, false);
}

std::vector<MeasuredMethod> defaultMethods(Form form) {
    std::vector<MeasuredMethod> methods;
    for (const MethodDescription& method : tracerList()) {
        if (method.kind == MethodKind::Tracer) methods.push_back(measuredMethod({method.name, {}}, form));
    }
    return methods;
}

bool isAccepted(const MethodChoice& choice) {
    try {
        checkMethod(choice, {});
    } catch (const InputError&) {
        return false;
    }
    return true;
}

std::vector<MeasuredMethod> methodVariants() {
    std::vector<MeasuredMethod> all;
    for (const MeasuredMethod& method : defaultMethods()) {
        const MethodDescription& description = findTracer(method.choice.name);
        std::vector<OptionValues> variants{{}};
        for (const OptionDescription& option : description.options) {
            const std::size_t before = variants.size();
            for (const std::string& value :
                 valuesToVary(option, description.defaults.at(option.name), method.buildsMaps)) {
                // Options of methods that build maps are varied one at a time, which limits the number of maps.
                for (std::size_t v = 0; v < (method.buildsMaps ? 1 : before); ++v) {
                    variants.push_back(variants[v]);
                    variants.back()[option.name] = value;
                }
            }
        }
        for (OptionValues& values : variants) {
            const MethodChoice choice{method.choice.name, std::move(values)};
            if (isAccepted(choice)) all.push_back(measuredMethod(choice));
        }
    }
    return all;
}

}  // namespace relief
