// relief info FILE... [--json]
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "help_formatter.h"
#include "images/tiled_heights.h"
#include "installed.h"
#include "options_common.h"
#include "output.h"
#include "scenario/scenario.h"
#include "scenario/text_lines.h"

namespace relief::app {

namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
    std::vector<std::string> files;
    ReadingOptions reading;
    bool json = false;
    RunOptions run;
};

// Lines of the form "  label       value".
class Table {
  public:
    explicit Table(Language language) : language_(language) {}

    void title(const std::string& text) { out_ += text + "\n"; }
    void row(MessageId label, const std::string& value) {
        constexpr std::size_t kLabelColumns = 24;
        const std::string name = sentence(Message(label), language_);
        const std::size_t width = characterCount(name);
        out_ += "  " + name + std::string(width < kLabelColumns ? kLabelColumns - width : 1, ' ') + value + "\n";
    }
    void row(MessageId label, const Message& value) { row(label, sentence(value, language_)); }
    const std::string& text() const { return out_; }

  private:
    Language language_;
    std::string out_;
};

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

std::string interval(double low, double high) {
    return numberText(low, 6) + " .. " + numberText(high, 6);
}

struct PictureFacts {
    HeightImage image;
    double low = 1;
    double high = 0;
    double mean = 0;
};

PictureFacts pictureFacts(const std::string& path, const HeightReadOptions& reading, Session& session) {
    PictureFacts facts{readHeight(path, reading, session.work())};
    for (const float h : facts.image.heights.pixels()) {
        facts.low = std::min(facts.low, static_cast<double>(h));
        facts.high = std::max(facts.high, static_cast<double>(h));
        facts.mean += static_cast<double>(h);
    }
    facts.mean /= static_cast<double>(facts.image.heights.size());
    return facts;
}

std::string pictureInfo(const std::string& path, const PictureFacts& facts, Session& session) {
    const HeightImage& image = facts.image;
    Table table(session.language());
    table.title(path);
    table.row(MessageId::InfoFormat, image.info.format);
    table.row(MessageId::InfoSize, sizeText(image.info.width, image.info.height));
    table.row(MessageId::InfoChannels, commaList(image.info.channels));
    table.row(MessageId::InfoType, image.info.type);
    if (!image.info.colorSpace.empty()) table.row(MessageId::InfoColorSpace, image.info.colorSpace);
    table.row(MessageId::InfoHeightChannel, image.channel);
    table.row(MessageId::InfoFileValues, interval(image.fileLow, image.fileHigh));
    table.row(MessageId::InfoHeights, interval(facts.low, facts.high));
    table.row(MessageId::InfoMeanHeight, numberText(facts.mean, 6));
    for (const Message& note : image.notes) table.row(MessageId::InfoNote, note);
    return table.text();
}

// Returns the same facts as JSON, in English.
Json pictureJson(const std::string& path, const PictureFacts& facts) {
    const HeightImage& image = facts.image;
    Json json{{"file", path},
              {"kind", "picture"},
              {"format", image.info.format},
              {"width", image.info.width},
              {"height", image.info.height},
              {"channels", image.info.channels},
              {"type", image.info.type},
              {"color_space", image.info.colorSpace},
              {"height_channel", image.channel},
              {"file_values", {image.fileLow, image.fileHigh}},
              {"heights", {facts.low, facts.high}},
              {"mean_height", facts.mean},
              {"notes", Json::array()}};
    for (const Message& note : image.notes) json["notes"].push_back(sentence(note));
    return json;
}

// A tiled pyramid is not read as a whole: its coarsest levels are the extremes and the mean of all heights.
struct TiledFacts {
    std::shared_ptr<const TiledHeights> heights;
    std::string type{};
    std::size_t pages = 0;
    double low = 0, high = 0, mean = 0;
};

TiledFacts tiledFacts(const std::string& path) {
    constexpr std::size_t kResident = std::size_t{1} << 20;
    TiledFacts facts{.heights = TiledHeights::open(path, kResident)};
    const TiledHeights& heights = *facts.heights;
    const int top = heights.levels() - 1;
    facts.type = heights.type() == NumberType::UInt8    ? "uint8"
                 : heights.type() == NumberType::UInt16 ? "uint16"
                                                        : "float";
    facts.pages = heights.layout().pages.size() + 1;
    facts.low = static_cast<double>(heights.minimum(top, 0, 0));
    facts.high = static_cast<double>(heights.maximum(top, 0, 0));
    facts.mean = static_cast<double>(heights.mean(top, 0, 0));
    heights.requireWhole();
    return facts;
}

std::string tiledInfo(const std::string& path, const TiledFacts& facts, Session& session) {
    const TiledHeights& heights = *facts.heights;
    Table table(session.language());
    table.title(path);
    table.row(MessageId::InfoFormat, Message(MessageId::InfoTiled));
    table.row(MessageId::InfoSize, sizeText(heights.width(), heights.height()));
    table.row(MessageId::InfoType, facts.type);
    table.row(MessageId::InfoPages,
              Message(MessageId::InfoTiledPages,
                      {{"count", facts.pages}, {"levels", heights.levels() - 1}, {"side", kTileSide}}));
    table.row(MessageId::InfoFileBytes, std::to_string(heights.layout().fileBytes));
    table.row(MessageId::InfoHeights, interval(facts.low, facts.high));
    table.row(MessageId::InfoMeanHeight, numberText(facts.mean, 6));
    return table.text();
}

