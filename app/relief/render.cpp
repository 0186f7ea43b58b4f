// relief render [PICTURE | SCENARIO.json] [options] -o FILE [--layers NAME,...] [--report FILE.json | --part K/N]
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>

#include <nlohmann/json.hpp>

#include "images/file_replacing.h"
#include "images/picture_bands.h"
#include "images/placed_file.h"
#include "one_picture.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "parts_run.h"
#include "render_many.h"
#include "scratch_folder.h"
#include "team.h"

namespace relief::app {

namespace {

// Largest picture, in pixels, that is not written in tiles unless --tiled is given, if its format has tiles.
constexpr std::int64_t kMostWholePixels = std::int64_t{1} << 26;
// File name endings of the formats that have tiles.
const std::vector<std::string> kTileEndings{"tif", "tiff", "exr"};
// Largest side of a .jpg, .bmp or .hdr, pixels.
constexpr int kMaxOtherSide = 1 << 15;

struct RenderOptions {
    ScenarioOptions scenario;
    ManyFrames many;
    OptionText output, layers, report, part;
    bool tiled = false;
    RunOptions run;
};

// Empty if no layers were requested.
std::vector<std::string> checkedLayers(const RenderOptions& options, const std::string& output) {
    if (!options.layers) return {};
    if (fileEnding(output) != "exr") throw InputError(output, Message(MessageId::LayersNeedExr));
    std::vector<std::string> layers = splitText(*options.layers, ',');
    const std::string known = commaList(layerNames());
    for (const std::string& layer : layers) {
        const auto& names = layerNames();
        if (std::count(layers.begin(), layers.end(), layer) > 1) {
            throw InputError("--layers", Message(MessageId::LayerRepeated, {{"layer", layer}}));
        }
        if (std::find(names.begin(), names.end(), layer) != names.end()) continue;
        throw InputError("--layers", unknownName({"what", MessageId::WordLayer}, layer, known));
    }
    return layers;
}

// Returns the line that identifies the part and holds what `relief merge` needs. height: of the whole picture. run:
// OnePicture::run().
std::string partText(const PartNumber& number, const RowRange& rows, bool tiled, int height, Json run) {
    Part part;
    static_cast<PartNumber&>(part) = number;
    part.run = std::move(run);
    part.more = {{"first", rows.begin}, {"end", rows.end}, {"height", height}};
    if (tiled) part.more["tiled"] = true;
    return partLine(part);
}

// Renders the picture in bands shared by the ranks of an MPI run; rank 0 joins them. There are more bands than ranks,
// because some bands cost more than others.
void renderShared(OnePicture& picture, const std::string& output, Session& session) {
    constexpr int kBandsEach = 4;
    const int bands = std::min(picture.height(), kBandsEach * launchedProcesses());
    const std::string ending = "." + fileEnding(output);
    const ScratchFolder scratch;
    const auto bandPath = [&](std::size_t band) { return scratch.path(std::to_string(band) + ending); };
    PartsRun run;
    run.bar = "render";
    run.parts = static_cast<std::size_t>(bands);
    run.measure = [&](const Task& task, Work& work) -> Json {
        const RowRange rows = partRows({static_cast<int>(task.part) + 1, bands}, picture.height());
        picture.write(bandPath(task.part), rows, {}, work);
        return launchedRank() == 0 ? Json() : ScratchFolder::take(bandPath(task.part));
    };
    run.received = [&](std::size_t band, Json result) -> Json {
        if (result.is_binary()) writeBytes(bandPath(band), result.get_binary());
        return nullptr;
    };
    if (!doParts(run, session)) return;
    std::vector<std::string> files;
    for (std::size_t band = 0; band < run.parts; ++band) files.push_back(bandPath(band));
    joinBands(files, output, session.work());
}

// The rows of a part of a picture in tiles: whole rows of tiles, so that parts are joined by copying.
RowRange tiledPartRows(const PartNumber& number, int height) {
    constexpr int kSide = PictureLayout::kGroup;
    const int tiles = (height + kSide - 1) / kSide;
    if (number.of > tiles) {
        throw InputError("--part",
                         Message(MessageId::PartTileRows, {{"of", number.of}, {"rows", tiles}, {"side", kSide}}));
    }
    const RowRange rows = partRows(number, tiles);
    return {rows.begin * kSide, std::min(rows.end * kSide, height)};
}

// The rows that are made, kept and sent at a time. Few enough that they take little memory (about 60 bytes a pixel with
// supersampling) and that little is lost by a run that is stopped; many enough that the rays above and below, which
// some filters need, cost little.
int blockRows(int width, int rows) {
    constexpr int kBlockPixels = 1 << 23, kBlocks = 16, kSide = PictureLayout::kGroup;
    return std::max(std::min(kBlockPixels / width, rows / kBlocks) / kSide, 1) * kSide;
}

// Renders the picture, or a part of it, row of tiles by row of tiles into its file, alone or with the other ranks of an
// MPI run.
void renderTiled(OnePicture& picture, const RenderOptions& options, const PartNumber& number, const std::string& output,
                 Session& session) {
    const RowRange all = tiledPartRows(number, picture.height());
    const int block = blockRows(picture.width(), all.count());
    const auto rowsOf = [&](std::size_t part) {
        const int begin = all.begin + static_cast<int>(part) * block;
        return RowRange{begin, std::min(begin + block, all.end)};
    };
    picture.requireMemory(rowsOf(0), true);
    const bool exr = fileEnding(output) == "exr";
    const Json what = picture.run();
    const PictureLayout layout({exr, picture.width(), picture.height(), all.begin, all.end, picture.channels(),
                                options.part ? partText(number, all, true, picture.height(), what) : std::string()});
    std::optional<PlacedFile> file;
    const bool leads = leadsRun(options.part.has_value());
    if (leads) file.emplace(output, layout);
    const auto put = [&](std::size_t part, std::span<const std::byte> bytes) -> Json {
        return {{"block", part}, {"checksum", std::to_string(file->write(rowsOf(part).begin, bytes))}};
    };
    PartsRun run;
    run.bar = "render";
    run.parts = static_cast<std::size_t>((all.count() + block - 1) / block);
    // Both files of an unfinished picture stand next to the file that is replaced in the end.
    run.output = linkTarget(output);
    run.work = {{"run", what}, {"rows", {all.begin, all.end, block}}};
    run.earlier = options.many.restart.chosen();
    run.alone = options.part.has_value();
    run.started = [&](bool resumed) { file->open(resumed); };
    run.readable = [&](const Json& result) {
        const std::int64_t part = numberIn(result, "block", -1);
        if (part < 0 || static_cast<std::size_t>(part) >= run.parts) return false;
        const RowRange rows = rowsOf(static_cast<std::size_t>(part));
        const std::string checksum = textIn(result, "checksum");
        return file->holds(rows.begin, rows.count(), std::strtoull(checksum.c_str(), nullptr, 10));
    };
    run.measure = [&](const Task& task, Work& work) -> Json {
        const RowRange rows = rowsOf(task.part);
        const auto bytes = layout.encoded(rows.begin, rows.count(), picture.numbers(rows, exr, work).data());
        if (leads) return put(task.part, bytes);
        const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
        return Json::binary(std::vector<std::uint8_t>(first, first + bytes.size()));
    };
    run.received = [&](std::size_t part, Json result) -> Json {
        return result.is_binary() ? put(part, std::as_bytes(std::span(result.get_binary()))) : result;
    };
    const auto done = doParts(run, session);
    if (!done) return;
    file->finish();
    done->journal->finish();
}

// Returns true if pictures with this file name ending can be written in tiles.
bool canTile(const std::string& ending) {
    return std::find(kTileEndings.begin(), kTileEndings.end(), ending) != kTileEndings.end();
}

// Throws InputError if the format cannot hold the picture.
void checkSides(const Scenario& scenario, const std::string& output) {
    const std::string ending = fileEnding(output);
    if (ending == "png" || canTile(ending)) return;
    if (std::max(scenario.width, scenario.height) <= kMaxOtherSide) return;
    throw InputError(output, Message(MessageId::PictureSidesOf, {{"width", scenario.width},
                                                                 {"height", scenario.height},
                                                                 {"limit", kMaxOtherSide},
                                                                 {"known", ".png, .tif, .exr"}}));
}

void checkExcluded(const RenderOptions& options, bool shared) {
    const auto exclude = [](const char* option, const char* other) {
        throw InputError(option, Message(MessageId::ArgumentsExclude, {{"other", other}}));
    };
    if (options.report && (options.part || options.many.requested() || shared || options.tiled)) {
        exclude("--report", options.part ? "--part" : shared ? "mpirun" : options.tiled ? "--tiled" : "--frames");
    }
    if (options.tiled && options.many.requested()) exclude("--tiled", "--frames");
}

int runRender(const RenderOptions& options, Session& session) {
    options.run.apply(session, options.part.has_value());
    const std::string& output = needed(options.output, "--output", "render");
    const PartNumber number = options.part ? parsePartNumber(*options.part) : PartNumber();
    const bool shared = launchedProcesses() > 1 && !options.part && !options.many.requested();
    checkExcluded(options, shared);
    if (options.many.requested()) {
        return options.many.run(options.scenario, output, checkedLayers(options, "picture.exr"), number, session);
    }
    std::vector<std::string> endings = kTileEndings;
    if (!options.tiled) endings.insert(endings.begin(), "png");
    if (!options.part && !shared && !options.tiled) endings.insert(endings.end(), {"jpg", "jpeg", "bmp", "hdr"});
    if (leadsRun(options.part.has_value())) checkOutput(output, endings);
    const std::vector<std::string> layers = checkedLayers(options, output);
    if (options.report && *options.report != "-") checkOutput(*options.report, {"json"});
    const Scenario scenario = options.scenario.scenario();
    checkSides(scenario, output);
    const std::vector<std::string> inputs = inputFiles(options.scenario, scenario);
    refuseOverwriting("--output", output, inputs);
    refuseOverwriting("--report", options.report.value_or(""), inputs);
    const bool huge = std::int64_t{scenario.width} * scenario.height > kMostWholePixels;
    OnePicture picture(options.scenario, scenario, layers, options.report.has_value(), session);
    if (options.tiled || (huge && canTile(fileEnding(output)) && !options.report)) {
        renderTiled(picture, options, number, output, session);
        picture.noteTilesRead();
        return 0;
    }
    if (options.many.restart.given()) {
        throw InputError("--resume, --anew",
                         Message(MessageId::NeedsEither, {{"other", "--tiled"}, {"another", "--frames"}}));
    }
    const RowRange rows = options.part ? partRows(number, picture.height()) : RowRange();
    picture.requireMemory(rows, false);
    if (shared) {
        renderShared(picture, output, session);
        return 0;
    }
    picture.write(output, rows,
                  options.part ? partText(number, rows, false, picture.height(), picture.run()) : std::string(),
                  session.work());
    picture.noteTilesRead();
    if (options.report) picture.report(*options.report);
    return 0;
}

}  // namespace

void addRenderCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* parser =
        addCommand(program, "render", "render a picture of a relief",
                   "Renders a floor, a wall or a cube that carries the relief of a height map, as seen by a camera. "
                   "Scene, camera and methods come from a scenario, from options, or from both; options override the "
                   "scenario. The same input gives the same pixels on any number of threads. mpirun -n N relief render "
                   "... shares one picture (.png, .tif, .exr) or many among N processes. A picture larger than memory, "
                   "up to 65536 pixels a side, is written in tiles into a .tif or .exr without compression, and a run "
                   "that was stopped goes on with --resume.",
                   "  relief render heights.png --color color.jpg --scene wall \\\n"
                   "      --camera elevation=20,azimuth=30,distance=1.4 --size 800x600 -o wall.png --report wall.json\n"
                   "  relief render heights.png --size 40000x40000 -o huge.tif");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::All);
    options->scenario.addMemory(*parser);
    options->many.add(*parser);
    addOutput(*parser, options->output, "file of the picture: .png, .jpg, .tif, .bmp (sRGB), .exr, .hdr (linear)");
    addText(*parser, "--layers", options->layers, "NAME,...",
            "layers to write into the .exr instead of only the picture: " + commaList(layerNames()), "Output");
    addFlag(*parser, "--tiled", options->tiled,
            "write the picture (.tif, .exr) row of tiles by row of tiles as it is made, so that memory grows with its "
            "width only, and finished rows are kept in FILE.part and FILE.rows until the picture is complete; always "
            "so above " +
                std::to_string(kMostWholePixels) + " pixels in these formats, unless there is --report",
            "Output");
    addText(
        *parser, "--part", options->part, "K/N",
        "render only part K, from 1, of N, so that other processes can render the other parts. One picture (.png, "
        ".tif, .exr): a band of its rows, in tiles a band of rows of tiles; relief merge joins them. Many pictures: "
        "every N-th one",
        "Output");
    addText(
        *parser, "--report", options->report, "FILE.json",
        "report of the work done and skipped: scenario, counters, maps built, seconds per stage; - for standard output",
        "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runRender(*options, session); }});
}

}  // namespace relief::app
