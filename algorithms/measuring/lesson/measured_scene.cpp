#include "measuring/lesson/measured_scene.h"

#include <algorithm>

#include "relief/maps/distance_map.h"
#include "relief/tracers/map_choice.h"
#include "rendering/pixel_coefficients.h"

namespace relief {

namespace {

// Largest number of rays whose logs are kept to count children.
constexpr std::size_t kMostLogged = 4096;

void requirePixel(const Scenario& scenario) {
    if (!scenario.pixel) throw InputError("", Message(MessageId::LessonNoPixel));
}

// Where the pixel shows nothing of the relief.
[[noreturn]] void failOffRelief(const Scenario& scenario) {
    throw InputError("", Message(MessageId::LessonOffRelief, {{"x", scenario.pixel->x}, {"y", scenario.pixel->y}}));
}

}  // namespace

Assets SceneStore::assets(const Pictures& pictures, Work& work) {
    auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& entry) { return entry.first == pictures; });
    if (found == kept_.end()) {
        // One that shares files with these pictures loads only the others.
        found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& entry) {
            return entry.first.height == pictures.height && entry.first.recipe == pictures.recipe;
        });
        AssetStore store = found == kept_.end() ? AssetStore() : found->second;
        if (kept_.size() == kKept) kept_.erase(kept_.begin());
        kept_.emplace_back(pictures, std::move(store));
        found = kept_.end() - 1;
    }
    return found->second.load(pictures, work);
}

const FrameRequest& MeasuredScene::request(Work& work) {
    if (!request_) {
        request_ = frameRequest(scenario_, store_.assets(scenario_.pictures, work));
        request_->counts = true;
    }
    return *request_;
}

const Frame& MeasuredScene::frame(Work& work) {
    if (!frame_) {
        FrameRenderer renderer(store_.maps());
        frame_ = renderer.render(request(work), work);
        tracer_ = renderer.tracer();
    }
    return *frame_;
}

const Tracer& MeasuredScene::tracer(Work& work) {
    frame(work);
    return *tracer_;
}

const ErrorLayer& MeasuredScene::errors(Work& work) {
    if (!errors_) errors_ = errorAgainstExact(frame(work), request(work), *store_.maps(), work);
    return *errors_;
}

const LoggedRay& MeasuredScene::ray(Work& work) {
    if (ray_) return *ray_;
    LoggedRay out;
    std::string name = scenario_.method.name;
    if (scenario_.other && scenario_.other.shown) {
        const RayFiles files = readRayFiles(scenario_.other);
        out = rayOfFiles(scenario_.other, files, field(work));
        name = scenario_.other.steps;
    } else {
        requirePixel(scenario_);
        const auto found = pixelRay(request(work), scenario_.pixel->x, scenario_.pixel->y);
        if (!found) failOffRelief(scenario_);
        out = tracedRay(tracer(work), *found, work);
    }
    judgeAgainstExact(out, name, field(work), *store_.maps(), work);
    ray_ = std::move(out);
    return *ray_;
}

const PixelCoefficients& MeasuredScene::coefficients(Work& work) {
    if (!coefficients_) {
        requirePixel(scenario_);
        coefficients_ = pixelCoefficients(request(work), scenario_.pixel->x, scenario_.pixel->y);
        if (!coefficients_) failOffRelief(scenario_);
    }
    return *coefficients_;
}

const SceneFootprint& MeasuredScene::footprint(Work& work) {
    if (footprint_) return *footprint_;
    requirePixel(scenario_);
    const Frame& shown = frame(work);
    const VisiblePolygons visible = shown.visible(request(work));
    const auto query = filterQuery(shown, request(work), visible, scenario_.pixel->x, scenario_.pixel->y);
    if (!query) failOffRelief(scenario_);
    SceneFootprint out;
    const HeightField& heights = field(work);
    const auto& color = request(work).color;
    const glm::dvec2 perField{color ? static_cast<double>(color->width()) / heights.width() : 1.0,
                              color ? static_cast<double>(color->height()) / heights.height() : 1.0};
    if (shown.filter) shown.filter->color(*query, out.counts, work, &out.log);
    const SemiAxes<double> axes = ellipseOf(scaled(query->jacobian, perField)).semiAxes();
    out.major = axes.major;
    out.minor = axes.minor;
    footprint_ = std::move(out);
    return *footprint_;
}

