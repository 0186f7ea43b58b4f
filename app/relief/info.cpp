// relief info FILE
#include "installed.h"
#include "options_common.h"
#include "output.h"
#include "scenario/scenario.h"

namespace relief::app {

namespace {

struct InfoOptions {
    OptionText file;
    ReadingOptions reading;
    RunOptions run;
};

// One line "  label       value".
class Table {
  public:
    explicit Table(Language language) : language_(language) {}

    void title(const std::string& text) { out_ += text + "\n"; }
    void row(MessageId label, const std::string& value) {
        constexpr std::size_t kLabelColumns = 24;
        const std::string name = sentence(Message(label), language_);
        // Columns are characters, not bytes: Ukrainian letters take two.
        std::size_t width = 0;
        for (const char c : name) width += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
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

std::string pictureInfo(const std::string& path, const HeightReadOptions& reading, Session& session) {
    const HeightImage image = readHeight(path, reading, session.work());
    const std::string channels = commaList(image.info.channels);
    float low = 1;
    float high = 0;
    double sum = 0;
    for (const float h : image.heights.pixels()) {
        low = std::min(low, h);
        high = std::max(high, h);
        sum += static_cast<double>(h);
    }
    Table table(session.language());
    table.title(path);
    table.row(MessageId::InfoFormat, image.info.format);
    table.row(MessageId::InfoSize, sizeText(image.info.width, image.info.height));
    table.row(MessageId::InfoChannels, channels);
    table.row(MessageId::InfoType, image.info.type);
    if (!image.info.colorSpace.empty()) table.row(MessageId::InfoColorSpace, image.info.colorSpace);
    table.row(MessageId::InfoHeightChannel, image.channel);
    table.row(MessageId::InfoFileValues, interval(image.fileLow, image.fileHigh));
    table.row(MessageId::InfoHeights, interval(static_cast<double>(low), static_cast<double>(high)));
    table.row(MessageId::InfoMeanHeight, numberText(sum / static_cast<double>(image.heights.size()), 6));
    for (const Message& note : image.notes) table.row(MessageId::InfoNote, note);
    return table.text();
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
    const std::string path = shippedFile(needed(options.file, "FILE", "info"));
    HeightReadOptions reading;
    options.reading.apply(reading);
    const bool isScenario = fileEnding(path) == "json";
    const std::string text = isScenario ? scenarioInfo(path, session) : pictureInfo(path, reading, session);
    session.eraseBar();
    writeStandardOutput(text, session.stop());
    return 0;
}

}  // namespace

void addInfoCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* parser = addCommand(
        program, "info", "what a picture or scenario holds, and what will be done with it",
        "Tells a picture's size, channels, type and range, which channel will be taken for heights and how its numbers "
        "become heights in [0, 1]; of a scenario (.json), what it looks at and how. The reading options show what they "
        "would change.",
        "  relief info heights.png --channel R --range 0,200");
    addArgument(*parser, "FILE", options->file, "a picture, or a scenario (.json)");
    options->reading.add(*parser);
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runInfo(*options, session); }});
}

}  // namespace relief::app
