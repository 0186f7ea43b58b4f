#include "relief/tracers/map_choice.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/for_each_type.h"
#include "relief/methods/cone.h"
#include "relief/methods/cone_dummer.h"
#include "relief/methods/cone_robust.h"
#include "relief/methods/distance.h"
#include "relief/methods/distance_conservative.h"
#include "relief/methods/distance_refined.h"
#include "relief/methods/distance_refined_sampled.h"
#include "relief/methods/relaxed_cone.h"
#include "relief/methods/relaxed_cone_robust.h"
#include "relief/tracers.h"

namespace relief {

namespace {

using MapTracers =
    std::tuple<DistanceTracer, DistanceConservativeTracer, DistanceRefinedSampledTracer, DistanceRefinedTracer,
               ConeTracer, ConeDummerTracer, ConeRobustTracer, RelaxedConeTracer, RelaxedConeRobustTracer>;

// A map parameter as an option's text, and its text in maps of kinds that do not use it.
struct ParameterText {
    std::string name;
    std::string text;
    std::string unused;
};

std::vector<ParameterText> parameterTexts(const DistanceMap& map) {
    const DistanceParameters& p = map.parameters;
    const DistanceParameters unused;
    return {{"footprint", std::to_string(p.footprint), std::to_string(unused.footprint)},
            {"layers", std::to_string(p.layers), std::to_string(unused.layers)},
            {"flattest", numberText(p.flattest), numberText(unused.flattest)},
            {"horizons", std::to_string(p.horizons), std::to_string(unused.horizons)},
            {"sectors", std::to_string(p.sectors), std::to_string(unused.sectors)},
            {"directions", std::to_string(p.directions), std::to_string(unused.directions)},
            {"precision", std::string(precisionName(p.precision)), std::string(precisionName(unused.precision))},
            {"to", std::string(distanceToName(p.to)), std::string(distanceToName(unused.to))}};
}

std::vector<ParameterText> parameterTexts(const ConeMap& map) {
    const ConeParameters& p = map.parameters;
    const ConeParameters unused;
    // Maps of the packed layout are not stored in files.
    return {{std::string(kLayoutOption), std::string(kStoredLayout), std::string(kStoredLayout)},
            {"sectors", std::to_string(p.sectors), std::to_string(unused.sectors)},
            {"radius", std::to_string(p.radius), std::to_string(unused.radius)},
            {"directions", std::to_string(p.directions), std::to_string(unused.directions)},
            {"precision", std::string(precisionName(p.precision)), std::string(precisionName(unused.precision))}};
}

std::vector<ParameterText> parameterTexts(const StoredMap& map) {
    return std::visit([](const auto& m) { return parameterTexts(*m); }, map);
}

// The option prefix of the method that walks such maps: empty for the method itself, kInnerPrefix for the one inside
// it; std::nullopt if neither does. Adds the kinds that they walk to `accepted`.
std::optional<std::string> prefixOfWalker(const MethodChoice& choice, const std::string& kind, std::string& accepted) {
    const MethodDescription& method = findTracer(choice.name);
    if (isListed(method.maps, kind) || isListed(method.otherMaps, kind)) return "";
    for (const auto* const maps : {&method.maps, &method.otherMaps}) {
        for (const std::string& map : *maps) accepted += (accepted.empty() ? "" : ", ") + map;
    }
    if (const auto inner = innerMethod(choice)) {
        if (const auto prefix = prefixOfWalker(*inner, kind, accepted)) return std::string(kInnerPrefix) + *prefix;
    }
    return std::nullopt;
}

bool sameValue(OptionKind kind, const std::string& a, const std::string& b) {
    if (a == b) return true;
    const bool number = kind == OptionKind::Integer || kind == OptionKind::Real;
    return number && parseNumber(a, "--set") == parseNumber(b, "--set");
}

}  // namespace

bool isListed(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<std::string>& mapKinds() {
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> all;
        forEachType<MapTracers>([&]<class T>() { all.push_back(T::describe().maps.front()); });
        return all;
    }();
    return kinds;
}

std::optional<MethodChoice> innerMethod(const MethodChoice& choice) {
    const MethodDescription& method = findTracer(choice.name);
    for (const OptionDescription& option : method.options) {
        if (option.kind != OptionKind::Method) continue;
        const auto given = choice.options.find(option.name);
        MethodChoice inner{given == choice.options.end() ? method.defaults.at(option.name) : given->second, {}};
        for (const auto& [name, text] : choice.options) {
            if (name.starts_with(kInnerPrefix)) inner.options[name.substr(kInnerPrefix.size())] = text;
        }
        return inner;
    }
    return std::nullopt;
}

std::optional<UsedMap> usedMap(const MethodChoice& choice) {
    const MethodDescription& method = findTracer(choice.name);
    for (const std::string& kind : mapKinds()) {
        if (!isListed(method.maps, kind)) continue;
        UsedMap used{kind, choice.options};
        used.options.insert(method.defaults.begin(), method.defaults.end());
        const auto other = used.options.find(std::string(kMapOption));
        if (other != used.options.end()) used.kind = other->second;
        return used;
    }
    const auto inner = innerMethod(choice);
    return inner ? usedMap(*inner) : std::nullopt;
}

MethodChoice withStoredMap(const MethodChoice& choice) {
    MethodChoice stored = choice;
    for (const ChoiceOption& option : choiceOptions(choice)) {
        const std::string& name = option.description.name;
        if (name == kLayoutOption || name.ends_with("." + std::string(kLayoutOption))) {
            stored.options.emplace(name, kStoredLayout);
        }
    }
    return stored;
}

const std::string& methodOfMap(const std::string& kind) {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        forEachType<MapTracers>([&]<class T>() { all.push_back(T::describe().name); });
        return all;
    }();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (mapKinds()[i] == kind) return names[i];
    }
    throw InputError("", unknownName({"what", MessageId::WordMap}, kind, commaList(mapKinds())));
}

