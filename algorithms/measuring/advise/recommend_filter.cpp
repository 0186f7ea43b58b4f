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

}  // namespace

FilterAdvice recommendFilter(const AdviceOptions& options, double seconds, Work& work) {
    FilterBenchOptions bench;
    bench.scenes = {sceneOf(options)};
    bench.filters = advisedFilters();
    bench.pixelModels = {PixelModel::Gaussian};
    bench.elevations = elevations(options.views);
    const int times = seconds >= kRichSeconds ? 2 : 1;
    bench.width = kWidth * times;
    bench.height = kHeight * times;
    bench.samples = kSamples;
    bench.rounds = 1;
    bench.distance = std::clamp(kTexelsPerPixel * bench.width / bench.scenes.front().color->width(), 0.3, 1.4);
    const std::vector<FilterBenchRow> rows = benchFilters(bench, work);

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
    advice.elevation = *std::min_element(bench.elevations.begin(), bench.elevations.end());
    advice.anisotropy = 1 / std::sin(advice.elevation * std::numbers::pi / 180);
    return advice;
}

}  // namespace relief
