#include "measuring/bench/bench_filters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measuring/bench/filter_queries.h"
#include "measuring/compare/flip.h"
#include "measuring/compare/picture_error.h"
#include "measuring/quantiles.h"
#include "measuring/random_rays.h"
#include "relief/reliefs.h"
#include "rendering/supersample.h"
#include "rendering/tile_worker.h"

namespace relief {

namespace {

constexpr int kPatch = 6;                  // texels
constexpr int kCheck = 8;                  // texels
constexpr double kFilterSceneDepth = 0.1;  // texture widths

// Returns the references of one view, one for each pixel model, from the same sample passes.
std::vector<ColorImage> references(const FrameRequest& request, const FilterBenchOptions& options,
                                   const std::shared_ptr<MapCache>& maps, Work& work) {
    std::vector<SampleSums> sums;
    for (const PixelModel model : options.pixelModels) {
        sums.emplace_back(request.width, request.height, model, kGaussianRing);
    }
    FrameRequest pass = request;
    pass.filter = {};
    pass.margin = kGaussianRing;
    pass.width += 2 * kGaussianRing;
    pass.height += 2 * kGaussianRing;
    FrameRenderer renderer(maps, true);
    for (const glm::ivec2& part : sampleOrder(options.samples)) {
        pass.sample = (glm::dvec2(part) + 0.5) / static_cast<double>(options.samples);
        const auto frame = renderer.render(pass, work);
        for (SampleSums& sum : sums) sum.add(frame->light->color, pass.sample, work);
        work.progress().advance();
    }
    std::vector<ColorImage> pictures;
    for (const SampleSums& sum : sums) pictures.push_back(sum.mean(work));
    return pictures;
}

// Returns the pixels all of whose neighbours within the pixel model's reach are hits.
std::vector<glm::ivec2> countedPixels(const Frame& frame) {
    const auto hit = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < frame.width && y < frame.height &&
               frame.hits->hits.outcome[frame.index(x, y)] == Outcome::Hit;
    };
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            bool all = true;
            for (int dy = -kGaussianRing - 1; dy <= kGaussianRing + 1 && all; ++dy) {
                for (int dx = -kGaussianRing - 1; dx <= kGaussianRing + 1 && all; ++dx) all = hit(x + dx, y + dy);
            }
            if (all) pixels.emplace_back(x, y);
        }
    }
    // Sorted by tiles, in the order in which a frame filters them.
    const auto tile = [](glm::ivec2 p) { return glm::ivec2(p.x / kTileWidth, p.y / kTileHeight); };
    std::stable_sort(pixels.begin(), pixels.end(), [&](glm::ivec2 p, glm::ivec2 q) {
        const glm::ivec2 a = tile(p), b = tile(q);
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    return pixels;
}

// Sets what is measured to NaN.
void clearValues(FilterBenchRow& row) {
    for (double* const value : {&row.rate, &row.spread, &row.rmse, &row.psnr, &row.flip, &row.texelsRead, &row.tested,
                                &row.hidden, &row.skipped}) {
        *value = std::numeric_limits<double>::quiet_NaN();
    }
}

struct Ready {
    const FilterChoice* choice;
    std::unique_ptr<const TextureFilter> filter;
};

class FilterBench {
  public:
    FilterBench(const FilterBenchOptions& options, Work& work) : options_(options), work_(work) {}

    std::vector<FilterBenchRow> run() {
        const auto cells = static_cast<std::int64_t>(options_.scenes.size() * options_.elevations.size());
        work_.progress().begin("bench", cells * unitsPerView());
        for (const FilterScene& scene : options_.scenes) {
            for (const double elevation : options_.elevations) measure(scene, elevation);
        }
        return std::move(rows_);
    }

  private:
    // Units of progress.
    std::int64_t unitsPerView() const {
        return std::int64_t{options_.samples} * options_.samples +
               static_cast<std::int64_t>(options_.filters.size()) * (options_.rounds + 1);
    }

    FrameRequest request(const FilterScene& scene, double elevation) const {
        FrameRequest request(scene.field);
        request.width = options_.width;
        request.height = options_.height;
        request.color = scene.color;
        request.camera.elevation = elevation;
        request.camera.azimuth = 25;
        request.camera.distance = options_.distance;
        request.light.ambient = 1;
        request.light.intensity = 1;
        return request;
    }

    void measure(const FilterScene& scene, double elevation) {
        const FrameRequest request = this->request(scene, elevation);
        const bool timed = options_.pass != BenchPass::Counts;
        FrameRenderer renderer(maps_, true);
        const auto frame = renderer.render(request, work_);
        const std::vector<glm::ivec2> pixels = countedPixels(*frame);
        if (pixels.empty()) {
            addEmptyRows(scene.name, elevation);
            return;
        }
        const std::vector<ColorImage> truth =
            options_.pass == BenchPass::Times ? std::vector<ColorImage>{} : references(request, options_, maps_, work_);
        const FilterQueries queries(*frame, request, pixels);
        const auto levels = std::make_shared<const ColorLevels>(scene.color, work_);
        std::vector<Ready> ready;
        for (const FilterChoice& choice : options_.filters) {
            ready.push_back({&choice, makeFilter(choice, {scene.color, levels, scene.field}, *maps_, work_)});
        }
        std::vector<FilterBenchRow> rows;
        for (const Ready& one : ready) {
            for (FilterBenchRow& row : counted(one, queries, pixels, truth)) {
                row.scene = scene.name;
                row.elevation = elevation;
                rows.push_back(std::move(row));
            }
        }
        std::vector<const TextureFilter*> filters;
        for (const Ready& one : ready) filters.push_back(one.filter.get());
        const auto rates = timed ? queries.rates(filters, options_.rounds, work_) : std::vector<std::vector<double>>();
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (timed) {
                const std::vector<double>& rate = rates[r / options_.pixelModels.size()];
                rows[r].rate = quantile(rate, 0.5);
                rows[r].spread = relativeSpread(rate);
            }
            add(std::move(rows[r]));
        }
    }

    // Adds the rows of a view in which no pixel can be compared.
    void addEmptyRows(const std::string& scene, double elevation) {
        for (const FilterChoice& choice : options_.filters) {
            for (const PixelModel model : options_.pixelModels) {
                FilterBenchRow row;
                row.filter = choice;
                row.pixelModel = model;
                row.scene = scene;
                row.elevation = elevation;
                row.threads = work_.threads().size();
                clearValues(row);
                add(std::move(row));
            }
        }
        work_.progress().advance(unitsPerView());
    }

    void add(FilterBenchRow row) {
        if (options_.onRow) options_.onRow(row);
        rows_.push_back(std::move(row));
    }

    // Measures everything except the rate, with a row for each pixel model; if truth is empty, only the data known
    // without filtering. Filters once in any case, which is the warm-up for the rate.
    std::vector<FilterBenchRow> counted(const Ready& ready, const FilterQueries& queries,
                                        const std::vector<glm::ivec2>& pixels, const std::vector<ColorImage>& truth) {
        std::vector<Color> colors;
        const FootprintCounts counts = queries.filter(*ready.filter, colors, work_);
        work_.progress().advance();
        const double each = 1 / std::max(1.0, static_cast<double>(queries.size()));
        std::vector<FilterBenchRow> rows;
        for (std::size_t m = 0; m < options_.pixelModels.size(); ++m) {
            FilterBenchRow row;
            row.filter = *ready.choice;
            row.pixelModel = options_.pixelModels[m];
            row.threads = work_.threads().size();
            if (truth.empty()) {
                rows.push_back(std::move(row));
                continue;
            }
            row.texelsRead = static_cast<double>(counts.texels) * each;
            row.tested = static_cast<double>(counts.tested) * each;
            row.hidden = static_cast<double>(counts.hidden) * each;
            row.skipped = static_cast<double>(counts.skipped) * each;
            // Pixels that are not compared are copied from the reference.
            ColorImage picture = truth[m];
            glm::dvec3 sum(0);
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                Color& at = picture(pixels[i].x, pixels[i].y);
                const glm::dvec3 difference = glm::dvec3(colors[i]) - glm::dvec3(at);
                sum += difference * difference;
                at = colors[i];
            }
            row.rmse = std::sqrt((sum.x + sum.y + sum.z) / 3 * each);
            row.psnr = -20 * std::log10(row.rmse);
            const FloatImage errors = flipErrors(truth[m], picture, kPixelsPerDegree, work_);
            for (const glm::ivec2& p : pixels) row.flip += static_cast<double>(errors(p.x, p.y)) * each;
            rows.push_back(std::move(row));
        }
        return rows;
    }

    const FilterBenchOptions& options_;
    Work& work_;
    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
    std::vector<FilterBenchRow> rows_;
};

