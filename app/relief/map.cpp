// relief map KIND --height FILE [--set NAME=VALUE ...] -o FILE.tif
#include <chrono>

#include "options_common.h"
#include "output.h"
#include "relief/maps/map_choice.h"

namespace relief::app {

namespace {

struct MapOptions {
    OptionText kind, output;
    ScenarioOptions scenario;
    RunOptions run;
};

int runMap(const MapOptions& options, Session& session) {
    options.run.apply(session);
    const std::string& kind = needed(options.kind, "KIND", "map");
    const std::string& output = needed(options.output, "--output", "map");
    checkOutput(output, {"tif", "tiff"});
    ScenarioOptions chosen = options.scenario;
    chosen.chooseTracer(methodOfMap(kind));
    const Scenario scenario = chosen.scenario();
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    MapCache maps;
    const auto begin = std::chrono::steady_clock::now();
    const StoredMap map = buildMap(kind, scenario.method.options, field, maps, work);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    saveMap(output, map, field.heights());
    session.eraseBar();
    constexpr int kDigits = 3;
    writeStandardOutput(kind + ": " + mapSizeText(map) + ", " + std::to_string(mapBytes(map)) + " bytes, built in " +
                        numberText(seconds, kDigits) + " s\n");
    return 0;
}

}  // namespace

void addMapCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<MapOptions>();
    std::string kinds;
    for (const std::string& kind : mapKinds()) kinds += (kinds.empty() ? "" : ", ") + kind;
    CLI::App* parser = addCommand(
        program, "map", "build a distance or cone map and store it",
        "Builds one of the maps that methods walk and writes it as a TIFF: all layers in one picture, the numbers as "
        "they are, and what they mean in its description. It serves this height map with this surface, addressing and "
        "depth, and is refused anywhere else. trace and render take it by --map. The kinds: " +
            kinds + "; each has the options of its tracer (relief list shows them).",
        "  relief map refined --height heights.png --set layers=16 --set precision=u8 -o refined.tif\n"
        "  relief trace --height heights.png --tracer distance-refined --map refined.tif --ray 10,20,30,5");
    addArgument(*parser, "KIND", options->kind, "which map");
    options->scenario.add(*parser, ScenarioOptions::Look::Heights);
    addOutput(*parser, options->output, "the map: .tif");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runMap(*options, session); }});
}

}  // namespace relief::app
