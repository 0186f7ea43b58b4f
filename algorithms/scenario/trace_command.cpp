#include "rendering/pinhole.h"
#include "scenario/command_text.h"

namespace relief {

namespace {

// Quotes an argument for a POSIX shell if necessary.
std::string quoted(const std::string& text) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:@%+";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::string triple(const glm::dvec3& v) {
    return numberText(v.x) + "," + numberText(v.y) + "," + numberText(v.z);
}

void addFlag(std::string& line, const std::string& flag, const std::string& value) {
    line += " " + flag + " " + quoted(value);
}

// Returns "relief trace" or "relief render" with the options for heights and method.
std::string commandBegin(const Scenario& scenario, const std::string& command = "relief trace") {
    std::string line = command + heightArguments(scenario.pictures);
    const auto add = [&](const std::string& flag, const std::string& value) { addFlag(line, flag, value); };
    if (scenario.pictures.memory > 0) add("--memory", std::to_string(scenario.pictures.memory));
    add("--tracer", scenario.method.name);
    for (const auto& [name, text] : scenario.method.options) add("--set", name + "=" + text);
    return line + fieldArguments(scenario.reliefDepth, scenario.address, scenario.surface);
}

// Appends scene, camera and size.
void addView(std::string& line, const Scenario& scenario) {
    const auto add = [&](const std::string& flag, const std::string& value) { addFlag(line, flag, value); };
    add("--scene", std::string(sceneName(scenario.scene)));
    if (scenario.mapping != Scenario().mapping) add("--mapping", scenario.mapping);
    const Camera& camera = scenario.camera;
    if (camera.kind == Camera::Kind::Orbit && camera.target == glm::dvec3(0)) {
        add("--camera", "elevation=" + numberText(camera.elevation) + ",azimuth=" + numberText(camera.azimuth) +
                            ",distance=" + numberText(camera.distance) + ",fov=" + numberText(camera.fov));
    } else {
        const bool orbit = camera.kind == Camera::Kind::Orbit;
        const glm::dvec3 eye = orbit ? pinholeCamera(camera, scenario.width, scenario.height).eye : camera.eye;
        add("--eye", triple(eye));
        add("--target", triple(camera.target));
        add("--fov", numberText(camera.fov));
    }
    add("--size", std::to_string(scenario.width) + "x" + std::to_string(scenario.height));
}

}  // namespace

std::string heightArguments(const Pictures& pictures) {
    std::string line;
    const auto add = [&](const std::string& flag, const std::string& value) { addFlag(line, flag, value); };
    if (!pictures.height.empty()) {
        add("--height", pictures.height);
    } else if (!pictures.drawn.empty()) {
        add("--relief", drawnRecipe(pictures.drawn));
    } else {
        add("--relief", pictures.recipe + ":" + std::to_string(pictures.recipeWidth) + "x" +
                            std::to_string(pictures.recipeHeight) + ":" + std::to_string(pictures.seed));
    }
    if (!pictures.reading.channel.empty()) add("--channel", pictures.reading.channel);
    if (pictures.reading.invert) line += " --invert";
    if (!(pictures.reading.range == HeightRange{})) add("--range", heightRangeText(pictures.reading.range));
    return line;
}

std::string fieldArguments(double reliefDepth, Address address, Surface surface) {
    const Scenario defaults;
    std::string line;
    const auto add = [&](const std::string& flag, const std::string& value) { addFlag(line, flag, value); };
    if (reliefDepth != defaults.reliefDepth) add("--relief-depth", numberText(reliefDepth));
    if (address != defaults.address) add("--address", std::string(addressName(address)));
    if (surface != defaults.surface) add("--surface", std::string(surfaceName(surface)));
    return line;
}

std::string traceCommand(const Scenario& scenario) {
    std::string line = commandBegin(scenario);
    addView(line, scenario);
    const PixelChoice pixel = scenario.pixel.value_or(PixelChoice{});
    addFlag(line, "--pixel", std::to_string(pixel.x) + "," + std::to_string(pixel.y));
    return line;
}

std::string traceCommand(const Scenario& scenario, const ViewRay& ray) {
    std::string line = commandBegin(scenario);
    addFlag(line, "--ray",
            numberText(ray.s0) + "," + numberText(ray.t0) + "," + numberText(ray.a) + "," + numberText(ray.b));
    return line;
}

std::string renderCommand(const Scenario& scenario) {
    std::string line = commandBegin(scenario, "relief render");
    const auto add = [&](const std::string& flag, const std::string& value) { addFlag(line, flag, value); };
    if (!scenario.pictures.color.empty()) add("--color", scenario.pictures.color);
    if (!scenario.pictures.normal.empty()) add("--normal", scenario.pictures.normal);
    add("--filter", filterText(scenario.filter));
    if (scenario.filter.name == kSupersample) {
        add("--supersample", std::to_string(scenario.filter.samples));
        add("--pixel-model", std::string(pixelModelName(scenario.filter.pixelModel)));
    }
    addView(line, scenario);
    const Light& light = scenario.light;
    add("--light", "azimuth=" + numberText(light.azimuth) + ",elevation=" + numberText(light.elevation) +
                       ",ambient=" + numberText(light.ambient) + ",intensity=" + numberText(light.intensity));
    if (scenario.shadows) line += " --shadows";
    if (!scenario.skip) line += " --no-skip";
    if (scenario.bounded != 0) add("--bounded", numberText(scenario.bounded));
    add("-o", "frame.exr");
    return line;
}

}  // namespace relief