Json tiledJson(const std::string& path, const TiledFacts& facts) {
    const TiledHeights& heights = *facts.heights;
    return {{"file", path},
            {"kind", "tiled"},
            {"format", "tiff"},
            {"width", heights.width()},
            {"height", heights.height()},
            {"type", facts.type},
            {"levels", heights.levels()},
            {"pages", facts.pages},
            {"tile_side", kTileSide},
            {"bytes", heights.layout().fileBytes},
            {"heights", {facts.low, facts.high}},
            {"mean_height", facts.mean}};
}

std::string cameraText(const Camera& camera) {
    const std::string fov = ", fov " + numberText(camera.fov);
    if (camera.kind == Camera::Kind::Free) {
        const auto point = [](glm::dvec3 p) { return numberText(p.x) + "," + numberText(p.y) + "," + numberText(p.z); };
        return "eye " + point(camera.eye) + ", target " + point(camera.target) + fov;
    }
    return "elevation " + numberText(camera.elevation) + ", azimuth " + numberText(camera.azimuth) + ", distance " +
           numberText(camera.distance) + fov;
}

std::string methodText(const MethodChoice& method) {
    std::string text = method.name;
    for (const auto& [name, value] : method.options) text += " " + name + "=" + value;
    return text;
}

std::string scenarioInfo(const std::string& path, Session& session) {
    const Scenario scenario = loadScenario(path);
    const Pictures& pictures = scenario.pictures;
    Table table(session.language());
    table.title(path);
    table.row(MessageId::InfoFormat, Message(MessageId::InfoScenario, {{"version", kScenarioVersion}}));
    const bool recipe = pictures.height.empty() && pictures.drawn.empty();
    table.row(MessageId::InfoHeightMap, recipe ? pictures.recipe + " " +
                                                     sizeText(pictures.recipeWidth, pictures.recipeHeight) + ", seed " +
                                                     std::to_string(pictures.seed)
                                               : heightsName(pictures));
    if (!pictures.color.empty()) table.row(MessageId::InfoColor, pictures.color);
    if (!pictures.normal.empty()) table.row(MessageId::InfoNormals, pictures.normal);
    table.row(MessageId::InfoRelief, std::string(surfaceName(scenario.surface)) + ", " +
                                         std::string(addressName(scenario.address)) + ", depth " +
                                         numberText(scenario.reliefDepth));
    table.row(MessageId::InfoTracer, methodText(scenario.method));
    table.row(MessageId::InfoFilter, scenario.filter.name);
    table.row(MessageId::InfoScene, std::string(sceneName(scenario.scene)));
    table.row(MessageId::InfoCamera, cameraText(scenario.camera));
    table.row(MessageId::InfoPicture, sizeText(scenario.width, scenario.height));
    if (scenario.pixel) {
        table.row(MessageId::InfoPixel, std::to_string(scenario.pixel->x) + "," + std::to_string(scenario.pixel->y));
    }
    return table.text();
}

int runInfo(const InfoOptions& options, Session& session) {
    options.run.apply(session);
    if (options.files.empty()) needed(std::nullopt, "FILE", "info");
    HeightReadOptions reading;
    options.reading.apply(reading);
    std::string text;
    Json all = Json::array();
    for (const std::string& file : options.files) {
        const std::string path = shippedFile(file);
        const bool tiled = TiledHeights::isTiled(path);
        if (const std::string given = options.reading.given(); !given.empty() && (tiled || isScenarioFile(path))) {
            throw InputError(given, Message(MessageId::ArgumentsExclude, {{"other", path}}));
        }
        if (tiled) {
            const TiledFacts facts = tiledFacts(path);
            if (options.json) {
                all.push_back(tiledJson(path, facts));
            } else {
                text += tiledInfo(path, facts, session);
            }
            continue;
        }
        if (isScenarioFile(path)) {
            if (options.json) {
                all.push_back({{"file", path},
                               {"kind", "scenario"},
                               {"scenario", Json::parse(scenarioText(loadScenario(path)))}});
            } else {
                text += scenarioInfo(path, session);
            }
            continue;
        }
        const PictureFacts facts = pictureFacts(path, reading, session);
        if (options.json) {
            all.push_back(pictureJson(path, facts));
        } else {
            text += pictureInfo(path, facts, session);
        }
    }
    session.eraseBar();
    // File names need not be valid UTF-8.
    const Json& shown = all.size() == 1 ? all.front() : all;
    if (options.json) text = shown.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    writeStandardOutput(text, session.stop());
    return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* parser =
        addCommand(program, "info", "show what a picture or scenario contains and how it will be read",
                   "Shows a picture's size, channels, type and range, the channel that will be used for heights and "
                   "the scaling of its numbers to heights in [0, 1]; of a scenario (.json), its pictures, method, "
                   "camera and scene; of a map written by relief tile, its pages, without reading all of it. The "
                   "options for reading take effect as in the other commands.",
                   "  relief info heights.png --channel R --range 0,200\n"
                   "  relief info *.png --json");
    parser->add_option("FILE", options->files, "pictures, or scenarios and reports (.json)")
        ->type_name("")
        ->group("Arguments")
        ->option_text(kNeeded);
    addFlag(*parser, "--json", options->json,
            "write JSON instead of text: an object, or an array of objects for several files", "Output");
    options->reading.add(*parser);
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runInfo(*options, session); }});
}

}  // namespace relief::app
