#include <algorithm>
#include <set>

#include "filtering/filters/filter_choice.h"
#include "installed.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"
#include "relief/tracers/map_choice.h"
#include "scenario/row_methods.h"
#include "scenario/variation.h"

namespace relief::app {

namespace {

// Returns "elevation, -90 to 90 degrees, default 35" from the shared description of the number.
std::string numberHelp(std::string_view name) {
    const ScenarioNumber& number = scenarioNumber(name);
    return number.description.help + ", " + rangeText(number.description) + ", default " +
           numberText(number.get(Scenario{}));
}

// Parses "elevation=30,azimuth=45" and sets each number in the scenario; `prefix` is put before a name if a number of
// that full name exists. Returns the names.
std::vector<std::string> applySettings(Scenario& scenario, const std::string& text, const std::string& option,
                                       const std::vector<std::pair<std::string, std::string>>& names) {
    std::vector<std::string> given;
    for (const std::string& part : splitText(text, ',')) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos) {
            const std::string example = names.front().first + "=30," + names[1].first + "=45";
            throw InputError(option, Message(MessageId::NotASetting, {{"text", part}, {"example", example}}));
        }
        const std::string key = part.substr(0, equals);
        if (std::find(given.begin(), given.end(), key) != given.end()) {
            throw InputError(option + " " + key, Message(MessageId::ArgumentRepeated));
        }
        const auto entry = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == key; });
        if (entry == names.end()) {
            std::string known;
            for (const auto& [name, number] : names) known += (known.empty() ? "" : ", ") + name;
            throw InputError(option, unknownName({"what", MessageId::WordSetting}, key, known));
        }
        setScenarioNumber(scenario, entry->second, parseNumber(part.substr(equals + 1), option), option);
        given.push_back(key);
    }
    return given;
}

glm::dvec3 parsePoint(const std::string& text, const std::string& option) {
    const std::array<double, 3> p = parseThree(text, option);
    return {p[0], p[1], p[2]};
}

// Parses settings "NAME=VALUE"; each name may occur once.
void applySettings(OptionValues& options, const std::vector<std::string>& settings, const std::string& option,
                   const std::string& example) {
    std::set<std::string> given;
    for (const std::string& text : settings) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError(option, Message(MessageId::NotASetting, {{"text", text}, {"example", example}}));
        }
        const std::string name = text.substr(0, equals);
        if (!given.insert(name).second) throw InputError(option + " " + name, Message(MessageId::ArgumentRepeated));
        options[name] = text.substr(equals + 1);
    }
}

// Parses a relief drawn by hand, "drawn", "WxH", "0.1,0.5,...", as the printed `relief trace` command contains it.
void applyDrawn(Pictures& pictures, const std::vector<std::string>& parts, const std::string& option) {
    const SizeText size = parseSize(parts[1], option, kMostDrawnSide);
    pictures.drawn = {size.width, size.height, parseDrawnNumbers(parts[2], option)};
    pictures.height.clear();
    pictures.recipe.clear();
    checkDrawn(pictures.drawn, option);
}

}  // namespace

int parseTileMemory(const std::string& text, const std::string& option) {
    return static_cast<int>(parseWhole(text, option, 1, kMostTileMemory));
}

void applyOrbit(Scenario& scenario, const std::string& text, const std::string& option) {
    const auto given =
        applySettings(scenario, text, option,
                      {{"elevation", "elevation"}, {"azimuth", "azimuth"}, {"distance", "distance"}, {"fov", "fov"}});
    // Setting only the field of view does not turn a free camera into an orbit camera.
    if (given != std::vector<std::string>{"fov"}) scenario.camera.kind = Camera::Kind::Orbit;
}

