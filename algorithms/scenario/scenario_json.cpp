#include <algorithm>
#include <filesystem>

#include "relief/reliefs.h"
#include "scenario/json_reader.h"
#include "scenario/row_methods.h"
#include "scenario/scenario_checks.h"

namespace relief {

namespace {

using Reader = JsonReader;

std::string relativeTo(const std::string& path, const std::string& folder) {
    if (path.empty() || folder.empty()) return path;
    const std::filesystem::path relative =
        std::filesystem::absolute(path).lexically_relative(std::filesystem::absolute(folder));
    const std::string text = relative.generic_string();
    // Paths outside the folder are stored as absolute, since "../" would break as soon as the file is moved.
    return text.empty() || text.starts_with("..") ? std::filesystem::absolute(path).string() : text;
}

std::string resolved(const std::string& path, const std::filesystem::path& folder) {
    const bool relative = !path.empty() && !folder.empty() && std::filesystem::path(path).is_relative();
    return relative ? (folder / path).lexically_normal().string() : path;
}

// Maximum nesting of the window's state, which is written unchanged by a library that recurses.
constexpr int kWindowDepth = 32;

bool withinDepth(const Json& json, int depth) {
    if (!json.is_structured()) return true;
    return depth > 0 && std::all_of(json.begin(), json.end(), [&](const Json& j) { return withinDepth(j, depth - 1); });
}

// Each row of heights is a text, so that it is readable in the file; one row is a profile.
void readDrawn(Reader reader, DrawnRelief& drawn) {
    reader.readWhole("width", drawn.width);
    reader.readWhole("height", drawn.height);
    reader.readTexts("rows", [&](const std::string& row) {
        for (const double height : parseDrawnNumbers(row, "rows")) drawn.heights.push_back(height);
    });
    if (drawn.empty()) reader.fail("rows", MessageId::WantRows);
    reader.finish();
}

void readPictures(Reader reader, Pictures& pictures, const std::filesystem::path& folder) {
    reader.read("height", pictures.height);
    reader.read("color", pictures.color);
    reader.read("normal", pictures.normal);
    for (std::string* path : {&pictures.height, &pictures.color, &pictures.normal}) {
        *path = resolved(*path, folder);
    }
    if (reader.has("recipe")) {
        Reader recipe = reader.child("recipe");
        if (!recipe.has("name")) recipe.fail("name", MessageId::WantAText);
        recipe.named("name", [&](const std::string& name) {
            const ReliefRecipe& known = findRecipe(name, {});
            pictures.recipe = name;
            pictures.recipeWidth = pictures.recipeHeight = known.defaultSize;
        });
        recipe.readWhole("width", pictures.recipeWidth);
        recipe.readWhole("height", pictures.recipeHeight);
        recipe.readWhole("seed", pictures.seed);
        recipe.finish();
    }
    if (reader.has("drawn")) readDrawn(reader.child("drawn"), pictures.drawn);
    reader.read("channel", pictures.reading.channel);
    reader.read("invert", pictures.reading.invert);
    reader.named("range", [&](const std::string& text) { pictures.reading.range = parseHeightRange(text); });
    reader.readWhole("max-pixels", pictures.reading.maxPixels);
    reader.readWhole("memory", pictures.memory);
    reader.finish();
}

void readCamera(Reader reader, Camera& camera) {
    std::array<double, 3> eye{camera.eye.x, camera.eye.y, camera.eye.z};
    std::array<double, 3> target{camera.target.x, camera.target.y, camera.target.z};
    if (reader.read("eye", eye)) camera.kind = Camera::Kind::Free;
    reader.read("target", target);
    camera.eye = {eye[0], eye[1], eye[2]};
    camera.target = {target[0], target[1], target[2]};
    reader.read("elevation", camera.elevation);
    reader.read("azimuth", camera.azimuth);
    reader.read("distance", camera.distance);
    reader.read("fov", camera.fov);
    reader.finish();
}

void readOptions(Reader reader, OptionValues& options) {
    reader.acceptAll();
    for (const auto& [name, value] : reader.object().items()) {
        if (value.is_string()) {
            options[name] = value.get<std::string>();
        } else if (value.is_number()) {
            options[name] = numberText(value.get<double>());
        } else {
            reader.fail(name, MessageId::WantANumberOrText);
        }
    }
}

void readMethod(Reader reader, MethodChoice& method) {
    reader.read("name", method.name);
    if (reader.has("options")) readOptions(reader.child("options"), method.options);
    reader.finish();
}

void readLight(Reader reader, Light& light) {
    reader.read("azimuth", light.azimuth);
    reader.read("elevation", light.elevation);
    reader.read("ambient", light.ambient);
    reader.read("intensity", light.intensity);
    reader.finish();
}

Json methodJson(const MethodChoice& method) {
    Json json = {{"name", method.name}};
    if (!method.options.empty()) json["options"] = method.options;
    return json;
}

// The keys of the alternatives, by subject.
constexpr std::pair<const char*, std::vector<MethodChoice> Comparison::*> kCompared[]{
    {"methods", &Comparison::others},
    {"filters", &Comparison::filters},
    {"mappings", &Comparison::mappings},
    {"heights", &Comparison::heights}};

void readComparison(Reader reader, Comparison& comparison) {
    reader.named("subject", [&](const std::string& name) { comparison.subject = parseCompareSubject(name); });
    for (const auto& [key, list] : kCompared) {
        reader.readObjects(key, [&, list = list](Reader other) {
            (comparison.*list).emplace_back();
            readMethod(std::move(other), (comparison.*list).back());
        });
    }
    reader.named("mode", [&](const std::string& name) { comparison.mode = parseCompareMode(name); });
    reader.named("difference", [&](const std::string& name) { comparison.measure = parseCompareMeasure(name); });
    reader.named("reference", [&](const std::string& name) { comparison.reference = parseCompareReference(name); });
    reader.readNumbers("dividers", comparison.dividers);
    reader.read("rate", comparison.rate);
    reader.finish();
}

Json comparisonJson(const Comparison& comparison) {
    Json json = {{"methods", Json::array()}};
    // Earlier versions, which only compare methods, refuse the key "subject"; it is therefore written only if
    // necessary.
    if (comparison.subject != CompareSubject::Methods) json["subject"] = compareSubjectName(comparison.subject);
    for (const auto& [key, list] : kCompared) {
        for (const MethodChoice& other : comparison.*list) json[key].push_back(methodJson(other));
    }
    json["mode"] = compareModeName(comparison.mode);
    json["difference"] = compareMeasureName(comparison.measure);
    json["reference"] = compareReferenceName(comparison.reference);
    if (!comparison.dividers.empty()) json["dividers"] = comparison.dividers;
    json["rate"] = comparison.rate;
    return json;
}

Json drawnJson(const DrawnRelief& drawn) {
    Json json = {{"width", drawn.width}, {"height", drawn.height}, {"rows", Json::array()}};
    for (std::size_t i = 0; i < drawn.heights.size(); i += static_cast<std::size_t>(drawn.width)) {
        const auto row = drawn.heights.begin() + static_cast<std::ptrdiff_t>(i);
        json["rows"].push_back(drawnNumbers({row, row + drawn.width}));
    }
    return json;
}

Json pictureJson(const Pictures& pictures, const std::string& folder) {
    Json json;
    if (!pictures.height.empty()) json["height"] = relativeTo(pictures.height, folder);
    if (!pictures.recipe.empty()) {
        json["recipe"] = {{"name", pictures.recipe},
                          {"width", pictures.recipeWidth},
                          {"height", pictures.recipeHeight},
                          {"seed", pictures.seed}};
    }
    if (!pictures.drawn.empty()) json["drawn"] = drawnJson(pictures.drawn);
    if (!pictures.color.empty()) json["color"] = relativeTo(pictures.color, folder);
    if (!pictures.normal.empty()) json["normal"] = relativeTo(pictures.normal, folder);
    if (!pictures.reading.channel.empty()) json["channel"] = pictures.reading.channel;
    json["invert"] = pictures.reading.invert;
    json["range"] = heightRangeText(pictures.reading.range);
    json["max-pixels"] = pictures.reading.maxPixels;
    if (pictures.memory > 0) json["memory"] = pictures.memory;
    return json;
}

Json cameraJson(const Camera& camera) {
    Json json;
    if (camera.kind == Camera::Kind::Free) {
        json["eye"] = {camera.eye.x, camera.eye.y, camera.eye.z};
    } else {
        json["elevation"] = camera.elevation;
        json["azimuth"] = camera.azimuth;
        json["distance"] = camera.distance;
    }
    json["target"] = {camera.target.x, camera.target.y, camera.target.z};
    json["fov"] = camera.fov;
    return json;
}

Breakpoint readBreakpoint(Reader reader) {
    Breakpoint breakpoint;
    reader.named("stop", [&](const std::string& name) { breakpoint.kind = parseStop(name); });
    reader.readWhole("level", breakpoint.level);
    reader.readWhole("i", breakpoint.i);
    reader.readWhole("j", breakpoint.j);
    reader.read("height", breakpoint.height);
    reader.read("on", breakpoint.on);
    reader.readWhole("ignore", breakpoint.ignore);
    reader.read("if", breakpoint.condition);
    reader.finish();
    return breakpoint;
}

Json breakpointJson(const Breakpoint& breakpoint) {
    Json json{{"stop", stopName(breakpoint.kind)}};
    const Breakpoint standard;
    const bool texel = breakpoint.kind == StopKind::Texel;
    if (texel || breakpoint.level != standard.level) json["level"] = breakpoint.level;
    if (texel || breakpoint.i != 0) json["i"] = breakpoint.i;
    if (texel || breakpoint.j != 0) json["j"] = breakpoint.j;
    if (breakpoint.height != standard.height) json["height"] = breakpoint.height;
    if (!breakpoint.on) json["on"] = false;
    if (breakpoint.ignore != 0) json["ignore"] = breakpoint.ignore;
    if (!breakpoint.condition.empty()) json["if"] = breakpoint.condition;
    return json;
}

void readNotes(Reader& reader, Scenario& scenario, const std::filesystem::path& folder) {
    reader.readObjects("breakpoints",
                       [&](Reader item) { scenario.breakpoints.push_back(readBreakpoint(std::move(item))); });
    reader.readObjects("bookmarks", [&](Reader item) {
        Bookmark bookmark;
        item.read("name", bookmark.name);
        item.readPair("pixel", bookmark.pixel.x, bookmark.pixel.y);
        if (item.has("camera")) readCamera(item.child("camera"), bookmark.camera);
        item.readWhole("step", bookmark.step);
        item.finish();
        scenario.bookmarks.push_back(std::move(bookmark));
    });
    if (!reader.has("other-tracer")) return;
    Reader other = reader.child("other-tracer");
    other.read("rays", scenario.other.rays);
    other.read("steps", scenario.other.steps);
    for (std::string* path : {&scenario.other.rays, &scenario.other.steps}) *path = resolved(*path, folder);
    other.readWhole("ray", scenario.other.ray);
    other.read("shown", scenario.other.shown);
    other.finish();
}

void writeNotes(Json& json, const Scenario& scenario, const std::string& folder) {
    for (const Breakpoint& breakpoint : scenario.breakpoints) json["breakpoints"].push_back(breakpointJson(breakpoint));
    for (const Bookmark& bookmark : scenario.bookmarks) {
        json["bookmarks"].push_back({{"name", bookmark.name},
                                     {"pixel", {bookmark.pixel.x, bookmark.pixel.y}},
                                     {"camera", cameraJson(bookmark.camera)},
                                     {"step", bookmark.step}});
    }
    if (!scenario.other) return;
    json["other-tracer"] = {{"rays", relativeTo(scenario.other.rays, folder)},
                            {"steps", relativeTo(scenario.other.steps, folder)},
                            {"ray", scenario.other.ray},
                            {"shown", scenario.other.shown}};
}

}  // namespace

std::string scenarioText(const Scenario& scenario, const std::string& baseFolder) {
    Json json;
    json["reliefscope"] = kScenarioVersion;
    json["pictures"] = pictureJson(scenario.pictures, baseFolder);
    json["relief"] = {{"depth", scenario.reliefDepth},
                      {"address", addressName(scenario.address)},
                      {"surface", surfaceName(scenario.surface)}};
    json["method"] = methodJson(scenario.method);
    json["filter"] = scenario.filter.name;
    if (!scenario.filter.options.empty()) json["filter-options"] = scenario.filter.options;
    if (scenario.filter.name == kSupersample) {
        json["supersample"] = scenario.filter.samples;
        json["pixel-model"] = pixelModelName(scenario.filter.pixelModel);
    }
    json["scene"] = sceneName(scenario.scene);
    json["camera"] = cameraJson(scenario.camera);
    json["light"] = {{"azimuth", scenario.light.azimuth},
                     {"elevation", scenario.light.elevation},
                     {"ambient", scenario.light.ambient},
                     {"intensity", scenario.light.intensity}};
    json["shadows"] = scenario.shadows;
    if (!scenario.skip) json["skip"] = false;
    if (scenario.mapping != Scenario().mapping) json["mapping"] = scenario.mapping;
    if (scenario.bounded > 0) json["bounded"] = scenario.bounded;
    json["sky"] = scenario.sky;
    json["size"] = {scenario.width, scenario.height};
    if (scenario.pixel) json["pixel"] = {scenario.pixel->x, scenario.pixel->y};
    json["step"] = scenario.step;
    if (!(scenario.comparison == Comparison{})) json["compare"] = comparisonJson(scenario.comparison);
    if (!scenario.ui.empty()) json["ui"] = Json::parse(scenario.ui);
    writeNotes(json, scenario, baseFolder);
    // File names may contain invalid UTF-8, which is replaced rather than refused.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Scenario parseScenario(const std::string& text, const std::string& fileName) {
    const Json json = parseJson(text, fileName);
    const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
    Scenario scenario;
    // A report (relief render --report) contains the scenario that was rendered.
    const bool report = json.is_object() && !json.contains("reliefscope") && json.contains("scenario");
    Reader reader =
        report ? Reader({text, fileName}, json["scenario"], {"scenario"}) : Reader({text, fileName}, json, {});
    if (!reader.has("reliefscope")) throw InputError(fileName, Message(MessageId::ScenarioNoVersion));
    int version = 0;
    reader.readWhole("reliefscope", version);
    if (version != kScenarioVersion) {
        throw InputError(fileName,
                         Message(MessageId::ScenarioVersion, {{"version", version}, {"known", kScenarioVersion}}));
    }
    if (reader.has("pictures")) readPictures(reader.child("pictures"), scenario.pictures, folder);
    if (reader.has("relief")) {
        Reader part = reader.child("relief");
        part.read("depth", scenario.reliefDepth);
        part.named("address", [&](const std::string& name) { scenario.address = parseAddress(name); });
        part.named("surface", [&](const std::string& name) { scenario.surface = parseSurface(name); });
        part.finish();
    }
    if (reader.has("method")) readMethod(reader.child("method"), scenario.method);
    reader.named("filter", [&](const std::string& name) { scenario.filter.name = findFilter(name).name; });
    if (reader.has("filter-options")) readOptions(reader.child("filter-options"), scenario.filter.options);
    reader.readWhole("supersample", scenario.filter.samples);
    reader.named("pixel-model", [&](const std::string& name) { scenario.filter.pixelModel = parsePixelModel(name); });
    reader.named("scene", [&](const std::string& name) { scenario.scene = parseScene(name); });
    if (reader.has("camera")) readCamera(reader.child("camera"), scenario.camera);
    if (reader.has("light")) readLight(reader.child("light"), scenario.light);
    reader.read("shadows", scenario.shadows);
    reader.read("skip", scenario.skip);
    reader.named("mapping", [&](const std::string& name) {
        parseMapping(name, "mapping");
        scenario.mapping = name;
    });
    reader.read("bounded", scenario.bounded);
    reader.read("sky", scenario.sky);
    reader.readPair("size", scenario.width, scenario.height);
    PixelChoice pixel;
    if (reader.readPair("pixel", pixel.x, pixel.y)) scenario.pixel = pixel;
    reader.readWhole("step", scenario.step);
    if (reader.has("compare")) readComparison(reader.child("compare"), scenario.comparison);
    // "panes" is the key's name in files of the first edition.
    for (const char* key : {"ui", "panes"}) {
        if (!reader.has(key) || !scenario.ui.empty()) continue;
        const Reader ui = reader.child(key);
        if (!withinDepth(ui.object(), kWindowDepth)) reader.fail(key, MessageId::WantAShallowObject);
        scenario.ui = ui.object().dump();
    }
    readNotes(reader, scenario, folder);
    reader.finish();
    checkScenarioParts(scenario, {}, [&](const auto& place, const auto& check) { reader.guarded(place, check); });
    return scenario;
}

Scenario loadScenario(const std::string& path) {
    return parseScenario(readTextFile(path), path);
}

void saveScenario(const std::string& path, const Scenario& scenario) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    writeTextFile(path, scenarioText(scenario, folder.string()));
}

}  // namespace relief
