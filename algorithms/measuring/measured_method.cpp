#include "measuring/measured_method.h"

#include <algorithm>

namespace relief {

namespace {

// The ends of a number's range, or every choice; without the default.
std::vector<std::string> telling(const OptionDescription& option, const std::string& defaultValue) {
    std::vector<std::string> values = option.choices;
    if (option.kind == OptionKind::Integer || option.kind == OptionKind::Real) {
        values = {numberText(option.low), numberText(option.high)};
    }
    std::erase(values, defaultValue);
    return values;
}

}  // namespace

bool MeasuredMethod::knows(Surface surface) const {
    return std::find(surfaces.begin(), surfaces.end(), surface) != surfaces.end();
}

MeasuredMethod measuredMethod(const MethodChoice& choice) {
    return {choice, findTracer(choice.name).surfaces, [choice](const HeightField& field, MapCache& cache, Work& work) {
                return makeTracer(choice, field, cache, work);
            }};
}

MethodChoice parseMethodChoice(const std::string& text, const std::string& option) {
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

std::vector<MeasuredMethod> defaultMethods() {
    std::vector<MeasuredMethod> methods;
    for (const MethodDescription& method : tracerList()) {
        if (method.kind == MethodKind::Tracer) methods.push_back(measuredMethod({method.name, {}}));
    }
    return methods;
}

std::vector<MeasuredMethod> methodVariants() {
    std::vector<MeasuredMethod> all;
    for (const MeasuredMethod& method : defaultMethods()) {
        std::vector<OptionValues> variants{{}};
        for (const OptionDescription& option : findTracer(method.choice.name).options) {
            const std::size_t before = variants.size();
            for (const std::string& value : telling(option, findTracer(method.choice.name).defaults.at(option.name))) {
                for (std::size_t v = 0; v < before; ++v) {
                    variants.push_back(variants[v]);
                    variants.back()[option.name] = value;
                }
            }
        }
        for (OptionValues& values : variants) all.push_back(measuredMethod({method.choice.name, std::move(values)}));
    }
    return all;
}

}  // namespace relief
