// relief certify PICTURE|SCENARIO.json [--map FILE.tif] [--tracer NAME] [--rays N] [--seed S] [-o FILE.json]
#include "certify_engine.h"
#include "measuring/verify/certificate.h"
#include "options_common.h"
#include "output.h"
#include "relief/maps/engine_map.h"
#include "relief/tracers/map_choice.h"
#include "scenario/witness.h"

namespace relief::app {

namespace {

constexpr std::int64_t kRaysAtMost = 1'000'000'000;

struct CertifyOptions {
    ScenarioOptions scenario;
    EngineOptions engine;
    OptionText rays, seed, output;
    RunOptions run;
};

// Returns true if the pixel's ray of the witness scenario shows the violation as well: rounding may have moved it.
bool shows(const Scenario& scenario, const Assets& assets, MapCache& maps, Work& work) {
    const FrameRequest request = frameRequest(scenario, assets);
    const auto ray = pixelRay(request, scenario.pixel->x, scenario.pixel->y);
    if (!ray) return false;
    RayBlock rays(1);
    rays.set(0, *ray);
    HitBlock truth;
    HitBlock found;
    NullSink sink;
    makeTracer({"exact", {}}, request.field, maps, work)->trace(rays, truth, sink, work);
    makeTracer(scenario.method, request.field, maps, work)->trace(rays, found, sink, work);
    return truth[0].outcome == Outcome::Hit &&
           !(found[0].outcome == Outcome::Hit && found[0].lambda <= truth[0].lambda);
}

struct Written {
    const CertifyOptions& options;
    const Scenario& scenario;
    const Assets& assets;
    MapCache& maps;
    Work& work;

    // Returns the lines that tell how to reproduce the ray.
    std::string lines(const Certificate& certificate) const {
        const CounterExample* example = certificate.first     ? &*certificate.first
                                        : certificate.byValue ? &*certificate.byValue
                                                              : nullptr;
        if (example == nullptr) return {};
        std::string text = "  again: " + traceCommand(scenario, example->ray) + options.scenario.mapArgument() +
                           " --steps steps.csv\n";
        if (!options.output) return text;
        const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
        const Scenario seen = witness(scenario, field, example->ray);
        saveScenario(*options.output, seen);
        text += "  scenario: " + *options.output + ", the ray of pixel " + std::to_string(seen.pixel->x) + "," +
                std::to_string(seen.pixel->y);
        // The window builds its own map; a stored map is not part of the scenario.
        if (!options.scenario.mapArgument().empty()) text += " (without the stored map)";
        if (certificate.first && !shows(seen, assets, maps, work))
            text += " (rounded to this pixel, the ray no longer shows the violation)";
        return text + "\n";
    }
};

// Returns true if the map is one that an engine reads. Throws InputError for options that such a map excludes.
bool isForEngine(const CertifyOptions& options) {
    const std::string given = options.engine.given();
    if (!options.scenario.map()) {
        if (!given.empty()) throw InputError(given, Message(MessageId::NeedsArgument, {{"other", "--map"}}));
        return false;
    }
    if (given.empty() && !isEngineMap(*options.scenario.map())) return false;
    for (const auto& [present, name] :
         {std::pair(options.scenario.tracerGiven(), "--tracer"), std::pair(options.output.has_value(), "--output")}) {
        if (present) {
            throw InputError(name,
                             Message(MessageId::ArgumentsExclude, {{"other", "--map " + *options.scenario.map()}}));
        }
    }
    return true;
}

int runCertify(const CertifyOptions& options, Session& session) {
    options.run.apply(session);
    if (options.output) checkOutput(*options.output, {"json"});
    CertificateOptions rayOptions;
    if (options.rays) {
        rayOptions.rays = static_cast<std::uint64_t>(parseWhole(*options.rays, "--rays", 0, kRaysAtMost));
    }
    if (options.seed) rayOptions.seed = parseSeed(*options.seed, "--seed");
    if (isForEngine(options)) return certifyEngineMap(options.scenario, options.engine, rayOptions, session);
    Scenario scenario = options.scenario.scenario();
    refuseOverwriting("--output", options.output.value_or(""), inputFiles(options.scenario, scenario));
    scenario.method = withStoredMap(scenario.method);
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    MapCache maps;
    options.scenario.useStoredMap(scenario, assets, maps, work, true);
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    const Certificate certificate = certify(scenario.method, field, rayOptions, maps, work);
    const std::string again = Written{options, scenario, assets, maps, work}.lines(certificate);
    session.eraseBar();
    writeStandardOutput(certificate.method + " over " + std::to_string(field.width()) + " x " +
                        std::to_string(field.height()) + " texels, " + std::string(surfaceName(field.surface())) +
                        ", " + std::string(addressName(field.address())) + ", relief depth " +
                        numberText(field.reliefDepth()) + "\n" + certificateText(certificate, field) + again);
    if (!certificate.safe()) return kFailed;
    return certificate.proven() ? kDone : kUndecided;
}

}  // namespace

void addCertifyCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<CertifyOptions>();
    CLI::App* parser = addCommand(
        program, "certify", "prove or refute that a map is safe",
        "A map is safe if no ray that is traced with it ends past the first hit, that is, passes through the relief. "
        "Every value of the maps that are made to be safe (euclidean-conservative, refined, cone, cone-robust) is "
        "compared with an exact bound that is computed independently; if no value violates its bound, the map is "
        "proven safe for all rays for which it is valid. In addition, seeded rays that are likely to fail (grazing, "
        "along walls, into walls, at edges) are traced with the method and with exact. Other interpolated maps, and "
        "methods without a map, are checked with these rays only, which can refute safety but not prove it. "
        "A --map for engines, by its description or by options of the group Maps of engines, is certified as a shader "
        "reads it: its numbers are decoded, heights interpolated, cones fetched as told, and the ray steps to the edge "
        "of the cone on the surface below it. Weights are taken in float; that a graphics card's sampler rounds them "
        "is not covered. The picture's own heights are the surface if it has any; then no height map need be given. "
        "The first violation is printed with its ray and "
        "the command that traces it. Methods without a guarantee may end up to half a texel past the hit.\n"
        "Exit status: 0 proven safe, 1 not safe, 2 wrong usage or input, 3 not decided: neither proof nor violation, "
        "or the check could not be carried out.",
        "  relief certify heights.png --tracer cone-dummer -o witness.json\n"
        "  relief certify heights.png --map refined.tif\n"
        "  relief certify --map cone.png\n"
        "  relief certify --map theirs.png --convention relaxed-cone-map --relief-depth 0.05");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::None);
    options->engine.addForReading(*parser);
    addText(*parser, "--rays", options->rays, "N",
            "number of rays compared with exact; 0: only the map's values are checked. Default " +
                std::to_string(CertificateOptions{}.rays),
            "Rays");
    addText(*parser, "--seed", options->seed, "S", "seed of the rays, default 1", "Rays");
    addText(*parser, "-o,--output", options->output, "FILE.json",
            "scenario that shows the first violation in relief render and in the window, as the ray of the chosen "
            "pixel. Written only if there is a violation",
            "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runCertify(*options, session); }, kUndecided});
}

}  // namespace relief::app
