#include "measuring/advise/shader_forms.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>

#include "images/pyramid.h"
#include "relief/maps/engine_builders.h"
#include "relief/tracers/map_choice.h"
#include "scenario/command_text.h"

namespace relief {

namespace {

// A technique; those whose maps take long to build last. loop: the option that limits its loop; empty: its steps depend
// on the ray. For n turns of the loop and b bisections it takes at most n + steps + b steps, and n * each + fetches + b
// fetches.
struct Technique {
    std::string_view tracer, loop;
    ShaderMap map;
    FetchKind kind;
    int steps = 0, each = 0, fetches = 0;
    bool bisects = false;
};
constexpr std::array<Technique, 11> kTechniques{{
    {"offset", "", ShaderMap::Heights, FetchKind::Bilinear, 0, 0, 1},
    {"offset-limited", "", ShaderMap::Heights, FetchKind::Bilinear, 0, 0, 1},
    {"layers", "layers", ShaderMap::Heights, FetchKind::Bilinear, 2, 1, 1},
    {"layers-secant", "layers", ShaderMap::Heights, FetchKind::Bilinear, 3, 1, 1},
    {"layers-bisection", "layers", ShaderMap::Heights, FetchKind::Bilinear, 2, 1, 1, true},
    {"max-pyramid", "", ShaderMap::Maxima, FetchKind::Texels},
    {"cone-robust", "iterations", ShaderMap::SurfaceCones, FetchKind::HeightAndCone, 2, 1, 0},
    {"relaxed-cone", "iterations", ShaderMap::RelaxedCones, FetchKind::HeightAndCone, 2, 1, 1, true},
    {"relaxed-cone-robust", "iterations", ShaderMap::RobustRelaxedCones, FetchKind::HeightAndCone, 2, 1, 1, true},
    {"cone", "", ShaderMap::CellCones, FetchKind::Texels},
    {"distance", "iterations", ShaderMap::Distances, FetchKind::Volume, 2, 2, 0},
}};

constexpr std::int64_t kMostTurns = 256;  // of a loop, where no limit is given
constexpr int kTurnCounts = 4;            // that many, each half of the one before
constexpr int kMostBisections = 8;

const Technique& techniqueOf(const std::string& tracer) {
    return *std::find_if(kTechniques.begin(), kTechniques.end(),
                         [&](const Technique& one) { return one.tracer == tracer; });
}

AdvisedTexture texture(int channels, int bits, MessageId holds, int width, int height, int depth = 1, int levels = 1) {
    return {(channels == 1 ? "R" : "RG") + std::to_string(bits), holds, width, height, depth, levels};
}

DistanceParameters distanceParameters(const ShaderForm& form) {
    DistanceParameters parameters;
    const auto number = [&](const char* name, int& value) {
        const auto given = form.method.options.find(name);
        if (given != form.method.options.end()) value = static_cast<int>(parseNumber(given->second, name));
    };
    number("layers", parameters.layers);
    number("footprint", parameters.footprint);
    return parameters;
}

std::vector<AdvisedTexture> texturesOf(const ShaderForm& form, const HeightField& field) {
    const int w = field.width(), h = field.height(), bits = form.bits;
    switch (form.map) {
        case ShaderMap::Heights:
            return {texture(1, bits, MessageId::TextureHeights, w, h)};
        case ShaderMap::SurfaceCones:
        case ShaderMap::RelaxedCones:
        case ShaderMap::RobustRelaxedCones:
            return {texture(2, bits, MessageId::TextureHeightsCones, w, h)};
        case ShaderMap::CellCones: {
            const ConeShape shape = coneMapShape(ConeKind::Conservative, {}, field);
            return {texture(1, bits, MessageId::TextureHeights, w, h),
                    texture(2, bits, MessageId::TextureApexesCones, shape.nx, shape.ny)};
        }
        case ShaderMap::Maxima: {
            const int levels = static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(w, h) - 1))) + 1;
            const auto whole = [](int side) { return std::has_single_bit(static_cast<unsigned>(side)); };
            if (whole(w) && whole(h)) return {texture(1, bits, MessageId::TextureHeightsMaxima, w, h, 1, levels)};
            // Each level needs room: sides that the smallest level's texels divide.
            const int step = 1 << (levels - 1);
            const auto padded = [&](int side) { return (side + step - 1) / step * step; };
            return {texture(1, bits, MessageId::TextureHeights, w, h),
                    texture(1, bits, MessageId::TextureMaxima, padded(w), padded(h), 1, levels)};
        }
        case ShaderMap::Distances:
            break;
    }
    const DistanceShape shape = distanceMapShape(DistanceKind::Euclidean, distanceParameters(form), field);
    return {texture(1, bits, MessageId::TextureHeights, w, h),
            texture(1, bits, MessageId::TextureDistances, shape.nx, shape.ny, shape.planes)};
}

