// Compares the library's filters with the supersampled picture, on small pictures of the user's own map.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "filtering/filters/measured_filters.h"
#include "filtering/methods/trilinear.h"
#include "measuring/advise/recommend.h"
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

std::vector<double> elevations(const std::vector<Elevation>& views) {
    const auto kept = [](double degrees) { return std::clamp(degrees, kFlattestFilterView, kSteepestFilterView); };
    if (!views.front()) return {25, 60};
    const double low = kept(*views.front());
    const double high = kept(*views.back());
    if (high - low < 1) return {low};
    return {low, high};
}

}  // namespace

FilterAdvice recommendFilter(const AdviceOptions& options, double seconds, Work& work) {
    FilterBenchOptions bench;
    const auto color = options.color ? options.color : patchPicture(options.field.heights(), options.seed);
    bench.scenes = {{options.name, options.field, color}};
    bench.filters = advisedFilters();
    bench.pixelModels = {PixelModel::Gaussian};
    bench.elevations = elevations(options.views);
    const int times = seconds >= kRichSeconds ? 2 : 1;
    bench.width = kWidth * times;
    bench.height = kHeight * times;
    bench.samples = kSamples;
    bench.rounds = 1;
    bench.distance = std::clamp(kTexelsPerPixel * bench.width / color->width(), 0.3, 1.4);
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