StoredMap buildMap(const std::string& kind, const OptionValues& options, const HeightField& field, MapCache& cache,
                   Work& work) {
    const std::string& method = methodOfMap(kind);
    OptionValues own = options;
    own.erase(std::string(kMapOption));
    checkMethod({method, own}, {});
    StoredMap map;
    forEachType<MapTracers>([&]<class T>() {
        if (T::describe().name != method) return;
        const auto parsed = parseOptions<typename T::Options>(method, own);
        if constexpr (requires { T::makeMap(field, parsed, cache, work); }) {
            map = T::makeMap(field, parsed, cache, work);
        } else if constexpr (requires(const T& tracer) { tracer.distanceMap(); }) {
            map = T::make(field, parsed, cache, work).distanceMap();
        } else {
            map = T::make(field, parsed, cache, work).coneMap();
        }
    });
    return map;
}

namespace {

// Returns true if the map's tracer has options that build a map with these parameters.
bool buildable(const StoredMap& map) {
    const MethodDescription& method = findTracer(methodOfMap(mapKindName(map)));
    for (const ParameterText& parameter : parameterTexts(map)) {
        const auto option = std::find_if(method.options.begin(), method.options.end(),
                                         [&](const OptionDescription& o) { return o.name == parameter.name; });
        try {
            if (option != method.options.end()) {
                checkOption(*option, parameter.text);
            } else if (parameter.text != parameter.unused) {
                return false;
            }
        } catch (const InputError&) {
            return false;
        }
    }
    return true;
}

}  // namespace

StoredMap loadMap(const std::string& path, const HeightField& field, std::size_t maxBytes, Work& work) {
    return readStoredMap(path, field, maxBytes, &buildable, work);
}

MethodChoice useMap(const std::string& path, const StoredMap& map, const MethodChoice& choice, const HeightField& field,
                    MapCache& cache) {
    const std::string kind = mapKindName(map);
    std::string accepted;
    const auto prefix = prefixOfWalker(choice, kind, accepted);
    if (!prefix) {
        const MessageId why = accepted.empty() ? MessageId::MapForNoWalker : MessageId::MapNotForMethod;
        throw InputError(path, Message(why, {{"method", choice.name}, {"wanted", accepted}, {"given", kind}}));
    }
    MethodChoice chosen = choice;
    const std::string mapOption = *prefix + std::string(kMapOption);
    for (const ChoiceOption& option : choiceOptions(choice)) {
        if (option.description.name != mapOption) continue;
        const auto [given, added] = chosen.options.emplace(mapOption, kind);
        if (given->second == kind) break;
        throw InputError(path, Message(MessageId::MapNotForMethod,
                                       {{"method", choice.name}, {"wanted", given->second}, {"given", kind}}));
    }
    for (const OptionDescription& option : findTracer(methodOfMap(kind)).options) {
        for (const ParameterText& parameter : parameterTexts(map)) {
            if (parameter.name != option.name) continue;
            const auto [given, added] = chosen.options.emplace(*prefix + option.name, parameter.text);
            if (added || sameValue(option.kind, given->second, parameter.text)) continue;
            throw InputError(path,
                             Message(MessageId::MapNotOfThisField,
                                     {{"what", option.name}, {"stored", parameter.text}, {"given", given->second}}));
        }
    }
    if (const auto* distances = std::get_if<std::shared_ptr<const DistanceMap>>(&map)) {
        cache.put(distanceMapKey((*distances)->kind, (*distances)->parameters, field), *distances);
    } else {
        const auto& cones = std::get<std::shared_ptr<const ConeMap>>(map);
        cache.put(coneMapKey(cones->kind, cones->parameters, field), cones);
    }
    return chosen;
}

}  // namespace relief