void applyRecipe(Pictures& pictures, const std::string& text, const std::string& option, int mostSide) {
    const std::vector<std::string> parts = splitText(text, ':');
    if (parts[0] == kDrawn && parts.size() == 3) return applyDrawn(pictures, parts, option);
    pictures.drawn = {};
    // A text of more parts is no name either.
    const ReliefRecipe& found = findRecipe(parts.size() > 3 ? text : parts[0], option);
    pictures.height.clear();
    pictures.recipe = parts[0];
    pictures.recipeWidth = pictures.recipeHeight = found.defaultSize;
    if (parts.size() > 1) {
        const SizeText size = parseSize(parts[1], option, mostSide);
        pictures.recipeWidth = size.width;
        pictures.recipeHeight = size.height;
        const std::int64_t limit = pictures.reading.maxPixels;
        if (std::int64_t{size.width} * size.height > limit) {
            throw InputError(option, Message(MessageId::PictureTooLarge,
                                             {{"width", size.width}, {"height", size.height}, {"limit", limit}}));
        }
    }
    if (parts.size() > 2) pictures.seed = parseSeed(parts[2], option);
}

void ScenarioOptions::add(CLI::App& parser, OptionGroups groups) {
    addText(parser, "FILE", file_, "",
            "a height map (PNG, JPEG, TIFF, EXR, HDR, ...), or a scenario (.json) as saved by the window or contained "
            "in a report (--report): pictures, method, camera, light. Options override the scenario",
            "Arguments");
    addPictures(parser, groups);
    reading_.add(parser);
    addMethod(parser, groups);
    if (groups == OptionGroups::All || groups == OptionGroups::View) addView(parser, groups);
}

void ScenarioOptions::addPictures(CLI::App& parser, OptionGroups groups) {
    const char* group = "Pictures";
    addText(parser, "--height", height_, "FILE", "height map: the same as FILE", group);
    addText(
        parser, "--relief", recipe_, "NAME[:SIZE[:SEED]]",
        "a procedural relief instead of a file, such as bricks:512 or bricks:512x256:7; relief list reliefs lists them",
        group);
    if (groups != OptionGroups::All) return;
    addText(parser, "--color", color_, "FILE", "colour picture; default: the heights in grey", group);
    addText(parser, "--normal", normal_, "FILE",
            "normal map (OpenGL: y up) for the light; default: the relief's own slopes", group);
}

void ScenarioOptions::addMemory(CLI::App& parser, const std::string& name) {
    memoryOption_ = name;
    addText(parser, name, memory_, "MB",
            "a height map written by relief tile is read by tiles, within this much memory, so that it may be larger "
            "than the machine's; default: it is read as a whole",
            "Pictures");
}

void ScenarioOptions::addMethod(CLI::App& parser, OptionGroups groups) {
    const char* group = groups == OptionGroups::HeightsOnly ? "Relief" : "Method";
    if (groups == OptionGroups::All || groups == OptionGroups::View || groups == OptionGroups::None) {
        addText(parser, "--tracer", tracer_, "NAME[:OPTION=VALUE...]",
                "method that finds where rays hit the relief: " + namesOf(tracerList()) + "; default " +
                    Scenario{}.method.name +
                    "; with options such as layers:layers=64 (relief list NAME lists a method's options)",
                group);
        addText(parser, "--map", map_, "FILE.tif",
                "distance or cone map stored by relief map, used instead of the map that the tracer would build. The "
                "options of the tracer's map are then those of this map",
                group);
    }
    if (groups != OptionGroups::HeightsOnly) {
        addTexts(parser, "--set", settings_, "NAME=VALUE",
                 "an option of the method, such as layers=64; may be repeated, once for each option", group);
    }
    addText(parser, "--relief-depth", reliefDepth_, "D", numberHelp("relief-depth"), group);
    addText(parser, "--address", address_, "repeat|clamp|border",
            "relief outside the picture. repeat: the picture again (default); clamp: the heights of its rim; border: "
            "no relief",
            group);
    addText(parser, "--surface", surface_, "bilinear|columns",
            "surface between texels: smooth (bilinear, default), or one box per texel (columns)", group);
    if (groups == OptionGroups::All) {
        addText(parser, "--filter", filter_, "NAME[:OPTION=VALUE...]",
                "filter that samples the colours: " + namesOf(filterList()) + "; default " + Scenario{}.filter.name +
                    "; with options such as elliptical:weights=uniform:radius=0.6 or supersample:samples=4 (relief "
                    "list NAME lists a filter's options)",
                group);
        addTexts(parser, "--filter-set", filterSettings_, "NAME=VALUE",
                 "an option of the filter, such as anisotropy=32; may be repeated", group);
        addText(parser, "--supersample", supersample_, "N",
                "reference picture: N x N rays per pixel, each traced, coloured and lit by itself, 1 to " +
                    std::to_string(kMaxSamples) + "; the same as --filter supersample, whose default is " +
                    std::to_string(FilterChoice{}.samples),
                group);
        addText(parser, "--pixel-model", pixelModel_, "box|gaussian|lcd|crt",
                "weights of the samples of --supersample. box: uniform in the pixel's square (default); gaussian: a "
                "Gaussian of sigma " +
                    numberText(kGaussianSigma) +
                    " pixels, which extends into neighbouring pixels; lcd: the three stripes of a display; crt: the "
                    "three spots of a tube",
                group);
    }
}

