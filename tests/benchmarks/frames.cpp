// relief_frames [SECONDS] [PICTURE [ELEVATION [FILTER]]] [--budget MS] [--no-shadows] [-o FILE.csv|json]
//  Measures frames per second of the shipped pictures at 800 x 600 while the camera rotates: traced exactly, filtered
//  anisotropically with regard to the relief, lit, with and without shadows. Each view is rendered for SECONDS (default
//  2) and gives one row: the median, the 10th and the 90th percentile of the frame times, and the median milliseconds
//  of each stage, summed over all threads. PICTURE: the beginning of a picture's folder name; restricts the run to it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "../memory_use.h"
#include "measuring/compare/picture_error.h"
#include "measuring/quantiles.h"
#include "peer_table.h"
#include "relief/files.h"
#include "relief/simd/packed_cone_hits.h"
#include "rendering/progressive.h"

namespace {

using namespace relief;

struct Pictures {
    const char* folder;
    const char* height;
    const char* color;
};
constexpr Pictures kPictures[]{{"gray_rocks", "height.png", "color.jpg"},
                               {"stone_wall_bricks102", "height.jpg", "color.jpg"},
                               {"brick_tiles037", "height.jpg", "color.jpg"},
                               {"terrain_srtm_east_africa", "height.png", "color.png"}};
constexpr double kTurn = 0.5;  // degrees per frame

std::string levelText(const MovingLevel& level) {
    return filterText(level.filter) + (level.factor > 1 ? " / " + std::to_string(level.factor) : "");
}

// Prints the error of the enlarged coarse picture of this view against the full one that follows it.
void printCoarse(ProgressiveRenderer& renderer, const FrameRequest& request, Work& work) {
    const ProgressiveRenderer::Picture coarse = renderer.moving(request, work);
    if (coarse.level.number == 0) return;
    const std::shared_ptr<const Frame> full = renderer.atRest(request, work).frame;
    ColorImage enlarged(request.width, request.height);
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            enlarged(x, y) = coarse.frame->light->color(x / coarse.level.factor, y / coarse.level.factor);
        }
    }
    FloatImage map;
    const PictureError error = pictureError(full->light->color, enlarged, kPixelsPerDegree, map, work);
    std::printf("  coarse, %s: RMSE %.4f, PSNR %.1f dB, FLIP %.4f; the full picture follows in %.1f ms\n",
                levelText(coarse.level).c_str(), error.rmse, error.psnr, error.flip, 1000 * full->seconds);
}

peers::PeerRow measure(FrameRequest request, const std::shared_ptr<MapCache>& maps, const char* name, double seconds,
                       double budget) {
    Work work;
    ProgressiveRenderer renderer(maps, budget);
    // Warm-up: until data that pay off only after some frames have been built.
    const double pixels = static_cast<double>(request.width) * request.height;
    const double enough = static_cast<double>(PackedConeHits::kRaysPerTexel * request.field.heights().size()) / pixels;
    for (int n = 0; n <= enough; ++n) {
        renderer.moving(request, work);
        request.camera.azimuth += kTurn;
    }
    std::map<int, std::pair<std::string, int>> levels;
    const double resident = test::residentMegabytes();
    std::vector<double> taken;
    std::array<std::vector<double>, kStages> stages;
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds) {
        request.camera.azimuth += kTurn;
        const ProgressiveRenderer::Picture picture = renderer.moving(request, work);
        const std::shared_ptr<const Frame>& frame = picture.frame;
        auto& [how, count] = levels[picture.level.number];
        how = levelText(picture.level);
        ++count;
        taken.push_back(frame->seconds);
        for (std::size_t s = 0; s < kStages; ++s) stages[s].push_back(frame->stages[s].seconds);
    }
    std::printf("%-26s %2.0f %-28s %-7s %6.1f frames/s %7.1f ms %7.1f to %.1f ms ", name, request.camera.elevation,
                filterText(request.filter).c_str(), request.shadows ? "shadows" : "", 1 / quantile(taken, 0.5),
                1000 * quantile(taken, 0.5), 1000 * quantile(taken, 0.1), 1000 * quantile(taken, 0.9));
    for (std::size_t s = 0; s < kStages; ++s) {
        std::printf(" %s %.1f", std::string(messageTemplate(kStageNames[s], Language::English)).c_str(),
                    1000 * quantile(stages[s], 0.5));
    }
    std::printf(" resident %.0f, %.0f MB\n", resident, test::residentMegabytes());
    if (std::isfinite(budget)) {
        for (const auto& [number, level] : levels) std::printf("  %d frames %s\n", level.second, level.first.c_str());
        request.camera.azimuth += kTurn;
        printCoarse(renderer, request, work);
    }
    std::fflush(stdout);
    peers::PeerRow row{name, "800x600", numberText(request.camera.elevation),
                       filterText(request.filter) + (request.shadows ? ", shadows" : ""), work.threads().size()};
    std::vector<double> rates;
    for (const double frame : taken) rates.push_back(1 / frame);
    peers::setRates(row, rates);
    return row;
}

