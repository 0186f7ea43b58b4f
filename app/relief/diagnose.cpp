// relief diagnose PICTURE|SCENARIO.json --rays FILE.csv (--hits FILE.csv | --steps FILE.csv|json) [--picture FILE]
//     [-o FILE.json]
#include "measuring/diagnose/diagnose.h"

#include <cmath>

#include "json_line.h"
#include "measuring/diagnose/error_picture.h"
#include "measuring/diagnose/tracer_files.h"
#include "options_common.h"
#include "output.h"
#include "scenario/ray_files.h"

namespace relief::app {

namespace {

struct DiagnoseOptions {
    ScenarioOptions scenario;
    OptionText rays, hits, steps, picture, output;
    bool json = false;
    RunOptions run;
};

// Reads what the tracer did. Throws InputError.
TracerRecord recordOf(const DiagnoseOptions& options, const HeightField& field) {
    const std::string& raysFile = needed(options.rays, "--rays", "diagnose");
    TracerRecord record;
    record.rays = parseRays(readTextFile(raysFile), raysFile);
    const std::size_t rays = record.rays.size();
    if (rays == 0) throw InputError(raysFile, Message(MessageId::RaysMissing));
    if (!options.hits && !options.steps) {
        throw InputError("", Message(MessageId::NeedsEither, {{"other", "--hits"}, {"another", "--steps"}}));
    }
    if (options.steps) {
        RayFiles files;
        files.rays = std::move(record.rays);
        files.log = parseSteps(readTextFile(*options.steps), *options.steps, rays);
        record = tracerRecord(std::move(files), field, *options.steps);
    }
    if (!options.hits) return record;
    record.hits = parseHits(readTextFile(*options.hits), *options.hits);
    if (record.hits.size() != rays) {
        throw InputError(*options.hits, Message(MessageId::HitsCount,
                                                {{"count", record.hits.size()}, {"file", raysFile}, {"rays", rays}}));
    }
    return record;
}

struct Report {
    const DiagnoseOptions& options;
    const Scenario& scenario;
    const HeightField& field;
    const TracerRecord& record;
    const std::optional<RaysView>& view;

    Message nameOf(std::size_t ray) const {
        if (!view) return Message(MessageId::DiagnosisRay, {{"ray", ray}});
        const PixelChoice pixel = view->pixels[ray];
        return Message(MessageId::DiagnosisPixel, {{"ray", ray}, {"x", pixel.x}, {"y", pixel.y}});
    }

    void writePicture(const Diagnosis& diagnosis) const {
        if (!view) return writeColor(*options.picture, errorPicture(field, record.rays, diagnosis.errors));
        writeColor(*options.picture,
                   errorPicture(view->scenario.width, view->scenario.height, view->pixels, diagnosis.errors));
    }

    // Returns the scenario with the ray as its chosen pixel.
    Scenario sceneOf(std::size_t ray) const { return sceneOfRay(scenario, field, record.rays, view, ray); }

    // Writes the scenario of the worst ray of the first fault, with a bookmark for each fault.
    void writeScene(const Diagnosis& diagnosis) const {
        const std::size_t worst = diagnosis.findings.empty() ? diagnosis.worst : diagnosis.findings.front().worst;
        Scenario scene = sceneOf(worst);
        for (const Finding& finding : diagnosis.findings) {
            const Scenario one = sceneOf(finding.worst);
            scene.bookmarks.push_back({std::string(faultName(finding.fault.fault)), *one.pixel, one.camera, 0});
        }
        if (options.steps) scene.other = {*options.rays, *options.steps, static_cast<int>(worst), true};
        saveScenario(*options.output, scene);
    }

