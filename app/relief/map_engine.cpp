#include "map_engine.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "output.h"
#include "relief/maps/engine_builders.h"
#include "relief/maps/pyramid_files.h"
#include "relief/tracers/map_choice.h"

namespace relief::app {

namespace {

enum class Group : std::uint8_t { Cones, Distances, Pyramid, Normals, Heights };

constexpr const char* kHeightsKind = "heights";

std::optional<ConeKind> coneKindOf(const std::string& kind) {
    for (int k = 0; k < kConeKinds; ++k) {
        if (coneKindName(static_cast<ConeKind>(k)) == kind) return static_cast<ConeKind>(k);
    }
    return std::nullopt;
}

Group groupOf(const std::string& kind) {
    if (kind == kHeightsKind) return Group::Heights;
    if (isListed(engineOnlyKinds(), kind)) return Group::Normals;
    if (isListed(pyramidMapKinds(), kind)) return Group::Pyramid;
    return coneKindOf(kind) ? Group::Cones : Group::Distances;
}

std::vector<EngineRole> defaultChannels(Group group) {
    switch (group) {
        case Group::Cones:
            return {EngineRole::Height, EngineRole::Cone};
        case Group::Distances:
            return {EngineRole::Distance};
        case Group::Pyramid:
        case Group::Heights:
            return {EngineRole::Height};
        case Group::Normals:
            break;
    }
    return {EngineRole::NormalX, EngineRole::NormalY, EngineRole::NormalZ};
}

void checkChannels(const std::string& kind, Group group, const std::vector<EngineRole>& channels) {
    const auto allowed = [&](EngineRole role) {
        const bool height = role == EngineRole::Height || role == EngineRole::Depth;
        const bool normal = role >= EngineRole::NormalX;
        switch (group) {
            case Group::Cones:
                return height || normal || role == EngineRole::Cone || (role == EngineRole::Apex && kind == "cone");
            case Group::Distances:
                return role == EngineRole::Distance;
            case Group::Pyramid:
            case Group::Heights:
                return height;
            case Group::Normals:
                break;
        }
        return height || normal;
    };
    for (const EngineRole role : channels) {
        if (role == EngineRole::Zero || allowed(role)) continue;
        throw InputError("--pack", Message(MessageId::EngineRoleNotOfKind,
                                           {{"kind", kind}, {"role", std::string(engineRoleName(role))}}));
    }
    const std::vector<EngineRole> defaults = defaultChannels(group);
    const bool fits =
        group == Group::Cones ? packs(channels, EngineRole::Cone)
        : group == Group::Normals
            ? std::any_of(channels.begin(), channels.end(), [](EngineRole r) { return r >= EngineRole::NormalX; })
            : std::any_of(channels.begin(), channels.end(), [](EngineRole r) { return r != EngineRole::Zero; });
    if (!fits) {
        throw InputError(
            "--pack",
            Message(
                MessageId::EngineNeedsRole,
                {{"role", std::string(engineRoleName(group == Group::Cones ? EngineRole::Cone : defaults.front()))}}));
    }
    // A cell map has its own size: heights and normals of texels do not fit it.
    if (packs(channels, EngineRole::Apex)) {
        for (const EngineRole role : channels) {
            if (role == EngineRole::Zero || role == EngineRole::Apex || role == EngineRole::Cone) continue;
            throw InputError("--pack", Message(MessageId::ArgumentsExclude, {{"other", "apex"}}));
        }
    }
}

// Returns true if the scale of the cones follows from the map: integers must reach its steepest slope.
bool scalesToMap(const EngineConventions& c) {
    return packs(c.channels, EngineRole::Cone) && c.cone.unit == ConeUnit::Slope && c.bits != 32;
}

EngineConventions conventionsOf(const std::string& kind, Group group, const EngineOptions& engine,
                                const std::string& output) {
    EngineConventions c;
    c.kind = kind;
    c.channels = defaultChannels(group);
    const std::string ending = fileEnding(output);
    c.bits = ending == "exr" ? 32 : 16;
    engine.apply(c);
    c.relaxed = group == Group::Cones && areRelaxed(*coneKindOf(kind));
    if (ending == "exr" && c.bits != 32) {
        throw InputError("--bits", Message(MessageId::EngineBits, {{"ending", ".exr"}, {"known", "32 (float)"}}));
    }
    if (ending == "png" && c.bits == 32) {
        throw InputError("--bits", Message(MessageId::EngineBits, {{"ending", ".png"}, {"known", "8, 16"}}));
    }
    checkChannels(kind, group, c.channels);
    if (engine.scaleGiven() && scalesToMap(c)) {
        throw InputError("--cone-scale", Message(MessageId::ArgumentsExclude,
                                                 {{"other", "--unit slope --bits " + std::to_string(c.bits)}}));
    }
    return c;
}

// Options of the method that an engine's map does not have.
void checkOptions(const std::string& kind, Group group, const OptionValues& options) {
    for (const auto& [name, text] : options) {
        if (group == Group::Pyramid || group == Group::Normals || group == Group::Heights) {
            throw InputError("--set",
                             unknownName({"what", Message(MessageId::WordOptionOf, {{"method", kind}})}, name, {}));
        }
        const bool ofCells = kind == "cone" && !(name == "sectors" && text == "1");
        if (name == "precision" || ofCells) {
            throw InputError("--set " + name, Message(MessageId::ArgumentsExclude, {{"other", "--bits, --pack"}}));
        }
    }
}

ConeParameters coneParameters(const OptionValues& options) {
    ConeParameters parameters;
    const auto number = [&](const char* name, int& value) {
        const auto given = options.find(name);
        if (given != options.end()) value = static_cast<int>(parseNumber(given->second, "--set"));
    };
    number("radius", parameters.radius);
    number("directions", parameters.directions);
    return parameters;
}

EngineMap built(const std::string& kind, Group group, const Scenario& scenario, const HeightField& field,
                const EngineConventions& c, int levels, Work& work) {
    switch (group) {
        case Group::Cones:
            return buildEngineCones(*coneKindOf(kind), coneParameters(scenario.method.options), field, c, levels, work);
        case Group::Normals:
        case Group::Heights:
            return buildEngineNormals(field, c, levels, work);
        case Group::Pyramid:
            return buildEnginePyramid(pyramidKindOf(kind), field, c, work);
        case Group::Distances:
            break;
    }
    MapCache maps;
    const StoredMap map = buildMap(kind, scenario.method.options, field, maps, work);
    return buildEngineDistances(*std::get<std::shared_ptr<const DistanceMap>>(map), field, c, work);
}

// The options of the shader that follow from the map, for the line that the command writes.
std::string shaderOptions(const EngineConventions& c) {
    if (!scalesToMap(c)) return "";
    return "; relief export shader: --unit slope --length " + std::string(coneLengthName(c.cone.length)) +
           " --cone-scale " + numberText(c.cone.scale);
}

// Says how many cones have no width.
void noteStalled(const EngineMap& map, const std::string& output, Session& session) {
    const FloatImage* cones = map.channel(EngineRole::Cone);
    if (cones == nullptr) return;
    std::size_t stalled = 0;
    for (const float code : cones->pixels()) {
        if (map.conventions.cone.stalls(code)) ++stalled;
    }
    if (stalled == 0) return;
    session.note(output, Message(MessageId::EngineStalls, {{"count", stalled}, {"all", cones->size()}}));
}

}  // namespace

const std::vector<std::string>& engineOnlyKinds() {
    static const std::vector<std::string> kinds{"normals", kHeightsKind};
    return kinds;
}

int writeMapForEngine(const std::string& kind, const std::string& text, const ScenarioOptions& scenarioOptions,
                      const EngineOptions& engine, const std::string& output, Session& session) {
    checkOutput(output, {"png", "exr", "tif", "tiff"});
    const Group group = groupOf(kind);
    const EngineConventions conventions = conventionsOf(kind, group, engine, output);
    ScenarioOptions chosen = scenarioOptions;
    const bool ofMethod = group == Group::Cones || group == Group::Distances;
    chosen.chooseTracer(ofMethod ? methodOfMap(kind) + text.substr(kind.size()) : "max-pyramid", text);
    const Scenario scenario = chosen.scenario();
    const std::vector<std::string> inputs = inputFiles(chosen, scenario);
    refuseOverwriting("--output", output, inputs);
    refuseOverwriting("--output", output, inputs, engineSidecar(output));
    checkOptions(kind, group, scenario.method.options);
    if (group == Group::Cones && scenario.surface == Surface::Columns && (kind == "cone" || kind == "cone-robust") &&
        !packs(conventions.channels, EngineRole::Apex)) {
        throw InputError("--surface", Message(MessageId::EngineColumns));
    }
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    const bool ofCells = packs(conventions.channels, EngineRole::Apex);
    if (engine.mipsGiven() && (ofCells || group == Group::Distances || group == Group::Pyramid)) {
        throw InputError("--mips", Message(MessageId::ArgumentsExclude, {{"other", ofCells ? "apex" : kind}}));
    }
    const int levels = engine.mips(field.width(), field.height());
    const auto begin = std::chrono::steady_clock::now();
    const EngineMap map = built(kind, group, scenario, field, conventions, levels, work);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    writeEngineMap(output, map);
    session.eraseBar();
    noteStalled(map, output, session);
    const EngineConventions& c = map.conventions;
    const FloatImage& first = map.levels.front().channels.front();
    constexpr int kDigits = 3;
    writeStandardOutput(kind + ": " + std::to_string(first.width()) + " x " + std::to_string(first.height()) + ", " +
                        std::to_string(map.levels.size()) + (map.levels.size() == 1 ? " level, " : " levels, ") +
                        enginePackText(c.channels) + ", " + engineBitsText(c.bits) + ", built in " +
                        numberText(seconds, kDigits) + " s" + shaderOptions(c) + "; conventions in " +
                        engineSidecar(output) + "\n");
    return kDone;
}

}  // namespace relief::app
