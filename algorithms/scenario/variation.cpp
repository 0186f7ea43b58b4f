#include "scenario/variation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "relief/tracers.h"
#include "scenario/row_methods.h"

namespace relief {

namespace {

constexpr int kMostBits = 16;

// The alternatives that nextVariation() proposes, in this order.
std::vector<MethodChoice> proposals(CompareSubject subject) {
    switch (subject) {
        case CompareSubject::Filters:
            return {{"bilinear", {}}, {"trilinear", {}}, {"elliptical", {}}, {"supersample", {}}, {"nearest", {}}};
        case CompareSubject::Mappings:
            return {{"affine", {}}, {"direct", {}}, {"subspan", {}}, {"incremental", {{"anchor", "0"}}}};
        case CompareSubject::Heights:
            return {{kQuantised, {{kBits, "6"}}}, {kQuantised, {{kBits, "4"}}}, {kQuantised, {{kBits, "8"}}}};
        case CompareSubject::Methods:
            break;
    }
    return {{"exact", {}}, {"layers", {}}, {"offset", {}}, {"max-pyramid", {}}, {"cone-dummer", {}}};
}

bool promisesExact(const MethodChoice& method) {
    // The option `base` is the only one that gives up the guarantee.
    const auto base = method.options.find("base");
    return findTracer(method.name).guarantee == Guarantee::Exact &&
           (base == method.options.end() || base->second == "0");
}

MethodDescription describedFilter(const MethodChoice& choice) {
    const FilterDescription& filter = findFilter(choice.name);
    MethodDescription out;
    out.name = filter.name;
    out.title = filter.title;
    out.help = filter.help;
    out.source = filter.source;
    out.options = filter.options;
    out.defaults = filter.defaults;
    if (filter.name != kSupersample) return out;
    // The settings of supersampling are fields of the choice and no filter options, but are described like those.
    const auto given = choice.options.find(kPixelModel);
    OptionDescription samples;
    samples.name = kSamples;
    samples.kind = OptionKind::Integer;
    samples.low = fewestSamples(given != choice.options.end() ? parsePixelModel(given->second) : PixelModel::Box);
    samples.high = kMaxSamples;
    samples.step = 1;
    samples.help = "number of samples along each side of a pixel";
    OptionDescription models;
    models.name = kPixelModel;
    models.kind = OptionKind::Choice;
    models.choices.assign(kPixelModelNames.begin(), kPixelModelNames.end());
    models.help = "model of a display pixel: the weight function of the samples";
    // The name contains the range, because another range needs other controls.
    if (samples.low > 1) out.name += " from " + numberText(samples.low);
    out.options = {samples, models};
    out.defaults = {{kSamples, numberText(FilterChoice().samples)},
                    {kPixelModel, std::string(pixelModelName(FilterChoice().pixelModel))}};
    return out;
}

MethodDescription describedMapping(const MethodChoice& choice) {
    const std::vector<std::string> names = mappingNames();
    if (std::find(names.begin(), names.end(), choice.name) == names.end()) {
        throw InputError("", unknownName({"what", MessageId::WordMapping}, choice.name, commaList(names)));
    }
    MethodDescription out;
    for (const RowMethodDescription& method : rowMethodList()) {
        if (method.name != choice.name) continue;
        out.name = method.name;
        out.title = method.title;
        out.help = method.help;
        out.source = method.source;
        out.options = method.options;
        out.defaults = method.defaults;
    }
    std::erase_if(out.options, [](const OptionDescription& option) { return option.name == "error"; });
    return out;
}

MethodDescription describedHeights(const MethodChoice& choice) {
    MethodDescription out;
    out.name = choice.name;
    out.help = "the heights as read from the file";
    if (choice.name == kAsRead) return out;
    if (choice.name != kQuantised) {
        throw InputError(
            "", unknownName({"what", MessageId::WordHeights}, choice.name, std::string(kAsRead) + ", " + kQuantised));
    }
    out.help = "heights rounded to a number of bits, as in files of integers";
    OptionDescription bits;
    bits.name = kBits;
    bits.kind = OptionKind::Integer;
    bits.low = 1;
    bits.high = kMostBits;
    bits.step = 1;
    bits.help = "bits per height: 2^bits uniform values from 0 to 1";
    out.options = {bits};
    out.defaults = {{kBits, "8"}};
    return out;
}

int wholeOf(const std::string& text) {
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

FilterChoice filterOf(const MethodChoice& choice, const FilterChoice& own) {
    FilterChoice filter = own;
    filter.name = choice.name;
    filter.options = choice.options;
    if (choice.name != kSupersample) return filter;
    filter.options.clear();
    const auto value = [&](const char* name) -> const std::string* {
        const auto given = choice.options.find(name);
        return given == choice.options.end() ? nullptr : &given->second;
    };
    filter.pixelModel = value(kPixelModel) ? parsePixelModel(*value(kPixelModel)) : FilterChoice().pixelModel;
    filter.samples = std::max(value(kSamples) ? wholeOf(*value(kSamples)) : FilterChoice().samples,
                              fewestSamples(filter.pixelModel));
    return filter;
}

bool contains(const std::vector<MethodChoice>& list, CompareSubject subject, const MethodChoice& choice) {
    return std::any_of(list.begin(), list.end(), [&](const auto& one) { return sameVariation(subject, one, choice); });
}

// Returns values of an option other than its default, those with the largest effect first.
std::vector<std::string> otherValues(const OptionDescription& option, const std::string& standard) {
    if (option.kind == OptionKind::Choice || option.kind == OptionKind::Method) return option.choices;
    const double value = standard.empty() ? option.low : std::atof(standard.c_str());
    std::vector<std::string> values;
    for (const double number : {value / 2, value * 2, option.low, option.high}) {
        const double whole = option.kind == OptionKind::Integer ? std::floor(number) : number;
        values.push_back(numberText(std::clamp(whole, option.low, option.high)));
    }
    return values;
}

}  // namespace

MethodChoice ownVariation(const Scenario& scenario, CompareSubject subject) {
    switch (subject) {
        case CompareSubject::Filters: {
            const FilterChoice& filter = scenario.filter;
            if (filter.name != kSupersample) return {filter.name, filter.options};
            return {filter.name,
                    {{kSamples, std::to_string(filter.samples)},
                     {kPixelModel, std::string(pixelModelName(filter.pixelModel))}}};
        }
        case CompareSubject::Mappings:
            return splitMethodChoice(scenario.mapping, "mapping");
        case CompareSubject::Heights:
            return {kAsRead, {}};
        case CompareSubject::Methods:
            break;
    }
    return scenario.method;
}

std::vector<MethodChoice> comparedOf(const Scenario& scenario) {
    std::vector<MethodChoice> all{ownVariation(scenario, scenario.comparison.subject)};
    const auto& others = othersOf(scenario.comparison);
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

Scenario varied(Scenario scenario, CompareSubject subject, const MethodChoice& choice) {
    if (subject == CompareSubject::Methods) scenario.method = choice;
    if (subject == CompareSubject::Filters) scenario.filter = filterOf(choice, scenario.filter);
    if (subject == CompareSubject::Mappings) {
        scenario.mapping = choice.name;
        for (const auto& [name, value] : choice.options) scenario.mapping += ":" + name + "=" + value;
    }
    return scenario;
}

std::shared_ptr<const FloatImage> variedHeights(const std::shared_ptr<const FloatImage>& heights,
                                                const MethodChoice& choice) {
    if (choice.name == kAsRead) return heights;
    const MethodDescription described = describedHeights(choice);
    const auto bits = choice.options.find(kBits);
    const int count = wholeOf(bits != choice.options.end() ? bits->second : described.defaults.at(kBits));
    const float units = static_cast<float>((1 << count) - 1);
    auto rounded = std::make_shared<FloatImage>(heights->width(), heights->height());
    std::transform(heights->pixels().begin(), heights->pixels().end(), rounded->pixels().begin(),
                   [&](float height) { return std::round(height * units) / units; });
    return rounded;
}

std::vector<std::string> variationNames(CompareSubject subject) {
    std::vector<std::string> names;
    switch (subject) {
        case CompareSubject::Filters:
            for (const FilterDescription& filter : filterList()) names.push_back(filter.name);
            return names;
        case CompareSubject::Mappings:
            return mappingNames();
        case CompareSubject::Heights:
            return {kAsRead, kQuantised};
        case CompareSubject::Methods:
            break;
    }
    for (const MethodDescription& method : tracerList()) {
        if (method.kind != MethodKind::AnyHit) names.push_back(method.name);
    }
    return names;
}

MethodDescription describedVariation(CompareSubject subject, const MethodChoice& choice) {
    return subject == CompareSubject::Filters    ? describedFilter(choice)
           : subject == CompareSubject::Mappings ? describedMapping(choice)
           : subject == CompareSubject::Heights  ? describedHeights(choice)
                                                 : findTracer(choice.name);
}

void checkVariation(CompareSubject subject, const MethodChoice& choice, const std::string& where) {
    MethodDescription described;
    try {
        described = describedVariation(subject, choice);
    } catch (const InputError& error) {
        throw InputError(where, error.message());
    }
    if (subject == CompareSubject::Methods) return checkMethod(choice, where);
    if (subject == CompareSubject::Mappings) {
        parseMapping(varied({}, subject, choice).mapping, where);
        return;
    }
    for (const auto& [name, value] : choice.options) {
        const auto option = std::find_if(described.options.begin(), described.options.end(),
                                         [&, key = name](const auto& one) { return one.name == key; });
        if (option == described.options.end()) {
            const Message what(MessageId::WordOptionOf, {{"method", choice.name}});
            throw InputError(where, unknownName({"what", what}, name, namesOf(described.options)));
        }
        checkOption(*option, value, where);
    }
}

std::string variationText(CompareSubject subject, const MethodChoice& choice) {
    std::string text = choice.name;
    std::map<std::string, std::string> defaults = describedVariation(subject, choice).defaults;
    if (subject == CompareSubject::Heights && choice.name == kQuantised) {
        const auto bits = choice.options.find(kBits);
        return text + ":" + kBits + "=" + (bits != choice.options.end() ? bits->second : defaults.at(kBits));
    }
    if (subject == CompareSubject::Methods) {
        for (const ChoiceOption& option : choiceOptions(choice)) {
            defaults[option.description.name] = option.defaultValue;
        }
    }
    for (const auto& [name, value] : choice.options) {
        const auto standard = defaults.find(name);
        if (standard == defaults.end() || standard->second != value) text += ":" + name + "=" + value;
    }
    return text;
}

bool sameVariation(CompareSubject subject, const MethodChoice& a, const MethodChoice& b) {
    return a.name == b.name && variationText(subject, a) == variationText(subject, b);
}

MethodChoice referenceVariation(const Scenario& scenario) {
    switch (scenario.comparison.subject) {
        case CompareSubject::Filters: {
            FilterChoice truth;
            truth.name = kSupersample;
            truth.samples = kTruthSamples;
            for (const MethodChoice& choice : comparedOf(scenario)) {
                if (choice.name != kSupersample) continue;
                const FilterChoice one = filterOf(choice, {});
                if (truth.samples == kTruthSamples) truth.pixelModel = one.pixelModel;
                truth.samples = std::max(truth.samples, one.samples);
            }
            Scenario best;
            best.filter = truth;
            return ownVariation(best, CompareSubject::Filters);
        }
        case CompareSubject::Mappings:
            return {"direct", {}};
        case CompareSubject::Heights:
            return {kAsRead, {}};
        case CompareSubject::Methods:
            break;
    }
    return {"exact", {}};
}

std::optional<MethodChoice> nextVariation(const Scenario& scenario) {
    const CompareSubject subject = scenario.comparison.subject;
    const std::vector<MethodChoice> all = comparedOf(scenario);
    const auto fits = [&](const MethodChoice& choice) {
        return !contains(all, subject, choice) &&
               (subject != CompareSubject::Methods || supports(choice, scenario.surface, scenario.address));
    };
    if (subject == CompareSubject::Methods && all.size() == 1) return rivalOf(scenario);
    for (const MethodChoice& choice : proposals(subject)) {
        if (fits(choice)) return choice;
    }
    for (const std::string& name : variationNames(subject)) {
        if (fits({name, {}})) return MethodChoice{name, {}};
    }
    return std::nullopt;
}

std::optional<MethodChoice> variedOption(const Scenario& scenario, const std::string& name) {
    const CompareSubject subject = scenario.comparison.subject;
    const std::vector<MethodChoice> all = comparedOf(scenario);
    const MethodChoice plain{name, {}};
    if (!contains(all, subject, plain)) return plain;
    MethodDescription described = describedVariation(subject, plain);
    // Another map comes first, because a method is most often compared over different maps.
    std::stable_partition(described.options.begin(), described.options.end(),
                          [](const OptionDescription& option) { return option.name == kMapOption; });
    for (const OptionDescription& option : described.options) {
        if (option.name == kLayoutOption) continue;  // has no effect on the picture
        for (const std::string& value : otherValues(option, described.defaults.at(option.name))) {
            const MethodChoice choice{name, {{option.name, value}}};
            try {
                checkVariation(subject, choice, {});
            } catch (const InputError&) {
                continue;
            }
            if (!contains(all, subject, choice)) return choice;
        }
    }
    return std::nullopt;
}

Scenario keptApart(const Scenario& before, Scenario after) {
    const CompareSubject shown = after.comparison.subject;
    for (const CompareSubject subject : {CompareSubject::Methods, CompareSubject::Filters, CompareSubject::Mappings}) {
        after.comparison.subject = subject;
        std::vector<MethodChoice>& others = othersOf(after.comparison);
        try {
            const MethodChoice was = ownVariation(before, subject);
            const MethodChoice is = ownVariation(after, subject);
            // If only an option of A changed, A may become equal to another alternative.
            if (was.name == is.name) continue;
            const auto same = std::find_if(others.begin(), others.end(),
                                           [&](const auto& one) { return sameVariation(subject, one, is); });
            if (same == others.end()) continue;
            if (!contains(others, subject, was)) {
                *same = was;
            } else if (const auto next = nextVariation(after)) {
                *same = *next;
            }
        } catch (const InputError&) {
            continue;  // the check of the scenario reports what is wrong with it
        }
    }
    after.comparison.subject = shown;
    return after;
}

std::vector<MethodChoice> rivalsOf(const Scenario& scenario) {
    std::vector<MethodChoice> rivals;
    const auto fits = [&](const MethodChoice& method) {
        return findTracer(method.name).kind == MethodKind::Tracer &&
               !sameVariation(CompareSubject::Methods, method, scenario.method) &&
               supports(method, scenario.surface, scenario.address);
    };
    std::copy_if(scenario.comparison.others.begin(), scenario.comparison.others.end(), std::back_inserter(rivals),
                 fits);
    if (!rivals.empty()) return rivals;
    const MethodChoice exact{"exact", {}};
    if (!promisesExact(scenario.method) && fits(exact)) return {exact};
    for (const MethodChoice& method : proposals(CompareSubject::Methods)) {
        if (!promisesExact(method) && fits(method)) return {method};
    }
    return {exact};
}

MethodChoice rivalOf(const Scenario& scenario) {
    const std::vector<MethodChoice> rivals = rivalsOf(scenario);
    if (!promisesExact(scenario.method)) return rivals.front();
    const auto errs = std::find_if_not(rivals.begin(), rivals.end(), promisesExact);
    if (errs != rivals.end()) return *errs;
    Scenario alone = scenario;
    alone.comparison.others.clear();
    return rivalsOf(alone).front();
}

}  // namespace relief
