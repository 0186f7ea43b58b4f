#include <algorithm>

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

namespace relief::app {

namespace {

// "elevation, degrees, -90 to 90, default 35": from the one description of the number.
std::string numberHelp(std::string_view name) {
    const ScenarioNumber& number = scenarioNumber(name);
    const OptionDescription& d = number.description;
    const std::string unit = d.unit.empty() ? "" : ", " + d.unit;
    return d.help + unit + ", " + numberText(d.low) + " to " + numberText(d.high) + ", default " +
           numberText(number.get(Scenario{}));
}

// "elevation=30,azimuth=45": each name with `prefix` (where there is such a number) set in the scenario.
// Returns the names.
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
        const auto entry = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == key; });
        if (entry == names.end()) {
            std::string known;
            for (const auto& [name, number] : names) known += (known.empty() ? "" : ", ") + name;
            throw InputError(option, Message(MessageId::UnknownName,
                                             {{"what", MessageId::WordSetting}, {"name", key}, {"known", known}}));
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

// "NAME=VALUE".
void applySetting(OptionValues& options, const std::string& text, const std::string& subject) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        const std::string example = subject == "--set" ? "layers=64" : "anisotropy=32";
        throw InputError(subject, Message(MessageId::NotASetting, {{"text", text}, {"example", example}}));
    }
    options[text.substr(0, equals)] = text.substr(equals + 1);
}

// "drawn", "WxH", "0.1,0.5,...": as the trace command of a relief drawn by hand has it.
void applyDrawn(Pictures& pictures, const std::vector<std::string>& parts) {
    const SizeText size = parseSize(parts[1], "--relief", kMostDrawnSide);
    pictures.drawn = {size.width, size.height, parseDrawnNumbers(parts[2], "--relief")};
    pictures.height.clear();
    pictures.recipe.clear();
    checkDrawn(pictures.drawn, "--relief");
}

}  // namespace

void applyOrbit(Scenario& scenario, const std::string& text, const std::string& option) {
    const auto given =
        applySettings(scenario, text, option,
                      {{"elevation", "elevation"}, {"azimuth", "azimuth"}, {"distance", "distance"}, {"fov", "fov"}});
    // The field of view alone leaves a free camera free.
    if (given != std::vector<std::string>{"fov"}) scenario.camera.kind = Camera::Kind::Orbit;
}

void applyRecipe(Pictures& pictures, const std::string& text) {
    const std::vector<std::string> parts = splitText(text, ':');
    if (parts[0] == kDrawn && parts.size() == 3) return applyDrawn(pictures, parts);
    pictures.drawn = {};
    std::string known;
    const ReliefRecipe* found = nullptr;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (recipe.name == parts[0]) found = &recipe;
        known.append(known.empty() ? "" : ", ").append(recipe.name);
    }
    if (found == nullptr || parts.size() > 3) {
        throw InputError("--relief", Message(MessageId::UnknownName,
                                             {{"what", MessageId::WordRelief}, {"name", text}, {"known", known}}));
    }
    pictures.height.clear();
    pictures.recipe = parts[0];
    pictures.recipeWidth = pictures.recipeHeight = found->defaultSize;
    if (parts.size() > 1) {
        const SizeText size = parseSize(parts[1], "--relief", kMaxPictureSide);
        pictures.recipeWidth = size.width;
        pictures.recipeHeight = size.height;
        const std::int64_t limit = pictures.reading.maxPixels;
        if (std::int64_t{size.width} * size.height > limit) {
            throw InputError("--relief", Message(MessageId::PictureTooLarge,
                                                 {{"width", size.width}, {"height", size.height}, {"limit", limit}}));
        }
    }
    if (parts.size() > 2) pictures.seed = parseSeed(parts[2], "--relief");
}

