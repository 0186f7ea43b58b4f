// Compares the library's filters with the supersampled picture, on small pictures of the user's own map.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "filtering/filters/measured_filters.h"
#include "filtering/methods/trilinear.h"
#include "measuring/advise/recommend_trials.h"
#include "measuring/bench/bench_filters.h"

namespace relief {

namespace {

// Below this elevation, degrees, every pixel of a small picture touches the polygon's edge.
constexpr double kFlattestFilterView = 8;
constexpr double kSteepestFilterView = 85;
constexpr int kWidth = 40;
constexpr int kHeight = 30;
constexpr int kSamples = 6;
constexpr double kRichSeconds = 10;  // given this much time, the pictures are twice as wide
// Approximate width of a pixel in texels, if the map is larger than the picture.
constexpr double kTexelsPerPixel = 3;
// Larger maps are represented by a piece of this side from their middle, as the filters' levels of the whole colour
// picture would take about a hundred bytes per texel.
constexpr int kLargestSide = 1024;

std::vector<double> elevations(const std::vector<Elevation>& views) {
    const auto kept = [](double degrees) { return std::clamp(degrees, kFlattestFilterView, kSteepestFilterView); };
    if (!views.front()) return {25, 60};
    const double low = kept(*views.front());
    const double high = kept(*views.back());
    if (high - low < 1) return {low};
    return {low, high};
}

// Returns the part of the picture that lies on the middle piece of a map of this size.
std::shared_ptr<const ColorImage> middlePicture(const ColorImage& color, int width, int height) {
    const auto part = [](int pixels, int texels) {
        return std::max(1, static_cast<int>(std::int64_t{pixels} * std::min(texels, kLargestSide) / texels));
    };
    auto picture = std::make_shared<ColorImage>(part(color.width(), width), part(color.height(), height));
    const int x0 = (color.width() - picture->width()) / 2, y0 = (color.height() - picture->height()) / 2;
    for (int y = 0; y < picture->height(); ++y) {
        for (int x = 0; x < picture->width(); ++x) (*picture)(x, y) = color(x0 + x, y0 + y);
    }
    return picture;
}

FilterScene sceneOf(const AdviceOptions& options) {
    HeightField field = options.field;
    auto color = options.color;
    if (std::max(field.width(), field.height()) > kLargestSide) {
        if (color) color = middlePicture(*color, field.width(), field.height());
        field = middlePiece(field, kLargestSide);
    }
    if (!color) color = patchPicture(field.heights(), options.seed);
    return {options.name, field, color};
}

// Measures the filters in a view and adds their rows. From a low elevation a small or narrow map may be a strip without
// a pixel that can be compared; then the camera moves nearer. Adds nothing if that is no help.
void addRows(FilterBenchOptions bench, double elevation, std::vector<FilterBenchRow>& rows, Work& work) {
    constexpr double kNearest = 0.125;  // share of the distance
    bench.elevations = {elevation};
    for (const double nearest = kNearest * bench.distance; bench.distance >= nearest; bench.distance /= 2) {
        const std::vector<FilterBenchRow> seen = benchFilters(bench, work);
        if (std::isnan(seen.front().rmse)) continue;
        rows.insert(rows.end(), seen.begin(), seen.end());
        return;
    }
}

}  // namespace

std::optional<FilterAdvice> recommendFilter(const AdviceOptions& options, double seconds, Work& work) {
    FilterBenchOptions bench;
    bench.scenes = {sceneOf(options)};
    bench.filters = advisedFilters();
    bench.pixelModels = {PixelModel::Gaussian};
    const int times = seconds >= kRichSeconds ? 2 : 1;
    bench.width = kWidth * times;
    bench.height = kHeight * times;
    bench.samples = kSamples;
    bench.rounds = 1;
    bench.distance = std::clamp(kTexelsPerPixel * bench.width / bench.scenes.front().color->width(), 0.3, 1.4);
    std::vector<FilterBenchRow> rows;
    for (const double elevation : elevations(options.views)) addRows(bench, elevation, rows, work);
    if (rows.empty()) return std::nullopt;

    FilterAdvice advice;
    for (const FilterChoice& choice : bench.filters) {
        FilterFigures figures{choice, 0, 0, std::numeric_limits<double>::infinity()};
        double count = 0;
        for (const FilterBenchRow& row : rows) {
            if (!(row.filter == choice)) continue;
            figures.rmse = std::max(figures.rmse, row.rmse);
            figures.texels += row.texelsRead;
            figures.rate = std::min(figures.rate, row.rate);
            ++count;
        }
        figures.texels /= count;
        advice.filters.push_back(figures);
    }
    const auto yardstick = std::find_if(advice.filters.begin(), advice.filters.end(), [](const FilterFigures& figures) {
        return figures.filter.name == filterDescriptionOf<TrilinearFilter>().name;
    });
    advice.live = advice.still = static_cast<std::size_t>(yardstick - advice.filters.begin());
    const double slowest = yardstick->rate / kLiveTimes;
    for (std::size_t f = 0; f < advice.filters.size(); ++f) {
        const FilterFigures& figures = advice.filters[f];
        if (figures.rmse < advice.filters[advice.still].rmse) advice.still = f;
        if (figures.rate >= slowest && figures.rmse < advice.filters[advice.live].rmse) advice.live = f;
    }
    advice.elevation = std::min_element(rows.begin(), rows.end(), [](const FilterBenchRow& a, const FilterBenchRow& b) {
                           return a.elevation < b.elevation;
                       })->elevation;
    advice.anisotropy = 1 / std::sin(advice.elevation * std::numbers::pi / 180);
    return advice;
}

}  // namespace relief