void ScenarioOptions::addView(CLI::App& parser, OptionGroups groups) {
    const char* group = "View";
    addText(parser, "--size", size_, "WxH|N", "size of the picture, pixels, default 800x600; N: N x N", group);
    addText(parser, "--scene", scene_, "floor|wall|cube", "surface that carries the relief; default floor", group);
    addText(parser, "--camera", camera_, "elevation=..,...",
            "a camera that looks at the middle of the scene. elevation: " + numberHelp("elevation") + "; azimuth: " +
                numberHelp("azimuth") + "; distance: " + numberHelp("distance") + "; fov: " + numberHelp("fov"),
            group);
    addText(parser, "--eye", eye_, "X,Y,Z", "position of a free camera, texture widths, y up; needs --target", group);
    addText(parser, "--target", target_, "X,Y,Z", "point at which the free camera looks, texture widths", group);
    addText(parser, "--fov", fov_, "DEGREES", numberHelp("fov"), group);
    addText(
        parser, "--mapping", mapping_, "NAME",
        "method that computes texture coordinates along a row of pixels, spelled as for bench rows: " +
            commaList(mappingNames()) +
            ". direct (default) computes in double, the others in float. Options are added as in incremental:anchor=0",
        group);
    if (groups == OptionGroups::View) return;
    addFlag(parser, "--no-skip", noSkip_,
            "also do the work that cannot change the picture, which makes it slower; the report lists the work that is "
            "normally skipped. Polygons that face away or lie off the screen are still not drawn, and pyramid methods "
            "still end a ray at once if it starts at the highest point",
            group);
    addText(parser, "--bounded", bounded_, "E", numberHelp("bounded"), group);
    addFlag(parser, "--shadows", shadows_, "the relief casts shadows: a ray to the light is traced from every hit",
            group);
    addText(parser, "--light", light_, "azimuth=..,...",
            "azimuth: " + numberHelp("light-azimuth") + "; elevation: " + numberHelp("light-elevation") +
                "; ambient: " + numberHelp("ambient") + "; intensity: " + numberHelp("intensity"),
            group);
}

Scenario ScenarioOptions::scenario(const OptionText& file) const {
    Scenario scenario;
    const std::string path = file ? shippedFile(*file) : std::string();
    if (file && isScenarioFile(path)) {
        scenario = loadScenario(path);
    } else if (file) {
        if (path.empty()) throw InputError("FILE", Message(MessageId::FileMissing));
        if (height_ || recipe_) {
            throw InputError(height_ ? "--height" : "--relief",
                             Message(MessageId::ArgumentsExclude, {{"other", path}}));
        }
        scenario.pictures.height = path;
    }
    applyPictures(scenario);
    for (std::string* const picture :
         {&scenario.pictures.height, &scenario.pictures.color, &scenario.pictures.normal}) {
        *picture = shippedFile(*picture);
    }
    const Pictures& pictures = scenario.pictures;
    if (pictures.height.empty() && pictures.recipe.empty() && pictures.drawn.empty()) {
        throw InputError(file.value_or("--height"), Message(MessageId::NoHeights));
    }
    applyMethod(scenario);
    applyView(scenario);
    checkScenario(scenario, file.value_or(""));
    return scenario;
}