struct Settings {
    double seconds = 2;
    std::string picture;
    std::vector<double> elevations{60, 45, 25};
    std::vector<std::string> filters{"elliptical", "elliptical-visible:form=grid"};
    double budget = std::numeric_limits<double>::infinity();  // seconds per frame
    bool lightAlone = false;
    std::string output;
};

int run(const Settings& settings) {
    std::vector<peers::PeerRow> rows;
    for (const Pictures& pictures : kPictures) {
        if (!std::string(pictures.folder).starts_with(settings.picture)) continue;
        const std::string folder = std::string(RELIEF_DATASETS) + "/" + pictures.folder + "/";
        Work work;
        const auto heights = std::make_shared<const FloatImage>(readHeight(folder + pictures.height, {}, work).heights);
        const auto color = std::make_shared<const ColorImage>(readColor(folder + pictures.color, work));
        const auto maps = std::make_shared<MapCache>();
        for (const double elevation : settings.elevations) {
            for (const std::string& filter : settings.filters) {
                for (const bool shadows : {false, true}) {
                    if (shadows && settings.lightAlone) continue;
                    FrameRequest request{HeightField(heights)};
                    request.color = color;
                    request.camera.elevation = elevation;
                    request.filter = parseFilter(filter, "filter");
                    request.shadows = shadows;
                    rows.push_back(measure(request, maps, pictures.folder, settings.seconds, settings.budget));
                }
            }
        }
    }
    if (rows.empty())
        throw InputError(
            settings.picture,
            Message(MessageId::UnknownName,
                    {{"what", "picture"},
                     {"name", settings.picture},
                     {"known", "gray_rocks, stone_wall_bricks102, brick_tiles037, terrain_srtm_east_africa"}}));
    if (!settings.output.empty()) peers::writePeerRows(settings.output, rows);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app("Frames a second of the shipped pictures, 800 x 600, while the camera turns");
    app.add_option("seconds", settings.seconds, "of each view")->check(CLI::PositiveNumber);
    app.add_option("picture", settings.picture, "the beginning of its folder's name; that one alone");
    app.add_option_function<double>(
           "elevation", [&](double degrees) { settings.elevations = {degrees}; }, "degrees, that one alone")
        ->check(CLI::Range(1.0, 90.0));
    app.add_option_function<std::string>(
        "filter", [&](const std::string& filter) { settings.filters = {filter}; }, "that one alone");
    app.add_option_function<double>(
           "--budget", [&](double ms) { settings.budget = ms / 1000; },
           "milliseconds a frame, coarse where they are less")
        ->check(CLI::PositiveNumber);
    app.add_flag("--no-shadows", settings.lightAlone, "light alone");
    app.add_option("-o", settings.output, "table to write, csv or json");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(settings);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
