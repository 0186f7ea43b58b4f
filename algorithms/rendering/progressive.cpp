#include "rendering/progressive.h"

#include <algorithm>
#include <cstdlib>

#include "filtering/elliptical_grid.h"

namespace relief {

namespace {

constexpr const char* kVisible = "elliptical-visible";
constexpr const char* kPlain = "elliptical";
constexpr const char* kFewPoints = "2";

// A finer level is taken again only if it is expected to stay below this part of the budget: frames vary, and a view
// that changes its look to and fro is worse than a coarse one.
constexpr double kWellWithin = 0.85;
// Where frames take no more than this part of it, a finer level is tried whatever is expected of it.
constexpr double kMuchWithin = 0.6;
// Weight of the newest frame in what is remembered.
constexpr double kNewest = 0.25;
// Frames on a coarser level before a finer one is tried again: each time twice as many, for the finer one was too slow.
constexpr int kFirstWait = 16, kLongestWait = 2048;

std::string valueOf(const FilterChoice& choice, const std::string& option) {
    const auto given = choice.options.find(option);
    return given != choice.options.end() ? given->second : findFilter(choice.name).defaults.at(option);
}

}  // namespace

FilterChoice coarserFilter(const FilterChoice& choice, int level) {
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

int ProgressiveRenderer::levelFor(const FilterChoice& filter, double pixels) const {
    const auto same = [&](int level) { return coarserFilter(filter, level) == coarserFilter(filter, level - 1); };
    const auto seconds = [&](int level) { return perPixel_[static_cast<std::size_t>(level)] * pixels; };
    // The next finer one, where there is time to spare: what was measured of it may be of another view.
    const bool spare = last_ > 0 && since_ >= wait_ && seconds(last_) <= kMuchWithin * budget_;
    int tried = spare ? last_ - 1 : kCoarsestFilter;
    while (spare && tried > 0 && same(tried)) --tried;
    for (int level = since_ < wait_ ? last_ : 0; level < kCoarsestFilter; ++level) {
        if (level > 0 && same(level)) continue;
        // What is not known yet is tried, from the finest on.
        const double most = (level < last_ ? kWellWithin : 1) * budget_;
        if (level == tried || seconds(level) <= most || seconds(level) == 0) return level;
    }
    return coarserFilter(filter, kCoarsestFilter) == filter ? 0 : kCoarsestFilter;
}

// What the other levels take is taken to have changed in proportion.
void ProgressiveRenderer::learn(int level, double perPixel) {
    const double known = perPixel_[static_cast<std::size_t>(level)];
    const double next = known > 0 ? (1 - kNewest) * known + kNewest * perPixel : perPixel;
    if (known > 0) {
        for (double& each : perPixel_) each *= next / known;
    } else {
        perPixel_[static_cast<std::size_t>(level)] = next;
    }
}

ProgressiveRenderer::Picture ProgressiveRenderer::moving(const FrameRequest& request, Work& work) {
    if (!(request.filter == filter_)) {
        filter_ = request.filter;
        perPixel_ = {};
        last_ = since_ = wait_ = 0;
        first_ = true;
    }
    const double pixels = static_cast<double>(request.width) * request.height;
    const int level = levelFor(request.filter, pixels);
    FrameRequest asked = request;
    asked.filter = coarserFilter(request.filter, level);
    const std::shared_ptr<const Frame> frame = renderer_.render(asked, work);
    // The first frame on a level makes its filter, and one that kept its hits took less: both say little of the next.
    const bool tells = level == last_ && !first_ && !frame->stages[static_cast<std::size_t>(Stage::Hits)].reused;
    ++since_;
    if (level > last_) {
        since_ = 0;
        wait_ = std::clamp(2 * wait_, kFirstWait, kLongestWait);
    }
    first_ = level != last_;
    last_ = level;
    if (tells) learn(level, frame->seconds / pixels);
    return {frame, level, !(asked.filter == request.filter)};
}

std::shared_ptr<const Frame> ProgressiveRenderer::settled(const FrameRequest& request, Work& work) {
    return renderer_.render(request, work);
}

}  // namespace relief
