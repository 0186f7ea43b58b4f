#include <algorithm>
#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

#include "scenario/scenario.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

// The line (from 1) on which the text first names these keys, one after the other: where a fault of a value is.
std::size_t lineOf(const std::string& text, const std::vector<std::string>& path) {
    std::size_t at = 0;
    for (const std::string& key : path) {
        const std::size_t found = text.find('"' + key + '"', at);
        if (found == std::string::npos) break;
        at = found;
    }
    return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

struct Source {
    const std::string& text;
    const std::string& fileName;
};

// One object of the file: hands out its members by name and type, and knows which nobody asked for.
class Reader {
  public:
    Reader(const Source& source, const Json& object, std::vector<std::string> path)
        : source_(source), object_(object), path_(std::move(path)) {
        if (!object.is_object()) fail({}, "an object");
    }

    bool has(const char* key) {
        known_.insert(key);
        return object_.contains(key);
    }
    void read(const char* key, double& value) {
        if (!has(key)) return;
        if (!object_[key].is_number()) fail(key, "a number");
        value = object_[key].get<double>();
    }
    template <class T>
    requires std::integral<T>
    void readWhole(const char* key, T& value) {
        if (!has(key)) return;
        value = wholeAt<T>(key, object_[key]);
    }
    void read(const char* key, bool& value) {
        if (!has(key)) return;
        if (!object_[key].is_boolean()) fail(key, "true or false");
        value = object_[key].get<bool>();
    }
    void read(const char* key, std::string& value) {
        if (!has(key)) return;
        if (!object_[key].is_string()) fail(key, "a text");
        value = object_[key].get<std::string>();
    }
    // An array of exactly N numbers.
    template <std::size_t N>
    bool read(const char* key, std::array<double, N>& values) {
        if (!has(key)) return false;
        const Json& array = object_[key];
        if (!array.is_array() || array.size() != N) fail(key, "an array of " + std::to_string(N) + " numbers");
        for (std::size_t i = 0; i < N; ++i) {
            if (!array[i].is_number()) fail(key, "an array of " + std::to_string(N) + " numbers");
            values[i] = array[i].get<double>();
        }
        return true;
    }
    bool readPair(const char* key, int& first, int& second) {
        if (!has(key)) return false;
        const Json& array = object_[key];
        if (!array.is_array() || array.size() != 2) fail(key, "an array of two whole numbers");
        first = wholeAt<int>(key, array[0]);
        second = wholeAt<int>(key, array[1]);
        return true;
    }
    // Runs what reads a name and says the line if that name is unknown.
    template <class Body>
    void named(const char* key, const Body& body) {
        std::string text;
        if (!has(key)) return;
        read(key, text);
        try {
            body(text);
        } catch (const InputError& error) {
            std::vector<std::string> path = path_;
            path.emplace_back(key);
            throw InputError(source_.fileName, Message(MessageId::ScenarioLine,
                                                       {{"line", lineOf(source_.text, path)}, {"why", error.what()}}));
        }
    }
    Reader child(const char* key) {
        known_.insert(key);
        std::vector<std::string> path = path_;
        path.emplace_back(key);
        return {source_, object_[key], path};
    }
    const Json& object() const { return object_; }
    // Everything may be asked for from now on (the names are the user's own).
    void acceptAll() {
        for (const auto& [key, value] : object_.items()) known_.insert(key);
    }
    void finish() const {
        for (const auto& [key, value] : object_.items()) {
            if (known_.contains(key)) continue;
            std::vector<std::string> path = path_;
            path.push_back(key);
            throw InputError(source_.fileName, Message(MessageId::ScenarioUnknownKey,
                                                       {{"line", lineOf(source_.text, path)}, {"key", key}}));
        }
    }
    [[noreturn]] void fail(const std::string& key, const std::string& wanted) const {
        std::vector<std::string> path = path_;
        if (!key.empty()) path.push_back(key);
        throw InputError(source_.fileName,
                         Message(MessageId::ScenarioWrongType, {{"line", lineOf(source_.text, path)},
                                                                {"key", path.empty() ? "the file" : path.back()},
                                                                {"wanted", wanted}}));
    }

  private:
    template <class T>
    T wholeAt(const char* key, const Json& value) const {
        if (!value.is_number_integer()) fail(key, "a whole number");
        if (value.is_number_unsigned()) {
            const auto number = value.get<std::uint64_t>();
            if (number > static_cast<std::uint64_t>(std::numeric_limits<T>::max())) fail(key, "a smaller number");
            return static_cast<T>(number);
        }
        const auto number = value.get<std::int64_t>();
        if (std::is_unsigned_v<T> || number < static_cast<std::int64_t>(std::numeric_limits<T>::min())) {
            fail(key, "a larger number");
        }
        return static_cast<T>(number);
    }

    Source source_;
    const Json& object_;
    std::vector<std::string> path_;
    std::set<std::string> known_;
};

std::string relativeTo(const std::string& path, const std::string& folder) {
    if (path.empty() || folder.empty()) return path;
    const std::filesystem::path relative =
        std::filesystem::absolute(path).lexically_relative(std::filesystem::absolute(folder));
    const std::string text = relative.generic_string();
    // Outside the folder's tree a path that climbs would break as soon as the file moves.
    return text.empty() || text.starts_with("..") ? std::filesystem::absolute(path).string() : text;
}

void readPictures(Reader reader, Pictures& pictures, const std::filesystem::path& folder) {
    const auto resolve = [&](std::string& path) {
        if (!path.empty() && !folder.empty() && std::filesystem::path(path).is_relative()) {
            path = (folder / path).lexically_normal().string();
        }
    };
    reader.read("height", pictures.height);
    reader.read("color", pictures.color);
    reader.read("normal", pictures.normal);
    for (std::string* path : {&pictures.height, &pictures.color, &pictures.normal}) resolve(*path);
    if (reader.has("recipe")) {
        Reader recipe = reader.child("recipe");
        recipe.read("name", pictures.recipe);
        recipe.readWhole("width", pictures.recipeWidth);
        recipe.readWhole("height", pictures.recipeHeight);
        recipe.readWhole("seed", pictures.seed);
        recipe.finish();
    }
    reader.read("channel", pictures.reading.channel);
    reader.read("invert", pictures.reading.invert);
    reader.named("range", [&](const std::string& text) { pictures.reading.range = parseHeightRange(text); });
    reader.readWhole("max-pixels", pictures.reading.maxPixels);
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
            reader.fail(name, "a number or a text");
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

Json pictureJson(const Pictures& pictures, const std::string& folder) {
    Json json;
    if (!pictures.height.empty()) json["height"] = relativeTo(pictures.height, folder);
    if (!pictures.recipe.empty()) {
        json["recipe"] = {{"name", pictures.recipe},
                          {"width", pictures.recipeWidth},
                          {"height", pictures.recipeHeight},
                          {"seed", pictures.seed}};
    }
    if (!pictures.color.empty()) json["color"] = relativeTo(pictures.color, folder);
    if (!pictures.normal.empty()) json["normal"] = relativeTo(pictures.normal, folder);
    if (!pictures.reading.channel.empty()) json["channel"] = pictures.reading.channel;
    json["invert"] = pictures.reading.invert;
    json["range"] = heightRangeText(pictures.reading.range);
    json["max-pixels"] = pictures.reading.maxPixels;
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

}  // namespace

std::string scenarioText(const Scenario& scenario, const std::string& baseFolder) {
    Json json;
    json["reliefscope"] = kScenarioVersion;
    json["pictures"] = pictureJson(scenario.pictures, baseFolder);
    json["relief"] = {{"depth", scenario.reliefDepth},
                      {"address", addressName(scenario.address)},
                      {"surface", surfaceName(scenario.surface)}};
    json["method"] = {{"name", scenario.method.name}};
    if (!scenario.method.options.empty()) json["method"]["options"] = scenario.method.options;
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
    if (scenario.bounded > 0) json["bounded"] = scenario.bounded;
    json["sky"] = scenario.sky;
    json["size"] = {scenario.width, scenario.height};
    if (scenario.pixel) json["pixel"] = {scenario.pixel->x, scenario.pixel->y};
    json["step"] = scenario.step;
    // Names of files need not be UTF-8; what is not is replaced rather than refused.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Scenario parseScenario(const std::string& text, const std::string& fileName) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size())),
                           '\n');
        throw InputError(fileName, Message(MessageId::ScenarioNotJson, {{"line", line}}));
    } catch (const Json::exception&) {
        // A number beyond double ("1e999"): the library does not say where.
        throw InputError(fileName, Message(MessageId::ScenarioNotJson, {{"line", 1}}));
    }
    const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
    Scenario scenario;
    Reader reader({text, fileName}, json, {});
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
    reader.read("bounded", scenario.bounded);
    reader.read("sky", scenario.sky);
    reader.readPair("size", scenario.width, scenario.height);
    PixelChoice pixel;
    if (reader.readPair("pixel", pixel.x, pixel.y)) scenario.pixel = pixel;
    reader.readWhole("step", scenario.step);
    reader.finish();
    checkScenario(scenario, fileName);
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