Scenario ScenarioOptions::withoutHeights() const {
    Scenario scenario;
    applyMethod(scenario);
    return scenario;
}

void ScenarioOptions::useStoredMap(Scenario& scenario, const Assets& assets, MapCache& maps, Work& work,
                                   bool follow) const {
    if (!map_) return;
    const HeightField field = assets.field(scenario);
    const StoredMap map = loadMap(*map_, field, maps.budget(), work);
    if (follow && !tracer_ && !(file_ && isScenarioFile(shippedFile(*file_))))
        scenario.method.name = methodOfMap(mapKindName(map));
    scenario.method = useMap(*map_, map, scenario.method, field, maps);
}

void ScenarioOptions::applyRelief(Surface& surface, Address& address, double& reliefDepth) const {
    Scenario scenario;
    applyRelief(scenario);
    if (surface_) surface = scenario.surface;
    if (address_) address = scenario.address;
    if (reliefDepth_) reliefDepth = scenario.reliefDepth;
}

std::string ScenarioOptions::mapArgument() const {
    if (!map_) return {};
    std::string quoted;
    for (const char c : *map_) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return " --map '" + quoted + "'";
}

std::string ScenarioOptions::mapContent() const {
    if (!map_) return {};
    const std::string bytes = readTextFile(*map_);
    return hashText(std::as_bytes(std::span(bytes)));
}

void ScenarioOptions::applyPictures(Scenario& scenario) const {
    if (height_ && recipe_) {
        throw InputError("--height", Message(MessageId::ArgumentsExclude, {{"other", "--relief"}}));
    }
    reading_.apply(scenario.pictures.reading);
    if (recipe_) applyRecipe(scenario.pictures, *recipe_);
    if (height_) {
        if (height_->empty()) throw InputError("--height", Message(MessageId::FileMissing));
        scenario.pictures.height = *height_;
        scenario.pictures.recipe.clear();
        scenario.pictures.drawn = {};
    }
    if (memory_) scenario.pictures.memory = parseTileMemory(*memory_, memoryOption_);
    if (color_) scenario.pictures.color = *color_;
    if (normal_) scenario.pictures.normal = *normal_;
}

void ScenarioOptions::chooseTracer(const std::string& method, const std::string& argument) {
    tracer_ = method;
    tracerOption_ = argument;
}

std::string ScenarioOptions::viewOption() const {
    for (const auto& [given, name] :
         {std::pair(&size_, "--size"), std::pair(&scene_, "--scene"), std::pair(&camera_, "--camera"),
          std::pair(&eye_, "--eye"), std::pair(&target_, "--target"), std::pair(&fov_, "--fov"),
          std::pair(&mapping_, "--mapping")}) {
        if (*given) return name;
    }
    return {};
}

std::string ScenarioOptions::lookOption() const {
    for (const auto& [given, name] :
         {std::pair(&color_, "--color"), std::pair(&normal_, "--normal"), std::pair(&filter_, "--filter"),
          std::pair(&supersample_, "--supersample"), std::pair(&pixelModel_, "--pixel-model"),
          std::pair(&light_, "--light"), std::pair(&bounded_, "--bounded")}) {
        if (*given) return name;
    }
    if (!filterSettings_.empty()) return "--filter-set";
    return shadows_ ? "--shadows" : noSkip_ ? "--no-skip" : "";
}

void ScenarioOptions::applyTracer(MethodChoice& method) const {
    if (!tracer_) return;
    MethodChoice given = splitMethodChoice(*tracer_, tracerOption_);
    checkMethod(given, tracerOption_);
    // Options belong to their method: another method does not inherit them.
    if (given.name != method.name || !given.options.empty()) method = std::move(given);
}

void ScenarioOptions::applyMethod(Scenario& scenario) const {
    applyTracer(scenario.method);
    applySettings(scenario.method.options, settings_, "--set", "layers=64");
    if (!settings_.empty()) checkMethod(scenario.method, "--set");
    applyRelief(scenario);
    applyFilter(scenario);
}