// The numbers of turns to measure, the largest first.
std::vector<std::int64_t> turnsOf(const Technique& technique, const ShaderAdviceOptions& options, int& bisections) {
    // As many bisections as find the hit to 1/256 of a step, or a third of few steps.
    bisections = 0;
    std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t limit : {options.maxSteps, options.maxFetches}) {
        if (limit > 0) fewest = std::min(fewest, limit);
    }
    if (technique.bisects) bisections = static_cast<int>(std::min<std::int64_t>(kMostBisections, fewest / 3));
    std::int64_t most = kMostTurns;
    if (options.maxSteps > 0) most = std::min(most, options.maxSteps - technique.steps - bisections);
    if (options.maxFetches > 0) {
        most = std::min(most, (options.maxFetches - technique.fetches - bisections) / technique.each);
    }
    most = std::max<std::int64_t>(most, 1);
    std::vector<std::int64_t> all;
    for (int n = 0; n < kTurnCounts && (n == 0 || most >> n > 1); ++n) all.push_back(most >> n);
    return all;
}

EngineConventions conventions(std::string_view kind, const std::string& pack, int bits) {
    EngineConventions c;
    c.kind = kind;
    c.channels = parseEnginePack(pack, "--pack");
    c.bits = bits;
    // Slopes in texture widths: a shader that interpolates them reads what the library's method reads.
    c.cone.unit = ConeUnit::Slope;
    c.cone.length = ConeLength::Width;
    return c;
}

HeightField fieldOf(const EngineMap& map, const HeightField& like) {
    return {std::make_shared<const FloatImage>(*map.heights()), like.surface(), like.address(), like.reliefDepth()};
}

// The cones of a picture as the tracers of one cone per texel read them.
std::shared_ptr<const ConeMap> texelCones(const EngineMap& map, ConeKind kind, const HeightField& field) {
    auto cones = std::make_shared<ConeMap>();
    cones->kind = kind;
    cones->surface = field.surface();
    cones->address = field.address();
    cones->fieldWidth = field.width();
    cones->fieldHeight = field.height();
    UnfilledVector<float> slopes;
    for (const float code : map.channel(EngineRole::Cone)->pixels()) {
        slopes.push_back(
            static_cast<float>(map.conventions.cone.slope(static_cast<double>(code), field.width(), field.height())));
    }
    cones->apex = StoredValues(field.width(), field.height(), 1,
                               {field.heights().pixels().begin(), field.heights().pixels().end()}, Precision::Float,
                               Rounding::Up);
    cones->slopes = StoredValues(field.width(), field.height(), 1, std::move(slopes), Precision::Float, Rounding::Up);
    return cones;
}

}  // namespace

