#include "rendering/progressive.h"

#include <algorithm>
#include <cstdlib>

#include "filtering/elliptical_grid.h"

namespace relief {

namespace {

constexpr const char* kVisible = "elliptical-visible";
constexpr const char* kPlain = "elliptical";
constexpr const char* kFewPoints = "2";

// Initial estimates of seconds per pixel on a small machine: traced and filtered with the plain filter; only relit.
constexpr double kTracedSeconds = 4e-7, kLitSeconds = 2e-8;
constexpr int kFactors[]{2, 3, 4, 6, 8};

std::string valueOf(const FilterChoice& choice, const std::string& option) {
    const auto given = choice.options.find(option);
    return given != choice.options.end() ? given->second : findFilter(choice.name).defaults.at(option);
}

// Returns a rough initial estimate of the cost per pixel, relative to the plain filter.
double costOf(const FilterChoice& choice) {
    if (choice.name == kSupersample) return choice.samples * choice.samples;
    if (choice.name != kVisible) return 1;
    const std::string form = valueOf(choice, "form");
    const double points = std::atof(valueOf(choice, "points").c_str());
    return form == kGridForm ? 1 + 0.1 * points * points : form == "rays" ? 8 : 100;
}

// Returns true if both requests have the same hits.
bool sameHits(const FrameRequest& a, const FrameRequest& b) {
    return a.width == b.width && a.height == b.height && a.field.identity() == b.field.identity() &&
           a.field.surface() == b.field.surface() && a.field.address() == b.field.address() &&
           a.field.reliefDepth() == b.field.reliefDepth() && a.method == b.method && a.scene == b.scene &&
           a.camera == b.camera && a.skip == b.skip && a.mapping == b.mapping && a.bounded == b.bounded &&
           a.sample == b.sample && a.margin == b.margin;
}

}  // namespace

FilterChoice coarserFilter(const FilterChoice& choice, int level) {
    if (level > 0 && choice.name == kSupersample) return {};
    if (level == 0 || choice.name != kVisible) return choice;
    FilterChoice coarse = choice;
    if (level == 1) {
        const bool many = valueOf(choice, "form") == kGridForm && std::atoi(valueOf(choice, "points").c_str()) > 2;
        if (many) coarse.options["points"] = kFewPoints;
        return coarse;
    }
    coarse.name = kPlain;
    const std::vector<OptionDescription>& known = findFilter(kPlain).options;
    std::erase_if(coarse.options, [&](const auto& option) {
        return std::none_of(known.begin(), known.end(), [&](const auto& one) { return one.name == option.first; });
    });
    return coarse;
}

FrameRequest coarserRequest(const FrameRequest& request, const MovingLevel& level) {
    FrameRequest coarse = request;
    coarse.filter = level.filter;
    coarse.width = (request.width + level.factor - 1) / level.factor;
    coarse.height = (request.height + level.factor - 1) / level.factor;
    return coarse;
}

double pixelSeconds(const Frame& frame, Work& work) {
    double seconds = 0;
    for (const StageReport& stage : frame.stages) seconds += stage.seconds;
    return seconds / work.threads().size();
}

ProgressiveRenderer::ProgressiveRenderer(std::shared_ptr<MapCache> maps, double budget)
    : maps_(std::move(maps)), full_(maps_), small_(maps_), traced_(budget), lit_(budget), pace_(&traced_) {}

std::vector<MovingLevel> ProgressiveRenderer::levels(const FrameRequest& request, bool lit) const {
    const double pixels = static_cast<double>(request.width) * request.height;
    std::vector<MovingLevel> levels;
    const auto add = [&](const FilterChoice& filter, int factor) {
        // If the filtered colours can be reused, only the light stage is computed.
        const bool filtered = lit && factor == 1 && filter == drawn_->filter;
        const double cost = (lit ? kLitSeconds : kTracedSeconds) * (filtered ? 1 : costOf(filter));
        levels.push_back({static_cast<int>(levels.size()), filter, factor, cost * pixels / (factor * factor)});
    };
    add(request.filter, 1);
    FilterChoice filter = request.filter;
    // Supersampling is never used while the picture moves, and is therefore no filter to keep.
    const bool keep = keepFilter_ && request.filter.name != kSupersample;
    for (int level = 1; level <= kCoarsestFilter && !keep; ++level) {
        if (coarserFilter(request.filter, level) == filter) continue;
        filter = coarserFilter(request.filter, level);
        // For a change of light the filtered colours are reused, so coarser filters would save no time.
        if (!lit) add(filter, 1);
    }
    for (const int factor : kFactors) add(filter, factor);
    return levels;
}

MovingLevel ProgressiveRenderer::levelFor(const FrameRequest& request) {
    const bool lit = drawn_ && sameHits(*drawn_, request);
    const std::vector<MovingLevel> all = levels(request, lit);
    std::vector<double> seconds;
    for (const MovingLevel& level : all) seconds.push_back(level.seconds);
    pace_ = lit ? &lit_ : &traced_;
    pace_->setLevels(seconds);
    return all[static_cast<std::size_t>(pace_->level())];
}

// Releases the buffers of the smaller pictures when they belong to another relief; they may take hundreds of megabytes.
void ProgressiveRenderer::forgetSmall(const FrameRequest& shown) {
    if (!drawnSmall_) return;
    const bool same = drawnSmall_->field.identity() == shown.field.identity() && drawnSmall_->color == shown.color &&
                      drawnSmall_->normals == shown.normals;
    if (same) return;
    small_ = FrameRenderer(maps_);
    smallFrame_.reset();
    drawnSmall_.reset();
}

ProgressiveRenderer::Picture ProgressiveRenderer::draw(const FrameRequest& request, const MovingLevel& level,
                                                       Work& work) {
    Picture picture;
    picture.request = std::make_shared<const FrameRequest>(coarserRequest(request, level));
    picture.level = level;
    FrameRenderer& renderer = rendererOf(level);
    picture.frame = renderer.render(*picture.request, work);
    picture.tracer = renderer.tracer();
    (level.factor == 1 ? fullFrame_ : smallFrame_) = picture.frame;
    (level.factor == 1 ? drawn_ : drawnSmall_) = *picture.request;
    if (level.factor == 1) forgetSmall(request);
    return picture;
}

ProgressiveRenderer::Picture ProgressiveRenderer::moving(const FrameRequest& request, Work& work) {
    Picture picture = draw(request, levelFor(request), work);
    took(picture.frame->seconds);
    return picture;
}

ProgressiveRenderer::Picture ProgressiveRenderer::atRest(const FrameRequest& request, Work& work) {
    levelFor(request);
    Picture picture = draw(request, {0, request.filter, 1, 0}, work);
    const auto& stages = picture.frame->stages;
    const bool whole = std::none_of(stages.begin(), stages.end(), [](const StageReport& s) { return s.reused; });
    if (!whole || request.filter.name == kSupersample) return picture;
    pace_->rested(pixelSeconds(*picture.frame, work));
    return picture;
}

std::shared_ptr<const Frame> ProgressiveRenderer::counted(const Picture& picture, Work& work) {
    if (picture.frame->hits->counted()) return picture.frame;
    FrameRenderer& renderer = rendererOf(picture.level);
    std::shared_ptr<const Frame>& last = picture.level.factor == 1 ? fullFrame_ : smallFrame_;
    if (last != picture.frame) {
        renderer.render(*picture.request, work);
        if (picture.level.factor == 1) drawn_ = *picture.request;
    }
    last = renderer.counted(work);
    return last;
}

bool ProgressiveRenderer::gaveUp(const MovingLevel& level, double seconds) {
    if (level.number != pace_->level()) return false;
    pace_->gaveUp(seconds);
    return pace_->level() > level.number;
}

}  // namespace relief