void ScenarioOptions::applyRelief(Scenario& scenario) const {
    if (reliefDepth_) {
        const std::string option = "--relief-depth";
        setScenarioNumber(scenario, "relief-depth", parseNumber(*reliefDepth_, option), option);
    }
    if (address_) scenario.address = parseAddress(*address_);
    if (surface_) scenario.surface = parseSurface(*surface_);
}

void ScenarioOptions::applyFilter(Scenario& scenario) const {
    FilterChoice& filter = scenario.filter;
    if (filter_) {
        const MethodChoice given = splitMethodChoice(*filter_, "--filter");
        checkVariation(CompareSubject::Filters, given, "--filter");
        // Options belong to their filter: another filter does not inherit them.
        if (given.name != filter.name || !given.options.empty()) {
            scenario = varied(scenario, CompareSubject::Filters, given);
        }
    }
    if (supersample_) {
        if (filter_ && *filter_ != kSupersample) {
            throw InputError("--supersample",
                             Message(MessageId::ArgumentsExclude, {{"other", "--filter " + *filter_}}));
        }
        filter.name = kSupersample;
        filter.options.clear();
        filter.samples = static_cast<int>(parseWhole(*supersample_, "--supersample", 1, kMaxSamples));
    }
    applySettings(filter.options, filterSettings_, "--filter-set", "anisotropy=32");
    if (!filterSettings_.empty()) checkFilter(filter, "--filter-set");
    if (pixelModel_) {
        if (filter.name != kSupersample) throw InputError("--pixel-model", Message(MessageId::SupersampleNeeded));
        filter.pixelModel = parsePixelModel(*pixelModel_);
    }
}

void ScenarioOptions::applyView(Scenario& scenario) const {
    if (size_) {
        const SizeText size = parseSize(*size_, "--size", kMaxPictureSide);
        scenario.width = size.width;
        scenario.height = size.height;
        // The scenario's chosen pixel lies outside a picture of the new size.
        if (scenario.pixel && (scenario.pixel->x >= size.width || scenario.pixel->y >= size.height)) {
            scenario.pixel.reset();
        }
    }
    if (scene_) scenario.scene = parseScene(*scene_);
    if (mapping_) {
        parseMapping(*mapping_, "--mapping");
        scenario.mapping = *mapping_;
    }
    if (shadows_) scenario.shadows = true;
    if (noSkip_) scenario.skip = false;
    if (bounded_) setScenarioNumber(scenario, "bounded", parseNumber(*bounded_, "--bounded"), "--bounded");
    applyCamera(scenario);
    if (light_) {
        applySettings(scenario, *light_, "--light",
                      {{"azimuth", "light-azimuth"},
                       {"elevation", "light-elevation"},
                       {"ambient", "ambient"},
                       {"intensity", "intensity"}});
    }
}

void ScenarioOptions::applyCamera(Scenario& scenario) const {
    Camera& camera = scenario.camera;
    if (camera_ && (eye_ || target_)) {
        throw InputError("--camera", Message(MessageId::ArgumentsExclude, {{"other", eye_ ? "--eye" : "--target"}}));
    }
    if (camera_) applyOrbit(scenario, *camera_, "--camera");
    if (eye_ || target_) {
        if (camera.kind == Camera::Kind::Orbit && !(eye_ && target_)) {
            throw InputError(eye_ ? "--eye" : "--target", Message(MessageId::EyeAndTarget));
        }
        camera.kind = Camera::Kind::Free;
        if (eye_) camera.eye = parsePoint(*eye_, "--eye");
        if (target_) camera.target = parsePoint(*target_, "--target");
    }
    if (fov_) setScenarioNumber(scenario, "fov", parseNumber(*fov_, "--fov"), "--fov");
}

std::array<double, 3> parseThree(const std::string& text, const std::string& option) {
    const std::vector<std::string> parts = splitText(text, ',');
    if (parts.size() != 3) throw InputError(option, Message(MessageId::NotAPoint, {{"text", text}}));
    return {parseNumber(parts[0], option), parseNumber(parts[1], option), parseNumber(parts[2], option)};
}

}  // namespace relief::app