std::vector<ShaderForm> shaderForms(const ShaderAdviceOptions& options, int bits) {
    std::vector<ShaderForm> forms;
    const auto add = [&](const Technique& technique, OptionValues values, std::int64_t turns, int bisections) {
        ShaderForm form;
        form.method = {std::string(technique.tracer), std::move(values)};
        form.map = technique.map;
        form.bits = bits;
        form.fetchKind = technique.kind;
        // Samplers round the weights of texels to 8 bits, so that a fetch between texels guarantees nothing.
        form.guarantee =
            technique.kind == FetchKind::Texels ? findTracer(form.method.name).guarantee : Guarantee::Approximate;
        form.textures = texturesOf(form, options.field);
        if (!technique.loop.empty()) {
            form.bounded = true;
            form.mostSteps = turns + technique.steps + bisections;
            form.mostFetches = turns * technique.each + technique.fetches + bisections;
        }
        forms.push_back(std::move(form));
    };
    for (const Technique& technique : kTechniques) {
        if (!supports({std::string(technique.tracer), {}}, options.field.surface(), options.field.address())) continue;
        if (technique.map == ShaderMap::CellCones) {
            add(technique, {{std::string(kLayoutOption), std::string(kStoredLayout)}}, 0, 0);
            continue;
        }
        if (technique.loop.empty()) {
            add(technique, {}, 0, 0);
            continue;
        }
        int bisections = 0;
        std::vector<OptionValues> volumes{{}};
        if (technique.map == ShaderMap::Distances) volumes.push_back({{"footprint", "2"}, {"layers", "16"}});
        const std::vector<std::int64_t> all = turnsOf(technique, options, bisections);
        for (const OptionValues& volume : volumes) {
            for (const std::int64_t turns : all) {
                OptionValues values = volume;
                values[std::string(technique.loop)] = std::to_string(turns);
                if (technique.bisects) values["bisections"] = std::to_string(bisections);
                add(technique, std::move(values), turns, bisections);
            }
        }
    }
    return forms;
}

ShaderStore shaderStore(const ShaderForm& form, const HeightField& field, Work& work) {
    const auto begun = std::chrono::steady_clock::now();
    const auto heights = [&] {
        return fieldOf(buildEngineNormals(field, conventions("heights", "R=height", form.bits), 1, work), field);
    };
    ShaderStore store{field, std::make_shared<MapCache>()};
    const auto cones = [&](ConeKind kind) {
        const EngineMap map =
            buildEngineCones(kind, {}, field, conventions(coneKindName(kind), "R=height,G=cone", form.bits), 1, work);
        store.field = fieldOf(map, field);
        store.coneScale = map.conventions.cone.scale;
        store.maps->put(coneMapKey(kind, {}, store.field), texelCones(map, kind, store.field));
    };
    switch (form.map) {
        case ShaderMap::Heights:
        case ShaderMap::Maxima:
            store.field = heights();
            break;
        case ShaderMap::SurfaceCones:
            cones(ConeKind::Robust);
            break;
        case ShaderMap::RelaxedCones:
            cones(ConeKind::Relaxed);
            break;
        case ShaderMap::RobustRelaxedCones:
            cones(ConeKind::RelaxedRobust);
            break;
        case ShaderMap::CellCones: {
            store.field = heights();
            const EngineMap map = buildEngineCones(ConeKind::Conservative, {}, store.field,
                                                   conventions("cone", "R=apex,G=cone", form.bits), 1, work);
            store.coneScale = map.conventions.cone.scale;
            store.maps->put(coneMapKey(ConeKind::Conservative, {}, store.field),
                            std::make_shared<const ConeMap>(*cellConesOfEngine(map, store.field, {})));
            break;
        }
        case ShaderMap::Distances: {
            store.field = heights();
            const DistanceParameters parameters = distanceParameters(form);
            const DistanceMap distances = buildDistanceMap(DistanceKind::Euclidean, parameters, store.field, work);
            const EngineMap map =
                buildEngineDistances(distances, store.field, conventions("euclidean", "R=distance", form.bits), work);
            store.maps->put(distanceMapKey(DistanceKind::Euclidean, parameters, store.field),
                            std::make_shared<const DistanceMap>(*distancesOfEngine(map, store.field, {})));
            break;
        }
    }
    store.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return store;
}

ShaderChoice shaderChoiceOf(const ShaderForm& form, Address address, double coneScale) {
    ShaderChoice choice;
    choice.method = form.method;
    choice.address = address;
    choice.interpolation = ShaderInterpolation::Sampler;  // the fetches are counted so
    if (readsCones(form.method.name)) {
        setConeUnit(choice, coneUnitName(ConeUnit::Slope), "--unit");
        choice.cones.length = ConeLength::Width;
        choice.cones.scale = coneScale;
    }
    return choice;
}