void ScenarioOptions::add(CLI::App& parser, Look look) {
    if (look == Look::Heights || look == Look::Plain) {
        addPictures(parser, look);
        reading_.add(parser);
        addMethod(parser, look);
        return;
    }
    addText(parser, "SCENARIO", file_, "",
            "a scenario (.json) as the window saves it, or as a --report holds it under \"scenario\": pictures, "
            "method, camera, light. "
            "Every option below overrides what it says",
            "Arguments");
    addPictures(parser, look);
    reading_.add(parser);
    addMethod(parser, look);
    addView(parser, look);
}

void ScenarioOptions::addPictures(CLI::App& parser, Look look) {
    const char* group = "Pictures";
    addText(parser, "--height", height_, "FILE", "height map: PNG, JPEG, TIFF, EXR, HDR, ...", group);
    addText(parser, "--relief", recipe_, "NAME[:WxH[:SEED]]",
            "instead of a file, a procedural relief (relief list names them), such as bricks:512x512:7", group);
    if (look != Look::Yes) return;
    addText(parser, "--color", color_, "FILE", "colour picture; default: the heights in grey", group);
    addText(parser, "--normal", normal_, "FILE",
            "normal map (OpenGL: y up) for the light; default: the relief's own slopes", group);
}

void ScenarioOptions::addMethod(CLI::App& parser, Look look) {
    const char* group = look == Look::Plain ? "Relief" : "Method";
    if (look == Look::No || look == Look::Yes) {
        addText(parser, "--tracer", tracer_, "NAME",
                "how rays meet the relief: " + namesOf(tracerList()) + "; default " + Scenario{}.method.name, group);
        addText(parser, "--map", map_, "FILE.tif",
                "a distance or cone map as relief map stores it, in place of the one that the tracer would build; its "
                "options are the map's",
                group);
    }
    if (look != Look::Plain) {
        addTexts(parser, "--set", settings_, "NAME=VALUE",
                 "an option of the method, such as layers=64; may be repeated (relief list shows what there is)",
                 group);
    }
    addText(parser, "--relief-depth", reliefDepth_, "D", numberHelp("relief-depth"), group);
    addText(parser, "--address", address_, "repeat|clamp|border",
            "what lies outside the picture: itself again (default), its rim, nothing", group);
    addText(parser, "--surface", surface_, "bilinear|columns",
            "between texels: a smooth surface (default), or each texel a box", group);
    if (look == Look::Yes) {
        addText(parser, "--filter", filter_, "NAME[:OPTION=VALUE...]",
                "how colours are sampled: " + namesOf(filterList()) + "; default " + Scenario{}.filter.name +
                    "; with options such as elliptical:weights=uniform:radius=0.6 (relief list shows what there is)",
                group);
        addTexts(parser, "--filter-set", filterSettings_, "NAME=VALUE",
                 "an option of the filter, such as anisotropy=32; may be repeated", group);
        addText(parser, "--supersample", supersample_, "N",
                "the picture's truth: N x N rays a pixel, each traced, coloured and lit by itself, 1 to " +
                    std::to_string(kMaxSamples) + "; the filter supersample, which alone means " +
                    std::to_string(FilterChoice{}.samples),
                group);
        addText(
            parser, "--pixel-model", pixelModel_, "box|gaussian|lcd|crt",
            "how samples are weighed: evenly in the pixel's square (default), by a bell of sigma " +
                numberText(kGaussianSigma) +
                " pixels that reaches into the neighbours, in a display's three stripes, or in a tube's three spots",
            group);
    }
}