const std::vector<SkipRow>& MeasuredScene::skipped(Work& work) {
    if (!skipped_) skipped_ = skipLedger(frame(work), request(work));
    return *skipped_;
}

const ChildCounts& MeasuredScene::children(Work& work) {
    if (children_) return *children_;
    const Frame& shown = frame(work);
    std::vector<std::size_t> covered;
    for (std::size_t i = 0; i < shown.rays->polygon.size(); ++i) {
        if (shown.rays->polygon[i] != kNoPolygon) covered.push_back(i);
    }
    RayBlock rays;
    const std::size_t stride = covered.size() / kMostLogged + 1;
    for (std::size_t n = 0; n < covered.size(); n += stride) rays.push(shown.rays->rays[covered[n]]);
    HitBlock hits;
    StepLog log;
    tracer(work).trace(rays, hits, log, work);
    ChildrenByLevel counts;
    for (std::size_t ray = 0; ray < log.rays(); ++ray) {
        addChildren(log.steps, log.begin[ray], log.begin[ray + 1], counts);
    }
    children_ = sumOf(counts);
    return *children_;
}

const Certificate& MeasuredScene::certificate(std::uint64_t rays, Work& work) {
    const auto found = certificates_.find(rays);
    if (found != certificates_.end()) return found->second;
    CertificateOptions options;
    options.rays = rays;
    return certificates_[rays] = certify(scenario_.method, field(work), options, *store_.maps(), work);
}

const Pyramid& MeasuredScene::pyramid(PyramidKind kind, Work& work) {
    const auto found = pyramids_.find(kind);
    if (found != pyramids_.end()) return found->second;
    return pyramids_[kind] = Pyramid(kind, field(work).sharedHeights(), work);
}

PointDistances MeasuredScene::point(double s, double t, double z, Work& work) {
    const auto used = usedMap(scenario_.method);
    double flattest = DistanceParameters().flattest;
    if (used && used->options.contains("flattest")) flattest = parseNumber(used->options.at("flattest"), "flattest");
    return distancesAt(field(work), s, t, z, flattest, *store_.maps(), work);
}

PictureError MeasuredScene::pictureError(const ColorImage& truth, Work& work) {
    FloatImage unused;
    return relief::pictureError(truth, frame(work).light->color, kPixelsPerDegree, unused, work);
}

MeasuredScene& SceneCache::scene(const Scenario& scenario) {
    // Step, breakpoints and the like change nothing that is kept here.
    const std::string key = scenarioText(withNotesOf(scenario, Scenario()));
    auto found = std::find_if(scenes_.begin(), scenes_.end(), [&](const auto& entry) { return entry.first == key; });
    if (found == scenes_.end()) {
        scenes_.emplace_back(key, std::make_unique<MeasuredScene>(scenario, store_));
        std::uint64_t pixels = 0;
        for (const auto& entry : scenes_) pixels += entry.second->pixels();
        while (scenes_.size() > kSurelyKept && (scenes_.size() > kKept || pixels > kKeptPixels)) {
            pixels -= scenes_.front().second->pixels();
            scenes_.erase(scenes_.begin());
        }
    } else {
        std::rotate(found, found + 1, scenes_.end());
    }
    return *scenes_.back().second;
}

const ColorImage& SceneCache::truth(const Scenario& scenario, int samples, PixelModel model, Work& work) {
    Scenario best = scenario;
    best.filter = FilterChoice();
    best.filter.name = kSupersample;
    best.filter.samples = samples;
    best.filter.pixelModel = model;
    if (findTracer(scenario.method.name).kind == MethodKind::Tracer) best.method = {kExactTracer, {}};
    best.mapping = Scenario().mapping;
    best.bounded = 0;
    best.pixel.reset();
    best.comparison = {};
    return scene(best).frame(work).light->color;
}

const RowBenchRow& SceneCache::rows(const std::string& variant, std::int64_t width, double elevation,
                                    RowPrecision precision, Work& work) {
    const auto key = std::tuple(variant, width, elevation, precision);
    const auto found = rows_.find(key);
    if (found != rows_.end()) return found->second;
    RowBenchOptions options;
    options.methods = {parseRowMethod(variant, "rows")};
    options.widths = {width};
    options.elevations = {elevation};
    options.precisions = {precision};
    options.pixels = std::max<std::int64_t>(width, 1 << 16);
    options.pass = BenchPass::Counts;
    return rows_[key] = benchRows(options, work).at(0);
}

}  // namespace relief
