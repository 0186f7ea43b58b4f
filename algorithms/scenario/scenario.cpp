#include "scenario/scenario.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "relief/reliefs.h"
#include "rendering/base_level.h"
#include "rendering/pinhole.h"
#include "scenario/row_methods.h"
#include "scenario/scenario_checks.h"

namespace relief {

namespace {

OptionDescription number(const char* name, const char* unit, double low, double high, double step, const char* help) {
    OptionDescription option;
    option.name = name;
    option.kind = OptionKind::Real;
    option.unit = unit;
    option.low = low;
    option.high = high;
    option.step = step;
    option.help = help;
    return option;
}

OptionDescription whole(const char* name, const char* unit, double low, double high, const char* help) {
    OptionDescription option = number(name, unit, low, high, 1, help);
    option.kind = OptionKind::Integer;
    return option;
}

// Generates the getter and setter of the table from a member expression.
#define RELIEF_MEMBER(type, expression)                               \
    [](const Scenario& s) -> double { return double(s.expression); }, \
        [](Scenario& s, double value) { s.expression = static_cast<type>(value); }

std::vector<ScenarioNumber> makeNumbers() {
    return {
        {number("relief-depth", "texture widths", 0, 4, 0.005, "thickness of the relief slab"),
         RELIEF_MEMBER(double, reliefDepth)},
        {number("elevation", "degrees", -90, 90, 1, "elevation of the camera above the horizontal"),
         RELIEF_MEMBER(double, camera.elevation)},
        {number("azimuth", "degrees", -36000, 36000, 1, "rotation of the camera to the right (0: in front)"),
         RELIEF_MEMBER(double, camera.azimuth)},
        {number("distance", "texture widths", 0.01, 1000, 0.05, "distance from the camera to its target"),
         RELIEF_MEMBER(double, camera.distance)},
        {number("fov", "degrees", 1, 170, 1, "vertical field of view"), RELIEF_MEMBER(double, camera.fov)},
        {number("light-azimuth", "degrees", -36000, 36000, 1,
                "direction from which the light comes (0: from the front)"),
         RELIEF_MEMBER(double, light.azimuth)},
        {number("light-elevation", "degrees", -90, 90, 1, "elevation of the light above the horizontal"),
         RELIEF_MEMBER(double, light.elevation)},
        {number("ambient", "", 0, 1, 0.01, "share of ambient light, from all directions"),
         RELIEF_MEMBER(double, light.ambient)},
        {number("intensity", "", 0, 100, 0.05, "strength of the directional light"),
         RELIEF_MEMBER(double, light.intensity)},
        {number("bounded", "texels", 0, kMaxBounded, 0.05,
                "largest hit error allowed to save work (the actual error is measured)"),
         RELIEF_MEMBER(double, bounded)},
        {whole("width", "pixels", 1, kMaxPictureSide, "width of the picture"), RELIEF_MEMBER(int, width)},
        {whole("height", "pixels", 1, kMaxPictureSide, "height of the picture"), RELIEF_MEMBER(int, height)},
    };
}

#undef RELIEF_MEMBER

// Returns the unit's word in messages.
std::optional<MessageId> unitWord(std::string_view unit) {
    for (const MessageId word :
         {MessageId::UnitDegrees, MessageId::UnitTextureWidths, MessageId::UnitTexels, MessageId::UnitPixels}) {
        if (messageTemplate(word, Language::English) == unit) return word;
    }
    return std::nullopt;
}

void checkNumber(const ScenarioNumber& entry, double value, const std::string& subject) {
    const OptionDescription& d = entry.description;
    const bool isWhole = d.kind != OptionKind::Integer || value == std::floor(value);
    if (value >= d.low && value <= d.high && isWhole) return;
    Message range = rangeOf(d.low, d.high);
    if (const auto unit = unitWord(d.unit)) {
        range = Message(MessageId::RangeOfUnit, {{"low", d.low}, {"high", d.high}, {"unit", *unit}});
    }
    throw InputError(subject, Message(MessageId::OutOfRange, {{"what", d.name}, {"value", value}, {"range", range}}));
}

}  // namespace

std::string heightsName(const Pictures& pictures) {
    const auto sized = [](std::string_view name, int width, int height) {
        return std::string(name) + ":" + std::to_string(width) + "x" + std::to_string(height);
    };
    if (!pictures.drawn.empty()) return sized(kDrawn, pictures.drawn.width, pictures.drawn.height);
    if (!pictures.height.empty()) return pictures.height;
    return sized(pictures.recipe, pictures.recipeWidth, pictures.recipeHeight) + ":" + std::to_string(pictures.seed);
}

const std::vector<ScenarioNumber>& scenarioNumbers() {
    static const std::vector<ScenarioNumber> numbers = makeNumbers();
    return numbers;
}

const ScenarioNumber& scenarioNumber(std::string_view name) {
    std::string known;
    for (const ScenarioNumber& entry : scenarioNumbers()) {
        if (entry.description.name == name) return entry;
        known += (known.empty() ? "" : ", ") + entry.description.name;
    }
    throw InputError("", unknownName({"what", MessageId::WordSetting}, std::string(name), known));
}

void setScenarioNumber(Scenario& scenario, std::string_view name, double value, const std::string& subject) {
    const ScenarioNumber& entry = scenarioNumber(name);
    checkNumber(entry, value, subject);
    entry.set(scenario, value);
}

Scenario withNotesOf(const Scenario& a, const Scenario& b) {
    Scenario out = a;
    out.step = b.step;
    out.breakpoints = b.breakpoints;
    out.bookmarks = b.bookmarks;
    out.ui = b.ui;
    return out;
}

namespace {

void checkPixel(const Scenario& scenario, PixelChoice pixel, const std::string& subject) {
    if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < scenario.width && pixel.y < scenario.height) return;
    throw InputError(subject,
                     Message(MessageId::PixelOutside,
                             {{"x", pixel.x}, {"y", pixel.y}, {"width", scenario.width}, {"height", scenario.height}}));
}

void checkCount(MessageId what, std::size_t count, std::size_t limit, const std::string& subject) {
    if (count <= limit) return;
    throw InputError(subject, Message(MessageId::TooMany, {{"what", what}, {"count", count}, {"limit", limit}}));
}

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

// Throws InputError if the whole number is out of range.
void checkWhole(const char* what, std::int64_t value, std::int64_t low, std::int64_t high, const std::string& subject) {
    if (value >= low && value <= high) return;
    const Message range = high == kUnlimited ? Message(MessageId::RangeAtLeast, {{"low", low}}) : rangeOf(low, high);
    throw InputError(subject, Message(MessageId::OutOfRange, {{"what", what}, {"value", value}, {"range", range}}));
}

void checkNotes(const Scenario& scenario, const std::string& subject, const ScenarioCheck& run) {
    run({"breakpoints"}, [&] {
        checkCount(MessageId::WordBreakpoints, scenario.breakpoints.size(), kMostBreakpoints, subject);
        for (const Breakpoint& breakpoint : scenario.breakpoints) checkBreakpoint(breakpoint, subject);
    });
    run({"bookmarks"}, [&] {
        checkCount(MessageId::WordBookmarks, scenario.bookmarks.size(), kMostBookmarks, subject);
        // The picture may have become smaller since the bookmark was set; its pixel is then clamped to the picture.
        for (const Bookmark& bookmark : scenario.bookmarks) {
            pinholeCamera(bookmark.camera, scenario.width, scenario.height);
            checkWhole("step", bookmark.step, 0, kUnlimited, subject);
        }
    });
    run({"other-tracer", "ray"}, [&] {
        if (scenario.other.ray >= 0) return;
        const Message range(MessageId::RangeAtLeast, {{"low", 0}});
        throw InputError(subject,
                         Message(MessageId::OutOfRange,
                                 {{"what", MessageId::WordRay}, {"value", scenario.other.ray}, {"range", range}}));
    });
}

// Returns the keys under which a scenario's file stores an adjustable number.
std::vector<std::string> placeOf(const std::string& number) {
    if (number == "relief-depth") return {"relief", "depth"};
    if (number == "light-azimuth" || number == "light-elevation") return {"light", number.substr(6)};
    if (number == "ambient" || number == "intensity") return {"light", number};
    if (number == "width" || number == "height") return {"size"};
    if (number == "bounded") return {number};
    return {"camera", number};
}

void checkPictures(const Pictures& pictures, const std::string& subject, const ScenarioCheck& run) {
    run({"pictures", "max-pixels"},
        [&] { checkWhole("max-pixels", pictures.reading.maxPixels, 1, kUnlimited, subject); });
    if (!pictures.recipe.empty()) {
        run({"pictures", "recipe", "width"},
            [&] { checkWhole("width", pictures.recipeWidth, 1, kMaxReliefSide, subject); });
        run({"pictures", "recipe", "height"},
            [&] { checkWhole("height", pictures.recipeHeight, 1, kMaxReliefSide, subject); });
        run({"pictures", "recipe"}, [&] {
            checkRecipeSize(findRecipe(pictures.recipe, subject), pictures.recipeWidth, pictures.recipeHeight);
        });
    }
    if (pictures.drawn.empty()) return;
    run({"pictures", "drawn"}, [&] {
        checkDrawn(pictures.drawn, subject);
        if (!pictures.height.empty() || !pictures.recipe.empty()) {
            throw InputError(subject, Message(MessageId::HeightsTwice));
        }
    });
}

// Checks options one by one, each together with those before it. Those that select a method or a map come first,
// because other options depend on them.
void checkOptions(const Scenario& scenario, const std::string& subject, const ScenarioCheck& run) {
    MethodChoice method{scenario.method.name, {}};
    run({"method", "name"}, [&] { checkMethod(method, subject); });
    std::vector<std::pair<std::string, std::string>> options(scenario.method.options.begin(),
                                                             scenario.method.options.end());
    std::ranges::stable_partition(options, [](const auto& option) {
        return option.first == "inner" || option.first == kMapOption || option.first == "inner.map";
    });
    for (const auto& [name, value] : options) {
        method.options[name] = value;
        run({"method", "options", name}, [&] { checkMethod(method, subject); });
    }
    FilterChoice filter = scenario.filter;
    filter.options.clear();
    const std::string filterSubject = subject.empty() ? "--filter" : subject;
    run({"filter"}, [&] { checkFilter(filter, filterSubject); });
    for (const auto& [name, value] : scenario.filter.options) {
        filter.options[name] = value;
        run({"filter-options", name}, [&] { checkFilter(filter, filterSubject); });
    }
}

}  // namespace

