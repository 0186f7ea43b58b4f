// relief map KIND[:OPTION=VALUE...] PICTURE|SCENARIO.json [--set NAME=VALUE ...] (-o FILE.tif | --at s,t,z)
#include <chrono>

#include "map_engine.h"
#include "options_common.h"
#include "output.h"
#include "relief/maps/pyramid_files.h"
#include "relief/tracers/map_choice.h"
#include "relief/tracers/point_distances.h"
#include "scenario/step_sentence.h"

namespace relief::app {

namespace {

struct MapOptions {
    OptionText kind, output, at;
    ScenarioOptions scenario;
    EngineOptions engine;
    RunOptions run;
};

// Prints both distances of a point and the texels that determine them.
int printDistances(const std::string& at, const Scenario& scenario, const HeightField& field, Session& session) {
    constexpr int kDecimals = 3;
    const auto [s, t, z] = parseThree(at, "--at");
    const auto within = [&](const char* what, double value, double high) {
        if (value >= 0 && value <= high) return;
        throw InputError(
            "--at",
            Message(MessageId::OutOfRange,
                    {{"what", what}, {"value", value}, {"range", Message(MessageId::RangeWithin, {{"high", high}})}}));
    };
    within("s", s, field.width());
    within("t", t, field.height());
    within("z", z, 1);
    const auto given = scenario.method.options.find("flattest");
    const double flattest =
        given == scenario.method.options.end() ? DistanceParameters().flattest : parseNumber(given->second, "flattest");
    MapCache cache;
    const PointDistances found = distancesAt(field, s, t, z, flattest, cache, session.work());
    const auto fixed = [&](double value) { return fixedText(value, kDecimals); };
    const auto place = [&](double x, double y, double h) { return fixed(x) + ", " + fixed(y) + ", " + fixed(h); };
    const auto say = [&](const Message& message) { writeStandardOutput(sentence(message, session.language()) + "\n"); };
    session.eraseBar();
    if (found.rays == 0) {
        say(Message(MessageId::PointInside, {{"point", place(s, t, z)}}));
        return 0;
    }
    say(Message(MessageId::PointEuclidean, {{"point", place(s, t, z)},
                                            {"distance", fixed(found.euclidean)},
                                            {"nearest", place(found.s, found.t, found.z)}}));
    const std::vector<MessageValue> rays{{"rays", found.rays}, {"blocked", found.blocked}};
    if (!found.reached) {
        say(Message(MessageId::PointNoRay, rays));
        return 0;
    }
    const ViewRay& ray = found.ray;
    const std::string text = fixed(ray.s0) + "," + fixed(ray.t0) + "," + fixed(ray.a) + "," + fixed(ray.b);
    say(Message(MessageId::PointRefined, {{"distance", fixed(found.refined)},
                                          {"ray", text},
                                          {"hit", place(found.hit.s, found.hit.t, 1 - found.hit.lambda)},
                                          {"rays", found.rays},
                                          {"blocked", found.blocked}}));
    return 0;
}

// Returns the kind without its options; throws InputError if it is unknown.
std::string checkedKind(const std::string& text) {
    const std::string kind = splitMethodChoice(text, "KIND").name;
    if (isListed(mapKinds(), kind) || isListed(pyramidMapKinds(), kind) || isListed(engineOnlyKinds(), kind))
        return kind;
    const std::string known =
        commaList(mapKinds()) + ", " + commaList(pyramidMapKinds()) + ", " + commaList(engineOnlyKinds());
    throw InputError("", unknownName({"what", MessageId::WordMap}, kind, known));
}

// Writes the height pyramid. It depends on the heights alone, so options are refused.
int writePyramid(const MapOptions& options, const std::string& kind, const std::string& output, Session& session) {
    ScenarioOptions chosen = options.scenario;
    chosen.chooseTracer("max-pyramid", kind);
    const Scenario scenario = chosen.scenario();
    for (const auto& [name, text] : scenario.method.options) {
        throw InputError("--set",
                         unknownName({"what", Message(MessageId::WordOptionOf, {{"method", kind}})}, name, {}));
    }
    refuseOverwriting("--output", output, inputFiles(chosen, scenario));
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    const auto begin = std::chrono::steady_clock::now();
    const Pyramid pyramid(pyramidKindOf(kind), assets.heights, work);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    savePyramid(output, pyramid);
    session.eraseBar();
    std::size_t texels = 0;
    for (int l = 0; l < pyramid.levels(); ++l) texels += pyramid.level(l).size();
    writeStandardOutput(kind + ": " + std::to_string(assets.heights->width()) + " x " +
                        std::to_string(assets.heights->height()) + ", " + std::to_string(pyramid.levels()) +
                        " levels, " + std::to_string(texels) + " numbers, built in " + numberText(seconds, 3) + " s\n");
    return 0;
}

int runMap(const MapOptions& options, Session& session) {
    options.run.apply(session);
    const std::string& text = needed(options.kind, "KIND", "map");
    const std::string kind = checkedKind(text);
    const bool isPyramid = isListed(pyramidMapKinds(), kind);
    const bool forEngines = isListed(engineOnlyKinds(), kind);
    if ((isPyramid || kind == "normals" || kind == "heights") && kind != text) {
        const MethodChoice given = splitMethodChoice(text, "KIND");
        throw InputError(text, unknownName({"what", Message(MessageId::WordOptionOf, {{"method", kind}})},
                                           given.options.begin()->first, {}));
    }
    const std::string engineOption = options.engine.given();
    if (options.at && (isPyramid || forEngines || !engineOption.empty())) {
        throw InputError("--at",
                         Message(MessageId::ArgumentsExclude, {{"other", engineOption.empty() ? kind : engineOption}}));
    }
    if (!options.at) {
        const std::string& output = needed(options.output, "--output", "map");
        const std::string ending = fileEnding(output);
        if (forEngines || !engineOption.empty() || ending == "png" || ending == "exr") {
            return writeMapForEngine(kind, text, options.scenario, options.engine, output, session);
        }
        checkOutput(output, {"tif", "tiff", "png", "exr"});
    }
    if (isPyramid) return writePyramid(options, kind, *options.output, session);
    ScenarioOptions chosen = options.scenario;
    chosen.chooseTracer(methodOfMap(kind) + text.substr(kind.size()), text);
    const Scenario scenario = chosen.scenario();
    if (!options.at) refuseOverwriting("--output", *options.output, inputFiles(chosen, scenario));
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    if (options.at) return printDistances(*options.at, scenario, field, session);
    const std::string& output = *options.output;
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
    const std::string kinds = commaList(mapKinds());
    std::string pyramids;
    for (const std::string& kind : pyramidMapKinds()) pyramids += (pyramids.empty() ? "" : " and ") + kind;
    CLI::App* parser = addCommand(
        program, "map", "build a distance map, a cone map or a pyramid and store it",
        "Builds one of the maps that tracers use. FILE.tif is stored for this program: a TIFF that holds all layers in "
        "one picture, with its meaning in the picture's description. The map is valid only for this height map with "
        "this surface, "
        "addressing and depth, and is refused with any other. trace and render read it with --map. The kinds: " +
            kinds + "; each has the options of its tracer (relief list KIND). " + pyramids +
            " are written for other programs, which read them as a picture with MIP levels: tiles of 32-bit floats, "
            "with the heights as level 0; the description of each level defines its texels.\n"
            "FILE.png, FILE.exr, and FILE.tif with an option of the group Maps of engines, are pictures for engines: "
            "by default the height in R and the cone in G. The conventions are written to FILE.json, as in "
            "cone.png.json, and into the picture. If the picture holds heights, the map is built for them as rounded; "
            "values are rounded to the safe side. Conservative cones are then built for shaders that step from the "
            "surface below the ray, however they fetch the cones; relief certify proves it for the picture. "
            "normals and heights (the height map alone) are written for engines only.",
        "  relief map refined:layers=16:precision=u8 heights.png -o refined.tif\n"
        "  relief trace heights.png --tracer distance-refined --map refined.tif --ray 10,20,30,5\n"
        "  relief map refined heights.png --at 10,20,0.6\n"
        "  relief map cone heights.png --bits 8 --unit sqrt-ratio --pack R=height,G=cone,B=normal-x,A=normal-y -o "
        "cone.png");
    addArgument(*parser, "KIND", options->kind,
                "kind of map, with options as KIND:OPTION=VALUE, such as refined:layers=16");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::Heights);
    options->engine.addForWriting(*parser);
    addOutput(*parser, options->output, "file of the map: .tif, or .png, .exr for engines");
    addText(*parser, "--at", options->at, "s,t,z",
            "write no map, but print the distances at this point (texels, texels, height): the Euclidean distance, the "
            "refined distance for rays from above that reach the point, and the ray that determines it",
            "Result");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runMap(*options, session); }});
}

}  // namespace relief::app