void ScenarioOptions::addView(CLI::App& parser, Look look) {
    const char* group = "View";
    addText(parser, "--size", size_, "WxH", "size of the picture, pixels, default 800x600", group);
    addText(parser, "--scene", scene_, "floor|wall|cube", "what carries the relief; default floor", group);
    addText(parser, "--camera", camera_, "elevation=..,...",
            "a camera that looks at the middle of the scene. elevation: " + numberHelp("elevation") + "; azimuth: " +
                numberHelp("azimuth") + "; distance: " + numberHelp("distance") + "; fov: " + numberHelp("fov"),
            group);
    addText(parser, "--eye", eye_, "X,Y,Z", "a free camera: where it is, texture widths, y up; with --target", group);
    addText(parser, "--target", target_, "X,Y,Z", "what the free camera looks at", group);
    addText(parser, "--fov", fov_, "DEGREES", numberHelp("fov"), group);
    addText(parser, "--mapping", mapping_, "NAME",
            "how texture coordinates are made along a row of pixels, as bench rows spells it: " +
                commaList(mappingNames()) +
                "; direct: in double; the others in float, such as incremental:anchor=0; default direct",
            group);
    if (look == Look::No) return;
    addFlag(parser, "--no-skip", noSkip_,
            "do all the work that cannot change a bit as well: the same picture, slower (the report says what is "
            "spared). What "
            "stays: polygons that face away or lie off the screen are not drawn, and pyramid methods end a ray at once "
            "that "
            "starts at the highest point",
            group);
    addText(parser, "--bounded", bounded_, "E", numberHelp("bounded"), group);
    addFlag(parser, "--shadows", shadows_, "the relief casts shadows: from every hit a ray to the light", group);
    addText(parser, "--light", light_, "azimuth=..,...",
            "azimuth: " + numberHelp("light-azimuth") + "; elevation: " + numberHelp("light-elevation") +
                "; ambient: " + numberHelp("ambient") + "; intensity: " + numberHelp("intensity"),
            group);
}

Scenario ScenarioOptions::scenario(const OptionText& file) const {
    Scenario scenario = file ? loadScenario(shippedFile(*file)) : Scenario{};
    applyPictures(scenario);
    for (std::string* picture : {&scenario.pictures.height, &scenario.pictures.color, &scenario.pictures.normal})
        *picture = shippedFile(*picture);
    applyMethod(scenario);
    applyView(scenario);
    checkScenario(scenario, file.value_or(""));
    return scenario;
}

void ScenarioOptions::useStoredMap(Scenario& scenario, const Assets& assets, MapCache& maps, Work& work,
                                   bool follow) const {
    if (!map_) return;
    const HeightField field(assets.heights, scenario.surface, scenario.address, scenario.reliefDepth);
    const StoredMap map = loadMap(*map_, field, maps.budget(), work);
    if (follow && !tracer_ && !file_) scenario.method.name = methodOfMap(mapKindName(map));
    scenario.method = useMap(*map_, map, scenario.method, field, maps);
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
    if (color_) scenario.pictures.color = *color_;
    if (normal_) scenario.pictures.normal = *normal_;
}

void ScenarioOptions::applyMethod(Scenario& scenario) const {
    // Options belong to their method: another method does not inherit them.
    if (tracer_ && *tracer_ != scenario.method.name) scenario.method = {findTracer(*tracer_).name, {}};
    for (const std::string& setting : settings_) applySetting(scenario.method.options, setting, "--set");
    if (!settings_.empty()) checkMethod(scenario.method, "--set");
    if (reliefDepth_) {
        const std::string option = "--relief-depth";
        setScenarioNumber(scenario, "relief-depth", parseNumber(*reliefDepth_, option), option);
    }
    if (address_) scenario.address = parseAddress(*address_);
    if (surface_) scenario.surface = parseSurface(*surface_);
    applyFilter(scenario.filter);
}

void ScenarioOptions::applyFilter(FilterChoice& filter) const {
    if (filter_) {
        // Options belong to their filter: another filter does not inherit them.
        FilterChoice given = parseFilter(*filter_, "--filter");
        if (given.name == filter.name && given.options.empty()) given.options = filter.options;
        filter.name = given.name;
        filter.options = given.options;
    }
    if (supersample_) {
        if (filter_ && filter.name != kSupersample) {
            throw InputError("--supersample",
                             Message(MessageId::ArgumentsExclude, {{"other", "--filter " + *filter_}}));
        }
        filter.name = kSupersample;
        filter.options.clear();
        filter.samples = static_cast<int>(parseWhole(*supersample_, "--supersample", 1, kMaxSamples));
    }
    for (const std::string& setting : filterSettings_) applySetting(filter.options, setting, "--filter-set");
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
        // The scenario's chosen pixel was one of another picture.
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
