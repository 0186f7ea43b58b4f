#include "fuzz/targets.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "algorithms/images/temporary_folder.h"
#include "base/part_file.h"
#include "filtering/filters/filter_choice.h"
#include "images/picture_bands.h"
#include "images/tiled_heights.h"
#include "images/tiled_writer.h"
#include "measuring/advise/recommend.h"
#include "measuring/bench/measured_method.h"
#include "measuring/bench/pareto.h"
#include "measuring/lesson/lesson.h"
#include "measuring/verify/stress_record.h"
#include "part.h"
#include "relief/files.h"
#include "relief/maps/engine_json.h"
#include "relief/maps/engine_map.h"
#include "relief/reliefs.h"
#include "relief/tracers/map_choice.h"
#include "scenario/ray_files.h"
#include "scenario/row_methods.h"
#include "scenario/scenario.h"

namespace relief::fuzz {

namespace {

// Pixels of a picture and bytes of a map that a reader may take for an input of some kilobytes.
constexpr std::int64_t kMostPixels = 1 << 22;
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

// A folder for the files that readers take by their paths, one per process.
const testing::TemporaryFolder& folder() {
    static const testing::TemporaryFolder kept;
    return kept;
}
std::string inputFile(const std::string& name, std::string_view bytes) {
    return folder().with(name, std::string(bytes));
}

// Readers of pictures try the format that the name promises first.
std::string pictureName(std::string_view bytes) {
    constexpr std::array<std::pair<std::string_view, const char*>, 7> kSigns{{{"\x89PNG", "i.png"},
                                                                              {"II", "i.tif"},
                                                                              {"MM", "i.tif"},
                                                                              {"v/1\x01", "i.exr"},
                                                                              {"\xff\xd8", "i.jpg"},
                                                                              {"BM", "i.bmp"},
                                                                              {"#?", "i.hdr"}}};
    for (const auto& [sign, name] : kSigns) {
        if (bytes.starts_with(sign)) return name;
    }
    return "i.png";
}

const HeightField& someField() {
    static const HeightField field(std::make_shared<FloatImage>(makeRelief("bricks", 16, 16, 1)));
    return field;
}

void readHeightPicture(std::string_view bytes) {
    const std::string path = inputFile(pictureName(bytes), bytes);
    Work work(1);
    HeightReadOptions options;
    options.maxPixels = kMostPixels;
    readHeight(path, options, work);
}

void readColorPicture(std::string_view bytes) {
    const std::string path = inputFile(pictureName(bytes), bytes);
    Work work(1);
    readColor(path, work, kMostPixels);
}

void readScenario(std::string_view bytes) {
    const std::string path = inputFile("s.json", bytes);
    const Scenario scenario = loadScenario(path);
    // What was accepted is written so that it is read and written again as the same text.
    saveScenario(path, scenario);
    const std::string once = testing::bytesOf(path);
    saveScenario(path, loadScenario(path));
    if (testing::bytesOf(path) != once) throw std::logic_error("a saved scenario changes when it is read again");
}

// lesson.json, and behind a line of three dashes its text.
void readLessonFolder(std::string_view bytes) {
    constexpr std::string_view kBetween = "\n---\n";
    const std::size_t end = std::min(bytes.find(kBetween), bytes.size());
    inputFile("lesson.json", bytes.substr(0, end));
    const std::string_view text = end < bytes.size() ? bytes.substr(end + kBetween.size()) : "# A\n";
    for (const char* name : {"text.en.md", "text.uk.md"}) inputFile(name, text);
    readLesson(folder() / "", folder() / "");
}

void readMap(std::string_view bytes) {
    const std::string path = inputFile("m.tif", bytes);
    Work work(1);
    loadMap(path, someField(), kMostBytes, work);
}

// The bytes of a whole tiled map.
const std::string& tiledFile() {
    static const std::string whole = [] {
        const std::string picture = folder() / "whole.png", tiled = folder() / "whole.tif";
        writeHeight(picture, someField().heights());
        Work work(1);
        const auto rows = pictureHeightRows(picture, {});
        TiledWriter(*rows, tiled, {}).write(work);
        return testing::bytesOf(tiled);
    }();
    return whole;
}

// Even a small map of this kind has hundreds of kilobytes, so the input is a list of changes of a whole one: three
// bytes are a position from the file's begin or end, the fourth is the new value there. An input of one byte is a
// length.
void readTiled(std::string_view bytes) {
    std::string changed = tiledFile();
    if (bytes.size() == 1) changed.resize(changed.size() * static_cast<unsigned char>(bytes[0]) / 256);
    for (std::size_t n = 0; n + 3 < bytes.size(); n += 4) {
        const auto byte = [&](std::size_t k) {
            return static_cast<std::size_t>(static_cast<unsigned char>(bytes[n + k]));
        };
        const std::size_t place = byte(0) | byte(1) << 8U | (byte(2) & 127U) << 16U;
        if (place >= changed.size()) continue;
        changed[byte(2) < 128 ? place : changed.size() - 1 - place] = bytes[n + 3];
    }
    const std::string path = inputFile("t.tif", changed);
    if (!TiledHeights::isTiled(path)) return;
    const auto tiles = TiledHeights::open(path, kMostBytes);
    for (int level = 0; level < tiles->levels(); ++level) {
        const int x = tiles->width(level) - 1, y = tiles->height(level) - 1;
        for (const TileKind kind : {TileKind::Max, TileKind::Min, TileKind::Mean}) {
            tiles->value(kind, level, 0, 0);
            tiles->value(kind, level, x, y);
        }
    }
    for (int x = 0; x + 1 < tiles->width(); ++x) tiles->corners(x, x + 1, 0, 0);
}

// Lines of journals, of parts of a run, and of records of stress tests.
void readJournal(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        const std::string_view line = bytes.substr(0, end);
        app::parsePartLine(line);
        parseStressCase(line);
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
}

void readBand(std::string_view bytes) {
    const std::string path = inputFile(pictureName(bytes), bytes);
    readBandFile(path);
}

void readRays(std::string_view bytes) {
    parseRays(bytes, "r.csv");
}
void readHits(std::string_view bytes) {
    parseHits(bytes, "h.csv");
}
void readSteps(std::string_view bytes) {
    StepLog log = parseSteps(bytes, "s.csv", 3);
    placeSteps(stepsOf(log, 0), {1, 1, 3, 2}, someField(), "s.csv", 0);
    answerOf(stepsOf(log, 0), {1, 1, 3, 2});
}
void readSidecar(std::string_view bytes) {
    parseEngineJson(std::string(bytes), "m.json");
}
void readReport(std::string_view bytes) {
    (bytes.starts_with("{") || bytes.starts_with("[")) ? parseBenchJson(std::string(bytes), "b.json")
                                                       : parseBenchCsv(std::string(bytes), "b.csv");
}

// Values of options: each reader gets the whole text.
void readArguments(std::string_view bytes) {
    const std::string text(bytes);
    const auto tried = [&](const auto& read) {
        try {
            read();
        } catch (const InputError&) {
        }
    };
    tried([&] { parseNumber(text, "--x"); });
    tried([&] { parseHeightRange(text); });
    tried([&] { parseMethodChoice(text, "--tracer"); });
    tried([&] { parseFilter(text, "--filter"); });
    tried([&] { parseMapping(text, "--mapping"); });
    tried([&] { parseRowMethod(text, "--rows"); });
    tried([&] { parseRayText(text, "--ray"); });
    tried([&] { parseViews(text, "--views"); });
    tried([&] { parseEnginePack(text, "--pack"); });
    tried([&] { app::parsePartNumber(text); });
}

constexpr std::array<Target, 14> kTargets{{{"height", readHeightPicture},
                                           {"color", readColorPicture},
                                           {"scenario", readScenario},
                                           {"lesson", readLessonFolder},
                                           {"map", readMap},
                                           {"tiled", readTiled},
                                           {"journal", readJournal},
                                           {"band", readBand},
                                           {"rays", readRays},
                                           {"hits", readHits},
                                           {"steps", readSteps},
                                           {"sidecar", readSidecar},
                                           {"report", readReport},
                                           {"arguments", readArguments}}};

}  // namespace

std::span<const Target> targets() {
    return kTargets;
}

void run(const Target& target, std::string_view bytes) {
    try {
        target.read(bytes);
    } catch (const InputError&) {
        // Also MemoryError and WorkError: the program says one line.
    }
}

}  // namespace relief::fuzz
