#include "render_many.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "output.h"
#include "parts_run.h"
#include "relief/files.h"
#include "relief/memory.h"
#include "scenario/sequence.h"
#include "scratch_folder.h"
#include "team.h"

namespace relief::app {

namespace {

// Pictures of at most this many pixels keep the results of their stages for the next picture, in 190 MB.
constexpr int kKeptPixels = 1 << 20;

struct Picture {
    std::size_t scenario;
    Camera camera;
    std::string name;  // file name without the folder
};

double between(double from, double to, double share) {
    return share == 1 ? to : from + (to - from) * share;
}

Camera between(const Camera& from, const Camera& to, double share) {
    Camera camera = from;
    camera.elevation = between(from.elevation, to.elevation, share);
    camera.azimuth = between(from.azimuth, to.azimuth, share);
    camera.distance = between(from.distance, to.distance, share);
    camera.fov = between(from.fov, to.fov, share);
    return camera;
}

// Renders the pictures one by one and keeps what the next one may need: heights, maps, the filter's levels, buffers of
// a band.
class Studio {
  public:
    // path: the pictures are frames of camera paths.
    Studio(const ScenarioOptions& options, std::vector<Scenario> scenarios, bool path, Session& session)
        : options_(options), scenarios_(std::move(scenarios)), path_(path), session_(session) {}

    void render(const Picture& picture, const std::string& path, const std::vector<std::string>& layers, Work& work) {
        Scenario& scenario = scenarios_[picture.scenario];
        const Assets assets = store_.load(scenario.pictures, work, true);
        const bool first = seen_.insert(picture.scenario).second;
        if (first) {
            if (noted_.insert(heightsName(scenario.pictures)).second) noteHeights(session_, assets, scenario);
            options_.useStoredMap(scenario, assets, *maps_, work);
        }
        FrameRequest request = frameRequest(scenario, assets);
        request.camera = picture.camera;
        if (first) requirePictureMemory(request, layers, {}, session_);
        PictureParts parts;
        parts.counts = std::find(layers.begin(), layers.end(), "steps") != layers.end();
        std::optional<LayerPlanes> planes;
        if (!layers.empty()) {
            planes.emplace(request, layers, *maps_);
            parts.done = [&](const Frame& part) { planes->add(part, request, work); };
        }
        const auto frame = keepsStages(request) ? kept(request, parts, work) : renderer_.picture(request, work, parts);
        if (planes) {
            writePlanes(path, planes->take(*frame));
        } else {
            writeColor(path, frame->light->color);
        }
    }

  private:
    // Consecutive scenarios may differ in the light only, so that stages can be reused; frames of a camera path share
    // none.
    bool keepsStages(const FrameRequest& request) const {
        return scenarios_.size() > 1 && !path_ && request.width <= kKeptPixels / request.height;
    }
    std::shared_ptr<const Frame> kept(const FrameRequest& request, const PictureParts& parts, Work& work) {
        auto frame = renderer_.render(request, work);
        if (parts.counts) frame = renderer_.counted(work);
        if (parts.done) parts.done(*frame);
        return frame;
    }

    const ScenarioOptions& options_;
    std::vector<Scenario> scenarios_;
    bool path_;
    Session& session_;
    AssetStore store_;
    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
    FrameRenderer renderer_{maps_, true};
    std::set<std::size_t> seen_;
    std::set<std::string> noted_;  // names of height maps, whose notes are printed once
};

// What is rendered, and its description in the journal.
struct PictureList {
    std::string ending;
    std::vector<Scenario> scenarios;
    std::vector<Picture> pictures;
    std::set<std::string> inputs;  // the scenarios' own pictures
    Json what;