    std::string json(const Diagnosis& diagnosis, Language language) const {
        const auto rayJson = [&](std::size_t r) {
            const ViewRay ray = record.rays[r];
            Json json{{"number", r}, {"ray", {ray.s0, ray.t0, ray.a, ray.b}}};
            if (view) json["pixel"] = {view->pixels[r].x, view->pixels[r].y};
            // JSON has no infinity: the outcome differs.
            const double error = diagnosis.errors[r];
            json["error_texels"] = std::isfinite(error) ? Json(error) : Json();
            return json;
        };
        Json json{{"verdict", diagnosis.healthy()          ? "no fault"
                              : diagnosis.findings.empty() ? "unknown"
                                                           : "faults"},
                  {"rays", diagnosis.rays},
                  {"wrong", diagnosis.wrong},
                  {"barely_touching", diagnosis.touching},
                  {"unexplained", diagnosis.unexplained}};
        if (!diagnosis.healthy()) json["worst"] = rayJson(diagnosis.worst);
        json["faults"] = Json::array();
        for (const Finding& finding : diagnosis.findings) {
            const Fault fault = finding.fault.fault;
            json["faults"].push_back(
                {{"fault", faultName(fault)},
                 {"value", finding.fault.value != 0 ? Json(finding.fault.value) : Json()},
                 {"rays", finding.rays},
                 {"share", static_cast<double>(finding.rays) / static_cast<double>(diagnosis.rays)},
                 {"worst", rayJson(finding.worst)},
                 {"cause", sentence(faultCause(fault), language)},
                 {"cure", sentence(faultCure(fault), language)}});
        }
        return json.dump(2) + "\n";
    }
};

void refuseOwnInputs(const DiagnoseOptions& options, const Scenario& scenario) {
    std::vector<std::string> inputs = inputFiles(options.scenario, scenario);
    for (const OptionText& file : {options.rays, options.hits, options.steps}) inputs.push_back(file.value_or(""));
    inputs.push_back(raysViewPath(*options.rays));
    refuseOverwriting("--picture", options.picture.value_or(""), inputs);
    refuseOverwriting("--output", options.output.value_or(""), inputs);
}

int runDiagnose(const DiagnoseOptions& options, Session& session) {
    options.run.apply(session);
    if (options.picture) checkOutput(*options.picture, {"png", "tif", "tiff", "bmp", "exr"});
    if (options.output) checkOutput(*options.output, {"json"});
    const std::string& raysFile = needed(options.rays, "--rays", "diagnose");
    // Without a height map, that of the view by which the rays were exported.
    const OptionText file =
        options.scenario.heightsGiven() ? options.scenario.file() : OptionText(raysViewPath(raysFile));
    Scenario scenario = options.scenario.scenario(file);
    refuseOwnInputs(options, scenario);
    scenario.pictures.color.clear();
    scenario.pictures.normal.clear();
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    noteHeights(session, assets, scenario);
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    const TracerRecord record = recordOf(options, field);
    const std::optional<RaysView> view = readRaysView(raysFile, record.rays.size());
    const Diagnosis diagnosis = diagnose(record, field, work);
    const Report report{options, scenario, field, record, view};
    if (options.picture) report.writePicture(diagnosis);
    if (options.output && !diagnosis.healthy()) report.writeScene(diagnosis);
    std::string text;
    if (options.json) {
        text = report.json(diagnosis, session.language());
    } else {
        for (const Message& line : diagnosisLines(diagnosis, [&](std::size_t ray) { return report.nameOf(ray); })) {
            text += sentence(line, session.language()) + "\n";
        }
    }
    session.eraseBar();
    writeStandardOutput(text, session.stop());
    if (diagnosis.healthy()) return kDone;
    return diagnosis.findings.empty() ? kUndecided : kFailed;
}

}  // namespace

void addDiagnoseCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<DiagnoseOptions>();
    const std::string names = commaList({kFaultNames.begin(), kFaultNames.end()});
    CLI::App* parser = addCommand(
        program, "diagnose", "name what is wrong with somebody's tracer",
        "Compares the answers of any tracer, such as a shader, with exact, and names its faults: one line for each, "
        "the one that makes most rays wrong first. A line begins with the name of the fault and holds the share of "
        "rays, "
        "the likely cause, the cure, and the worst ray. Faults: " +
            names +
            ". A line that begins with unknown says how many rays are wrong for another reason. Answers up to 1/32 "
            "texel off are right, and so are those that differ because the ray barely touches the surface.\n"
            "relief export rays writes rays of a view; the tracer writes its hits, in the order of the rays, with a "
            "header that begins with outcome,lambda (see relief trace).\n"
            "Exit status: 0 no fault, 1 faults named, 2 wrong usage or input, 3 wrong answers for an unknown reason.",
        "  relief export rays heights.png --size 400x300 -o rays.csv\n"
        "  relief diagnose heights.png --rays rays.csv --hits hits.csv --picture errors.png -o worst.json");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::HeightsOnly);
    addText(*parser, "--rays", options->rays, "FILE.csv",
            "rays with the header s0,t0,a,b. FILE.json beside it, written by relief export rays, names their pixels; "
            "without a height map, it also names that",
            "Tracer");
    addText(*parser, "--hits", options->hits, "FILE.csv",
            "answer of the tracer to each ray: outcome (hit, miss, limit), lambda; then, if they are known, s, t and "
            "steps; other columns are ignored",
            "Tracer");
    addText(*parser, "--steps", options->steps, "FILE.csv|json",
            "steps of some or all rays, as relief trace --steps writes them; without --hits, of all rays", "Tracer");
    addText(*parser, "--picture", options->picture, "FILE",
            "picture of the errors: .png, .tif, .bmp or .exr. Grey: right; blue (1/32 texel) to red (64 texels and "
            "more): the error on a logarithmic scale; magenta: another outcome. Of the view, or, if it is not known, "
            "over the map, where the rays enter",
            "Output");
    addText(*parser, "-o,--output", options->output, "FILE.json",
            "scenario that shows the worst ray of the first fault, with a bookmark for each fault; written only if "
            "there is a fault",
            "Output");
    addFlag(*parser, "--json", options->json, "JSON instead of text", "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runDiagnose(*options, session); }, kUndecided});
}

}  // namespace relief::app