void setCommands(ShaderForm& form, const ShaderAdviceOptions& options, double coneScale) {
    const HeightField& field = options.field;
    const std::string ofField = fieldArguments(field.reliefDepth(), field.address(), field.surface());
    const std::string bits = " --bits " + std::to_string(form.bits);
    const std::string coding = " --unit slope --length width" + bits;
    constexpr const char* kHeights = "heights.png";
    form.commands.clear();
    // Other maps are built for the heights as the first texture holds them.
    const auto first = [&](const std::string& kind, const std::string& more, const char* file) {
        form.commands.push_back("relief map " + kind + options.heights + ofField + more + " -o " + file);
    };
    const auto second = [&](const std::string& kind, const std::string& more, const char* file) {
        form.commands.push_back("relief map " + kind + " --height " + kHeights + ofField + more + " -o " + file);
    };
    switch (form.map) {
        case ShaderMap::Heights:
            first("heights", bits, kHeights);
            break;
        case ShaderMap::SurfaceCones:
        case ShaderMap::RelaxedCones:
        case ShaderMap::RobustRelaxedCones:
            // Maps have the names of their tracers.
            first(form.method.name, coding, "relief.png");
            break;
        case ShaderMap::CellCones:
            first("heights", bits, kHeights);
            second("cone", " --pack R=apex,G=cone" + coding, "cones.png");
            break;
        case ShaderMap::Maxima:
            first("heights", bits, kHeights);
            second("max-pyramid", bits, "maxima.png");
            break;
        case ShaderMap::Distances: {
            std::string kind = "euclidean";
            for (const char* const name : {"layers", "footprint"}) {
                const auto given = form.method.options.find(name);
                if (given != form.method.options.end()) kind += ":" + std::string(name) + "=" + given->second;
            }
            first("heights", bits, kHeights);
            second(kind, bits, "distances.png");
            break;
        }
    }
    form.commands.push_back(shaderCommand(shaderChoiceOf(form, field.address(), coneScale)) + " -o relief.frag");
}

std::int64_t fetchesOf(const ShaderForm& form, std::int64_t steps, std::int64_t reads, Outcome outcome) {
    constexpr std::int64_t kBilinear = 4, kCone = 8, kVolume = 12;  // values of a fetch, of a step of two fetches
    switch (form.map) {
        case ShaderMap::Heights:
            return techniqueOf(form.method.name).loop.empty() ? 1 : reads / kBilinear;
        case ShaderMap::SurfaceCones:
            // The last height was fetched with its cone.
            return (reads + kBilinear) / kCone;
        case ShaderMap::RelaxedCones:
        case ShaderMap::RobustRelaxedCones:
            // One for each step but the start; and whether the last step ended below the surface.
            return std::min(steps, form.mostFetches);
        case ShaderMap::Distances:
            return 2 * (reads / kVolume) + (reads % kVolume) / kBilinear;
        case ShaderMap::CellCones: {
            // Each cell costs one fetch, and four more where its patch is tested; the method reads one value, and one
            // more to advance or four to test.
            const std::int64_t cells = steps - 1 - (outcome == Outcome::Miss ? 1 : 0);
            return cells + 4 * std::max<std::int64_t>((reads - 2 * cells) / 3, 0);
        }
        case ShaderMap::Maxima:
            break;
    }
    return 0;
}

std::int64_t pyramidFetches(std::span<const Step> steps) {
    std::int64_t fetches = 1;
    for (const Step& step : steps) {
        constexpr int kMaximum = 4, kPatch = 4;
        switch (step.decision) {
            case Decision::Skip:
            case Decision::Descend:
                fetches += kMaximum;
                break;
            case Decision::Test:
            case Decision::Hit:
                fetches += kMaximum + kPatch;
                break;
            default:
                break;
        }
    }
    return fetches;
}

}  // namespace relief
