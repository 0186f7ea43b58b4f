#include "filtering/filters/filters.h"

#include <cassert>
#include <type_traits>

#include "base/for_each_type.h"
#include "filtering/filters/filter_types.h"
#include "filtering/filters/measured_filters.h"

namespace relief {

namespace {

// Calls visit<Filter>() for the filter of this name.
template <class Visit>
void withFilter(const std::string& name, const Visit& visit) {
    forEachType<FilterTypes>([&]<class Filter>() {
        if (filterDescriptionOf<Filter>().name == name) visit.template operator()<Filter>();
    });
}

// Every filter with each of the settings that settingsOf<Filter>() returns.
template <class SettingsOf>
std::vector<FilterChoice> filtersWith(const SettingsOf& settingsOf) {
    std::vector<FilterChoice> all;
    forEachType<FilterTypes>([&]<class Filter>() {
        const std::string& name = filterDescriptionOf<Filter>().name;
        for (const std::string& setting : settingsOf.template operator()<Filter>()) {
            all.push_back(parseFilter(setting.empty() ? name : name + ":" + setting, "--filters"));
        }
    });
    return all;
}

// Parses the filter's options and checks their combination by Options::check(subject). Throws InputError.
template <class Filter>
typename Filter::Options optionsOf(const FilterChoice& choice, const std::string& subject) {
    auto options = parseOptions<typename Filter::Options>(choice.name, choice.options, subject);
    if constexpr (requires { options.check(subject); }) options.check(subject);
    return options;
}

}  // namespace

const std::vector<FilterDescription>& filterList() {
    static const std::vector<FilterDescription> list = [] {
        std::vector<FilterDescription> all;
        forEachType<FilterTypes>([&]<class Filter>() { all.push_back(filterDescriptionOf<Filter>()); });
        return all;
    }();
    return list;
}

std::vector<FilterChoice> filterForms() {
    std::vector<FilterChoice> forms;
    for (const FilterDescription& filter : filterList()) {
        FilterChoice choice;
        choice.name = filter.name;
        forms.push_back(choice);
        if (!filter.visible) continue;
        for (const OptionDescription& option : filter.options) {
            if (option.name != "form") continue;
            for (const std::string& form : option.choices) {
                if (form == filter.defaults.at(option.name)) continue;
                forms.push_back(choice);
                forms.back().options["form"] = form;
            }
        }
    }
    return forms;
}

std::vector<FilterChoice> benchedFilters() {
    return filtersWith([]<class Filter>() -> std::vector<std::string> {
        if constexpr (requires { Filter::benched(); }) return Filter::benched();
        return {""};
    });
}

std::vector<FilterChoice> advisedFilters() {
    return filtersWith([]<class Filter>() -> std::vector<std::string> {
        if constexpr (requires { Filter::advised(); }) return Filter::advised();
        return {""};
    });
}

const FilterDescription& findFilter(std::string_view name, const std::string& subject) {
    for (const FilterDescription& filter : filterList()) {
        if (filter.name == name) return filter;
    }
    throw InputError(subject, unknownName({"what", MessageId::WordFilter}, std::string(name), namesOf(filterList())));
}

bool needsLevels(const FilterChoice& choice) {
    return findFilter(choice.name).footprint;
}

std::optional<EllipticalSettings> ellipticalSettings(const FilterChoice& choice) {
    std::optional<EllipticalSettings> settings;
    withFilter(findFilter(choice.name).name, [&]<class Filter>() {
        using Options = typename Filter::Options;
        if constexpr (std::is_base_of_v<EllipticalOptions, Options>) {
            settings = EllipticalSettings::of(parseOptions<Options>(choice.name, choice.options, "--filter-set"));
        }
    });
    return settings;
}

void checkFilter(const FilterChoice& choice, const std::string& subject) {
    withFilter(findFilter(choice.name, subject).name, [&]<class Filter>() { optionsOf<Filter>(choice, subject); });
}

FilterChoice parseFilter(std::string_view text, const std::string& subject) {
    FilterChoice choice;
    std::size_t colon = text.find(':');
    choice.name = findFilter(text.substr(0, colon), subject).name;
    while (colon != std::string_view::npos) {
        text.remove_prefix(colon + 1);
        colon = text.find(':');
        const std::string_view part = text.substr(0, colon);
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos || equals == 0) {
            throw InputError(subject, Message(MessageId::NotASetting,
                                              {{"text", std::string(part)}, {"example", "elliptical:sigma=0.5"}}));
        }
        choice.options[std::string(part.substr(0, equals))] = part.substr(equals + 1);
    }
    checkFilter(choice, subject);
    return choice;
}

std::string filterText(const FilterChoice& choice) {
    std::string text = choice.name;
    for (const auto& [name, value] : choice.options) text.append(":").append(name).append("=").append(value);
    return text;
}

std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work) {
    assert(tools.picture && !tools.picture->empty());
    FilterTools ready = tools;
    if (needsLevels(choice) && !ready.levels) ready.levels = std::make_shared<const ColorLevels>(tools.picture, work);
    std::unique_ptr<const TextureFilter> made;
    withFilter(choice.name, [&]<class Filter>() {
        made = Filter::make(optionsOf<Filter>(choice, "--filter-set"), ready, maps, work);
    });
    return made;
}

}  // namespace relief
