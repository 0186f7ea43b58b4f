#include "workspace/snapshot_maker.h"
#include "workspace/discard.h"

#include <algorithm>
#include <cmath>

namespace reliefui {

namespace {

// A dragged frame has to be on the screen within 33 ms; painting and the panes take their part of it.
constexpr double kCoarseSeconds = 0.020;
constexpr double kTooSlow = 0.030;
constexpr double kVeryFast = 0.010;
constexpr int kCoarsestFactor = 8;

// Everything on which the frame's buffers depend.
bool sameFrame(const relief::Scenario& a, const relief::Scenario& b) {
    relief::Scenario c = relief::withNotesOf(b, a);
    c.pixel = a.pixel;
    c.other = a.other;
    c.comparison = a.comparison;
    return a == c;
}

// The same but for what is done after the rays were traced.
bool sameHits(const relief::Scenario& a, const relief::Scenario& b) {
    relief::Scenario c = b;
    c.light = a.light;
    c.shadows = a.shadows;
    c.sky = a.sky;
    c.filter = a.filter;
    c.pictures.color = a.pictures.color;
    c.pictures.normal = a.pictures.normal;
    return sameFrame(a, c);
}

// Takes seconds: a plain picture, this much coarser, comes before it, and what it took says nothing of others.
bool supersampled(const relief::Scenario& scenario) {
    return scenario.filter.name == relief::kSupersample;
}
constexpr int kSupersampledFactor = 3;

// Texels up to which all pyramids are at hand; a larger picture's would take a gigabyte that nobody looks at.
constexpr std::size_t kAllLevels = std::size_t{1} << 24;

double pixelsOf(const relief::Scenario& scenario) {
    return static_cast<double>(scenario.width) * scenario.height;
}

}  // namespace

int SnapshotMaker::coarseFactor(const relief::Scenario& scenario) const {
    if (full_.scenario && sameFrame(*full_.scenario, scenario)) return 1;
    const bool lightOnly = full_.scenario && sameHits(*full_.scenario, scenario);
    // Nothing measured yet: as on a small machine.
    const double traced = secondsPerPixel_ > 0 ? secondsPerPixel_ : 4e-7;
    const double seconds = pixelsOf(scenario) * (lightOnly ? lightPerPixel_ : traced);
    const int estimated = static_cast<int>(std::ceil(std::sqrt(seconds / kCoarseSeconds)));
    const int factor = std::clamp(estimated <= 1 ? 1 : estimated + coarser_, 1, kCoarsestFactor);
    return supersampled(scenario) ? std::max(factor, kSupersampledFactor) : factor;
}

// Full frames tell what a pixel costs; coarse ones, in which other things count as well, only whether to go further.
void SnapshotMaker::learn(const relief::Frame& frame, bool coarse, bool lightOnly) {
    if (coarse) {
        if (frame.seconds > kTooSlow) coarser_ = std::min(coarser_ + 1, kCoarsestFactor);
        if (frame.seconds < kVeryFast) coarser_ = std::max(coarser_ - 1, -1);
        return;
    }
    const double perPixel = frame.seconds / (static_cast<double>(frame.width) * frame.height);
    double& kept = lightOnly ? lightPerPixel_ : secondsPerPixel_;
    kept = kept == 0 ? perPixel : 0.5 * (kept + perPixel);
}

void SnapshotMaker::render(Size& size, const relief::Scenario& scenario, const relief::FrameRequest& request,
                           const relief::Assets& assets, relief::Work& work) {
    const bool known = size.frame && size.scenario && size.frame->width == request.width &&
                       size.frame->height == request.height && sameFrame(*size.scenario, scenario) &&
                       size.assets.heights == assets.heights && size.assets.color == assets.color &&
                       size.assets.normals == assets.normals;
    if (known) return;
    if (!size.renderer) size.renderer = std::make_unique<relief::FrameRenderer>(maps_);
    const bool lightOnly = size.scenario && sameHits(*size.scenario, scenario);
    size.frame = size.renderer->render(request, work);
    size.scenario = scenario;
    size.assets = assets;
    size.layer = makeLayer(Layer::Color, *size.frame, request, *maps_, work);
    size.picture = size.layer.image;
    size.bounded.reset();
    if (request.bounded > 0 && &size == &full_) {
        size.bounded = relief::measureBounded(*size.frame, request, *maps_, work);
    }
    if (!supersampled(scenario)) learn(*size.frame, &size == &coarse_, lightOnly);
}

const OtherFiles* SnapshotMaker::otherFiles(const relief::Scenario& scenario) {
    if (!scenario.other) return nullptr;
    const bool known = other_ && other_->from.rays == scenario.other.rays && other_->from.steps == scenario.other.steps;
    if (!known) other_ = readOtherFiles(scenario.other);
    return other_.get();
}

std::shared_ptr<const Snapshot> SnapshotMaker::make(const SnapshotOrder& order, relief::Work& work) {
    const relief::Scenario& scenario = order.scenario;
    auto snapshot = makeFreedAside<Snapshot>();
    snapshot->version = order.version;
    snapshot->scenario = scenario;
    snapshot->assets = store_.load(scenario.pictures, work);
    snapshot->coarse = order.factor > 1;
    auto request = std::make_shared<relief::FrameRequest>(relief::frameRequest(scenario, snapshot->assets));
    request->width = (scenario.width + order.factor - 1) / order.factor;
    request->height = (scenario.height + order.factor - 1) / order.factor;
    if (snapshot->coarse && supersampled(scenario)) request->filter = {};

    Size& size = snapshot->coarse ? coarse_ : full_;
    render(size, scenario, *request, snapshot->assets, work);
    if (order.layer == Layer::Steps) size.frame = size.renderer->counted(work);
    if (size.layer.layer != order.layer) size.layer = makeLayer(order.layer, *size.frame, *request, *maps_, work);
    snapshot->request = request;
    snapshot->frame = size.frame;
    snapshot->picture = size.picture;
    snapshot->layer = size.layer;
    snapshot->bounded = size.bounded;
    snapshot->tracer = size.renderer->tracer();
    snapshot->guarantee = size.renderer->tracer()->guarantee();
    snapshot->methodBytes = size.renderer->tracer()->bytes();
    // In full-size pixels, also when the frame is coarse.
    RayTraces traces = traceRay(scenario, relief::frameRequest(scenario, snapshot->assets), *size.renderer->tracer(),
                                otherFiles(scenario), *maps_, work);
    snapshot->trace = std::move(traces.shown);
    snapshot->other = traces.other;
    snapshot->otherRays = traces.otherRays;
    if (scenario.pixel) {
        const auto inFrame = [](int at, int side, int whole) { return std::clamp(at * side / whole, 0, side - 1); };
        const int x = inFrame(scenario.pixel->x, request->width, scenario.width);
        const int y = inFrame(scenario.pixel->y, request->height, scenario.height);
        const double scale = static_cast<double>(request->width) / scenario.width;
        snapshot->footprint = pixelFootprint(*size.frame, *request, x, y, scale, filtered_, work);
    }
    const int last = std::max(0, static_cast<int>(snapshot->trace.steps.size()) - 1);
    snapshot->scenario.step = order.lastStep ? last : std::clamp(scenario.step, 0, last);
    const relief::HeightField& field = request->field;
    snapshot->maxima = relief::maxPyramidMap(field, *maps_, work);
    snapshot->maps = maps_;
    const auto levels = [&](relief::PyramidKind kind, const char* name) -> std::shared_ptr<const relief::Pyramid> {
        const bool small = field.heights().pixels().size() <= kAllLevels;
        if (!small && order.levels != kind) return nullptr;
        return maps_->get<relief::Pyramid>({name, field.sharedHeights()}, work, [&](relief::Work& w) {
            return relief::Pyramid(kind, field.sharedHeights(), w);
        });
    };
    snapshot->minima = levels(relief::PyramidKind::Min, "min-pyramid");
    snapshot->means = levels(relief::PyramidKind::Mean, "mean-pyramid");
    return snapshot;
}

}  // namespace reliefui