    // to: the end of the camera path.
    void addPath(const Scenario& scenario, const OptionText& to, std::int64_t frames, const std::string& stem) {
        Scenario end = scenario;
        if (to) {
            if (scenario.camera.kind != Camera::Kind::Orbit) {
                throw InputError("--to", Message(MessageId::ArgumentsExclude, {{"other", "--eye"}}));
            }
            applyOrbit(end, *to, "--to");
        }
        for (std::int64_t f = 0; f < frames; ++f) {
            const double share = frames > 1 ? static_cast<double>(f) / static_cast<double>(frames - 1) : 0;
            const std::string name = frames > 1 ? frameName(stem, static_cast<std::size_t>(f)) : stem;
            pictures.push_back({scenarios.size(), between(scenario.camera, end.camera, share), name + ending});
        }
        describe("scenarios", scenario);
        describe("ends", std::move(end));
        scenarios.push_back(scenario);
    }
    void addSweep(std::vector<SequenceFrame> frames, const std::string& stem) {
        for (std::size_t f = 0; f < frames.size(); ++f) {
            Scenario& scenario = frames[f].scenario;
            pictures.push_back({scenarios.size(), scenario.camera, frameName(stem, f) + ending});
            describe("scenarios", scenario);
            scenarios.push_back(std::move(scenario));
        }
    }
    // Adds the files' sizes and times to the description, so that pictures of an edited map are not mixed with earlier
    // ones.
    void describeInputs() {
        for (const std::string& input : inputs) {
            struct stat file {};
            if (stat(input.c_str(), &file) != 0) continue;
            what["files"].push_back({file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec});
        }
    }

  private:
    void describe(const char* list, Scenario scenario) {
        const Pictures& files = scenario.pictures;
        for (const std::string& file : {files.height, files.color, files.normal}) {
            if (!file.empty()) inputs.insert(file);
        }
        scenario.ui.clear();  // the window's state does not affect pictures
        what[list].push_back(scenarioText(scenario));
    }
};

void makeFolder(const std::string& folder) {
    std::error_code error, none;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder, none)) {
        throw WorkError(folder, Message(MessageId::FileUnwritable, {{"why", error.message()}}));
    }
}

// Lists the pictures of all files. frames: of the camera path of each, if there is no sweep.
PictureList listed(const ManyFrames& many, const ScenarioOptions& options, const std::vector<std::string>& layers,
                   const std::optional<Sequence>& swept, std::int64_t frames) {
    std::vector<OptionText> files{options.file()};
    files.insert(files.end(), many.more.begin(), many.more.end());
    PictureList list;
    list.ending = layers.empty() ? ".png" : ".exr";
    list.what = {{"kind", "render"}, {"layers", layers}};
    std::set<std::string> stems;
    for (const OptionText& file : files) {
        const std::string stem = file ? std::filesystem::path(*file).stem().string() : "frame";
        if (!stems.insert(stem).second) throw InputError(*file, Message(MessageId::ArgumentRepeated));
        const Scenario scenario = options.scenario(file);
        if (swept) {
            list.addSweep(framesOf(*swept, scenario, "--sweep"), stem);
        } else {
            list.addPath(scenario, many.to, frames, stem);
        }
    }
    // Each is written only if there is one, so that a run of an earlier version that has none of them can be resumed.
    if (frames > 1) list.what["frames"] = frames;
    list.describeInputs();
    if (const std::string map = options.mapContent(); !map.empty()) list.what["map"] = map;
    return list;
}

// Throws InputError if one of the pictures would replace a file that the run reads.
void refuseReplacing(const PictureList& list, const ManyFrames& many, const ScenarioOptions& options,
                     const std::string& folder) {
    std::vector<std::string> inputs(list.inputs.begin(), list.inputs.end());
    inputs.insert(inputs.end(), many.more.begin(), many.more.end());
    for (const OptionText& file : {options.file(), options.map()}) inputs.push_back(file.value_or(""));
    for (const Picture& picture : list.pictures) {
        refuseOverwriting("--output", folder, inputs, (std::filesystem::path(folder) / picture.name).string());
    }
}

}  // namespace

void requirePictureMemory(const FrameRequest& request, const std::vector<std::string>& layers, const PictureMemory& how,
                          Session& session) {
    const int threads = session.work().threads().size();
    const int rows = how.rows.orAll(request.height).count();
    const auto width = static_cast<std::uint64_t>(request.width), height = static_cast<std::uint64_t>(rows);
    // 8-bit values of a written picture, or all of its layers; in tiles, the numbers and their order in the file.
    std::uint64_t written = byteProduct({width, height, how.tiled ? 2 * sizeof(Color) : 3});
    if (!layers.empty()) written = byteProduct({LayerPlanes::bytes(request, layers, rows), how.tiled ? 2U : 1U});
    requireMemory(byteSum({pictureBytes(request, threads, how.rows), written}),
                  "--size " + std::to_string(request.width) + "x" + std::to_string(request.height), how.hint);
}

