#include "workspace/snapshot_maker.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "relief/maps/map_memory.h"
#include "rendering/ellipse_error.h"
#include "workspace/discard.h"
#include "workspace/range_json.h"

namespace reliefui {

namespace {

// Time budget of a frame during a drag: it has to be on the screen within 33 ms, part of which is needed for painting
// and the panes.
constexpr double kMovingSeconds = 0.020;
// A coarse picture is drawn first if the full one is expected to take this many times the budget.
constexpr double kCoarseFirst = 9;

// Compares everything on which the frame's buffers depend.
bool sameFrame(const relief::Scenario& a, const relief::Scenario& b) {
    relief::Scenario c = relief::withNotesOf(b, a);
    c.pixel = a.pixel;
    c.other = a.other;
    c.comparison = a.comparison;
    return a == c;
}

// Number of texels up to which all three pyramids are built; for larger pictures, those not shown would waste about 1
// GB.
constexpr std::size_t kAllLevels = std::size_t{1} << 24;

// Largest number of texels of a relief for editing by hand.
constexpr std::size_t kByHand = std::size_t{32} * 32;

std::shared_ptr<const relief::Pyramid> pyramidOf(relief::PyramidKind kind, const relief::HeightField& field,
                                                 const relief::Pyramid* before, relief::MapCache& maps,
                                                 relief::Work& work) {
    const char* name = kind == relief::PyramidKind::Min ? "min-pyramid" : "mean-pyramid";
    constexpr std::uint64_t kBytes = 5;  // bytes per texel: levels above the heights, and sums of the means
    const std::uint64_t need = relief::bytesForTexels(field, kBytes);
    return maps.get<relief::Pyramid>({name, field.sharedHeights()}, need, work, [&](relief::Work& w) {
        const bool edit = before != nullptr && before->level(0).width() == field.width() &&
                          before->level(0).height() == field.height();
        return edit ? relief::Pyramid::edited(*before, field.sharedHeights())
                    : relief::Pyramid(kind, field.sharedHeights(), w);
    });
}

using Clock = std::chrono::steady_clock;

double buildSeconds(relief::Work& work) {
    const std::map<relief::MessageId, double> counted = work.counters().values();
    const auto found = counted.find(relief::MessageId::CountMapSeconds);
    return found != counted.end() ? found->second : 0;
}

// Layers of a picture with at most this many pixels are kept until their stages change; of larger ones only the colours
// and the layer shown.
constexpr std::size_t kKeepLayers = std::size_t{1} << 22;

// Returns true if the layer of both frames is the same. normals: whether they have the same normal map.
bool sameLayer(Layer layer, const relief::Frame& a, const relief::Frame& b, bool normals) {
    const bool hits = a.rays == b.rays && a.hits == b.hits;
    switch (layer) {
        case Layer::Color:
            return a.light == b.light;
        case Layer::Hidden:
            return hits && a.color == b.color;
        case Layer::Normals:
            return hits && normals;
        default:
            return hits;
    }
}

}  // namespace

SnapshotMaker::SnapshotMaker(relief::AssetStore store) : store_(std::move(store)), renderer_(maps_, kMovingSeconds) {}

// Both frames are alive, so that a stage that they share has not been written again.
void SnapshotMaker::Shown::dropStale(const relief::Frame* before, bool normals) {
    const relief::Frame& now = *drawn.frame;
    std::erase_if(
        layers, [&](const auto& entry) { return before == nullptr || !sameLayer(entry.first, *before, now, normals); });
    const bool filtered = before != nullptr && before->hits == now.hits && before->color == now.color;
    if (filtered) return;
    bounded.reset();
    ellipseOff.reset();
}

bool SnapshotMaker::Shown::is(const relief::Scenario& other, const relief::Assets& of) const {
    return scenario && sameFrame(*scenario, other) && assets.heights == of.heights && assets.tiles == of.tiles &&
           assets.color == of.color && assets.normals == of.normals;
}

relief::FrameRequest SnapshotMaker::request(const SnapshotOrder& order, const relief::Assets& assets) {
    renderer_.keepFilter(order.layer == Layer::Hidden || order.layer == Layer::Anisotropy);
    return relief::frameRequest(order.scenario, assets);
}

bool SnapshotMaker::takesLong(const SnapshotOrder& order, relief::Work& work) {
    const relief::Assets assets = load(order.scenario.pictures, work);
    if (full_.is(order.scenario, assets)) return false;
    renderer_.levelFor(request(order, assets));
    return renderer_.fullSeconds() > kCoarseFirst * kMovingSeconds;
}

bool SnapshotMaker::gaveUp(double seconds) {
    return renderer_.gaveUp(level_, seconds);
}

bool SnapshotMaker::draw(Shown& shown, const SnapshotOrder& order, const relief::FrameRequest& request,
                         const relief::Assets& assets, relief::Work& work) {
    const relief::MovingLevel& last = shown.drawn.level;
    const bool same = level_.number == last.number && level_.factor == last.factor && level_.filter == last.filter;
    if (same && shown.is(order.scenario, assets)) return false;
    shown.scenario.reset();              // set again when complete, because drawing may be cancelled
    if (&shown == &full_) coarse_ = {};  // frees memory: may be as large as the full one
    const std::shared_ptr<const relief::Frame> before = shown.drawn.frame;
    const bool normals = shown.assets.normals == assets.normals;
    shown.drawn = order.moving ? renderer_.draw(request, level_, work) : renderer_.atRest(request, work);
    shown.assets = assets;
    shown.dropStale(before.get(), normals);
    layerOf(shown, Layer::Color, work);
    if (request.bounded > 0 && &shown == &full_ && !shown.bounded) {
        shown.bounded = relief::measureBounded(*shown.drawn.frame, request, *maps_, work);
    }
    if (!shown.ellipseOff) {
        shown.ellipseOff = &shown == &full_ ? relief::ellipseError(*shown.drawn.frame, request, work) : 0;
    }
    shown.scenario = order.scenario;
    return true;
}

LayerPicture& SnapshotMaker::layerOf(Shown& shown, Layer layer, relief::Work& work) {
    const relief::Frame& frame = *shown.drawn.frame;
    const auto found = shown.layers.find(layer);
    if (found != shown.layers.end()) return found->second;
    if (frame.light->color.size() > kKeepLayers) {
        std::erase_if(shown.layers, [](const auto& entry) { return entry.first != Layer::Color; });
    }
    return shown.layers[layer] = makeLayer(layer, frame, *shown.drawn.request, *maps_, work);
}

void SnapshotMaker::readFiles(const SnapshotOrder& order, const relief::HeightField& field) {
    const relief::OtherTracer& other = order.scenario.other;
    const bool open = other && other_ && other_->areOf(other);
    const bool due = std::exchange(renewed_, order.renewed) != order.renewed;
    if (!other) other_.reset();
    if (!other || !open) otherProblem_.reset();
    if (!other || (open && !due)) return;
    try {
        auto files = readOtherFiles(other);
        relief::rayOfFiles(other, *files, field);  // throws if the ray cannot be shown
        other_ = std::move(files);
        otherProblem_.reset();
    } catch (const relief::InputError& error) {
        if (!open) throw;
        // The other tracer may still be writing; a failure would undo what the user changed meanwhile.
        otherProblem_ = std::make_shared<const relief::InputError>(error);
    }
}

std::shared_ptr<const Snapshot> SnapshotMaker::make(const SnapshotOrder& order, relief::Work& work) {
    const auto begun = Clock::now();
    const double built = buildSeconds(work);
    const relief::Scenario& scenario = order.scenario;
    auto snapshot = makeFreedInBackground<Snapshot>();
    snapshot->version = order.version;
    snapshot->scenario = scenario;
    snapshot->assets = load(scenario.pictures, work);
    const relief::FrameRequest fullRequest = request(order, snapshot->assets);
    makePyramids(fullRequest.field, work);
    const bool coarser = order.moving && !full_.is(scenario, snapshot->assets);
    level_ = coarser ? renderer_.levelFor(fullRequest) : relief::MovingLevel{0, fullRequest.filter};
    snapshot->coarse = level_.number > 0;

    Shown& shown = snapshot->coarse ? coarse_ : full_;
    const bool drawn = draw(shown, order, fullRequest, snapshot->assets, work);
    relief::ProgressiveRenderer::Picture& picture = shown.drawn;
    if (order.layer == Layer::Steps) picture.frame = renderer_.counted(picture, work);
    LayerPicture& layer = layerOf(shown, order.layer, work);
    if (const auto of = rangeOf(order.layer)) {
        const ColorRange range = rangesOf(scenario).of(*of);
        if (range != layer.range) colorLayer(layer, range);
    }
    snapshot->request = picture.request;
    snapshot->frame = picture.frame;
    snapshot->picture = shown.layers.at(Layer::Color).image;
    snapshot->layer = layer;
    snapshot->bounded = shown.bounded;
    snapshot->ellipseOff = *shown.ellipseOff;
    snapshot->tracer = picture.tracer;
    snapshot->guarantee = picture.tracer->guarantee();
    snapshot->methodBytes = picture.tracer->bytes();
    describe(*snapshot, order, work);
    if (order.moving && drawn) {
        // Time for building maps is excluded, because coarser pictures would not reduce it.
        const double all = std::chrono::duration<double>(Clock::now() - begun).count();
        renderer_.took(std::max(all - (buildSeconds(work) - built), relief::pixelSeconds(*picture.frame, work)));
    }
    return snapshot;
}

void SnapshotMaker::makePyramids(const relief::HeightField& field, relief::Work& work) {
    if (field.texels() > kByHand || field.tiles() != nullptr) {
        small_ = {};
        return;
    }
    small_.maxima = relief::maxPyramidMap(field, *maps_, work, small_.maxima.get());
    small_.minima = pyramidOf(relief::PyramidKind::Min, field, small_.minima.get(), *maps_, work);
    small_.means = pyramidOf(relief::PyramidKind::Mean, field, small_.means.get(), *maps_, work);
}

// Adds the pixel's ray, its footprint, and the pyramids shown in the panes.
void SnapshotMaker::describe(Snapshot& snapshot, const SnapshotOrder& order, relief::Work& work) {
    const relief::Scenario& scenario = order.scenario;
    const relief::FrameRequest& request = *snapshot.request;
    readFiles(order, request.field);
    snapshot.otherFiles = other_;
    snapshot.otherProblem = otherProblem_;
    // The trace uses full-size pixels, even if the frame is coarse.
    RayTraces traces = traceRay(scenario, relief::frameRequest(scenario, snapshot.assets), *snapshot.tracer,
                                snapshot.otherFiles.get(), *maps_, work);
    snapshot.trace = std::move(traces.shown);
    snapshot.other = traces.other;
    snapshot.otherRays = traces.otherRays;
    if (scenario.pixel) {
        const auto inFrame = [](int at, int side, int whole) { return std::clamp(at * side / whole, 0, side - 1); };
        const int x = inFrame(scenario.pixel->x, request.width, scenario.width);
        const int y = inFrame(scenario.pixel->y, request.height, scenario.height);
        const double scale = static_cast<double>(request.width) / scenario.width;
        snapshot.footprint = pixelFootprint(*snapshot.frame, request, *snapshot.tracer, x, y, scale, filtered_, work);
    }
    const int last = std::max(0, static_cast<int>(snapshot.trace.steps.size()) - 1);
    snapshot.scenario.step = order.lastStep ? last : std::clamp(scenario.step, 0, last);
    const relief::HeightField& field = request.field;
    snapshot.maxima = relief::maxPyramidMap(field, *maps_, work);
    snapshot.maps = maps_;
    const auto levels = [&](relief::PyramidKind kind) -> std::shared_ptr<const relief::Pyramid> {
        if (field.tiles() != nullptr || (field.texels() > kAllLevels && order.levels != kind)) return nullptr;
        return pyramidOf(kind, field, nullptr, *maps_, work);
    };
    snapshot.minima = levels(relief::PyramidKind::Min);
    snapshot.means = levels(relief::PyramidKind::Mean);
}

}  // namespace reliefui