void checkScenarioParts(const Scenario& scenario, const std::string& subject, const ScenarioCheck& run) {
    const bool orbit = scenario.camera.kind == Camera::Kind::Orbit;
    for (const ScenarioNumber& entry : scenarioNumbers()) {
        const std::string& name = entry.description.name;
        if (!orbit && (name == "elevation" || name == "azimuth" || name == "distance")) continue;
        run(placeOf(name), [&] { checkNumber(entry, entry.get(scenario), subject); });
    }
    run({"sky"}, [&] {
        for (const double channel : scenario.sky) {
            if (channel >= 0 && channel <= 1000) continue;
            throw InputError(subject, Message(MessageId::OutOfRange,
                                              {{"what", "sky"}, {"value", channel}, {"range", rangeOf(0, 1000)}}));
        }
    });
    checkPictures(scenario.pictures, subject, run);
    run({"step"}, [&] { checkWhole("step", scenario.step, 0, kUnlimited, subject); });
    checkOptions(scenario, subject, run);
    run({"compare"}, [&] { checkComparison(scenario.comparison, subject); });
    run({"mapping"}, [&] { parseMapping(scenario.mapping, subject.empty() ? "--mapping" : subject); });
    run({"supersample"}, [&] {
        if (scenario.filter.samples >= 1 && scenario.filter.samples <= kMaxSamples) return;
        throw InputError(subject, Message(MessageId::OutOfRange, {{"what", "supersample"},
                                                                  {"value", scenario.filter.samples},
                                                                  {"range", rangeOf(1, kMaxSamples)}}));
    });
    run({"camera"}, [&] { pinholeCamera(scenario.camera, scenario.width, scenario.height); });
    if (scenario.pixel) run({"pixel"}, [&] { checkPixel(scenario, *scenario.pixel, subject); });
    checkNotes(scenario, subject, run);
}

void checkScenario(const Scenario& scenario, const std::string& subject) {
    checkScenarioParts(scenario, subject, [](const auto&, const auto& check) { check(); });
}

FrameRequest frameRequest(const Scenario& scenario, const Assets& assets) {
    FrameRequest request(assets.field(scenario));
    request.width = scenario.width;
    request.height = scenario.height;
    request.color = assets.color;
    request.normals = assets.normals;
    request.filter = scenario.filter;
    request.scene = scenario.scene;
    request.camera = scenario.camera;
    request.light = scenario.light;
    request.shadows = scenario.shadows;
    request.skip = scenario.skip;
    request.bounded = scenario.bounded;
    // Meshes are not drawn by rows, and a ray through a pixel must meet the drawn triangles.
    const bool rows = findTracer(scenario.method.name).kind != MethodKind::Mesh;
    request.mapping = rows ? parseMapping(scenario.mapping, "--mapping") : kDirectRows;
    request.sky = Color(scenario.sky[0], scenario.sky[1], scenario.sky[2]);
    request.method = methodOfView(request, scenario.method);
    return request;
}

}  // namespace relief