Color patchColor(Random& random) {
    const auto channel = [&] { return static_cast<float>(random.between(0.05, 0.95)); };
    return {channel(), channel(), channel()};
}

}  // namespace

std::vector<std::string> filterSceneNames() {
    return {"checker", "bricks", "city", "hills"};
}

std::shared_ptr<const ColorImage> patchPicture(const FloatImage& heights, std::uint64_t seed) {
    auto picture = std::make_shared<ColorImage>(heights.width(), heights.height());
    const int across = (heights.width() + kPatch - 1) / kPatch;
    const int down = (heights.height() + kPatch - 1) / kPatch;
    Random random(seed);
    ColorImage patches(across, down);
    for (Color& patch : patches.pixels()) patch = patchColor(random);
    for (int y = 0; y < heights.height(); ++y) {
        for (int x = 0; x < heights.width(); ++x) {
            (*picture)(x, y) = patches(x / kPatch, y / kPatch) * (0.3F + 0.7F * heights(x, y));
        }
    }
    return picture;
}

FilterScene filterScene(const std::string& name, int size, std::uint64_t seed) {
    if (name == "checker") {
        auto picture = std::make_shared<ColorImage>(size, size);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) (*picture)(x, y) = Color((x / kCheck + y / kCheck) % 2 == 0 ? 0.9F : 0.05F);
        }
        return {name, HeightField(std::make_shared<const FloatImage>(size, size, 1.0F)), picture};
    }
    auto heights = std::make_shared<const FloatImage>(makeRelief(name, size, size, seed));
    return {name, HeightField(heights, Surface::Bilinear, Address::Repeat, kFilterSceneDepth),
            patchPicture(*heights, seed)};
}

std::vector<FilterBenchRow> benchFilters(const FilterBenchOptions& options, Work& work) {
    return FilterBench(options, work).run();
}

}  // namespace relief