void ManyFrames::add(CLI::App& parser) {
    parser
        .add_option("MORE", more,
                    "further height maps or scenarios; -o then names a folder, which receives one picture of each")
        ->type_name("")
        ->group("Arguments");
    addText(parser, "--frames", frames, "N",
            "render N pictures along a camera path from --camera to --to; -o then names a folder. mpirun -n N relief "
            "render ... shares the pictures among processes; rank 0 writes them",
            "Output");
    addText(parser, "--to", to, "KEY=VALUE,...", "end of the camera path: elevation, azimuth, distance, fov", "Output");
    addText(parser, "--sweep", sweep, "OPTION=FROM..TO|OPTION=A,B,...",
            "render pictures that differ in one option: a number of the scenario, such as light-azimuth or "
            "relief-depth, or an option of the tracer or the filter; from FROM to TO in --frames pictures (" +
                std::to_string(kSequenceFrames) + "); -o then names a folder",
            "Output");
    restart.add(parser, "many pictures, or one in tiles", "Output");
}

int ManyFrames::run(const ScenarioOptions& options, const std::string& folder, const std::vector<std::string>& layers,
                    const PartNumber& part, Session& session) const {
    const EarlierRun earlier = restart.chosen();
    std::optional<int> given;
    if (frames) given = static_cast<int>(parseWhole(*frames, "--frames", 1, kMostSequenceFrames));
    std::optional<Sequence> swept;
    if (sweep) swept = parseSweep(*sweep, given, "--sweep");
    if (sweep && to) throw InputError("--sweep", Message(MessageId::ArgumentsExclude, {{"other", "--to"}}));
    const std::int64_t count = sweep ? 1 : given.value_or(1);
    if (to && !frames) throw InputError("--to", Message(MessageId::NeedsArgument, {{"other", "--frames"}}));
    // A picture's file name given for several pictures is a mistake; creating a folder of that name would hide it.
    std::error_code none;
    if (std::filesystem::path(folder).has_extension() && !std::filesystem::is_directory(folder, none)) {
        throw InputError(!more.empty() ? more.front()
                         : sweep       ? "--sweep"
                                       : "--frames",
                         Message(MessageId::ArgumentsExclude, {{"other", "--output " + folder}}));
    }
    PictureList list = listed(*this, options, layers, swept, count);
    refuseReplacing(list, *this, options, folder);
    std::vector<Picture>& pictures = list.pictures;
    std::string journal = "pictures";
    if (part.of > 1) {
        std::size_t index = 0;
        std::erase_if(pictures, [&](const Picture&) { return !part.has(index++); });
        journal += "-" + std::to_string(part.part) + "-of-" + std::to_string(part.of);
    }
    const std::filesystem::path place(folder);
    const bool writes = leadsRun(part.of > 1);
    if (writes) makeFolder(folder);
    Studio studio(options, std::move(list.scenarios), count > 1, session);
    PartsRun run;
    run.bar = "render";
    run.parts = pictures.size();
    run.output = (place / journal).string();
    run.work = list.what;
    run.earlier = earlier;
    run.alone = part.of > 1;
    run.measure = [&](const Task& task, Work& work) -> Json {
        const Picture& picture = pictures[task.part];
        if (writes) {
            studio.render(picture, (place / picture.name).string(), layers, work);
            return picture.name;
        }
        const ScratchFolder scratch;
        studio.render(picture, scratch.path(picture.name), layers, work);
        return ScratchFolder::take(scratch.path(picture.name));
    };
    run.received = [&](std::size_t part, Json result) -> Json {
        if (result.is_binary()) writeBytes((place / pictures[part].name).string(), result.get_binary());
        return pictures[part].name;
    };
    if (const auto done = doParts(run, session)) done->journal->finish();
    return 0;
}

}  // namespace relief::app
