// relief_frames [SECONDS] [-o FILE.csv|json]: frames a second of the shipped pictures at 800 x 600 while the camera
// turns: traced exactly, filtered anisotropically with regard to the relief, lit, with shadows and without. Each view
// for SECONDS (default 2); a row a view: the median frame and the tenth slowest, and each stage's share, of all threads
// together.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "images/files.h"
#include "measuring/quantiles.h"
#include "peer_table.h"
#include "relief/lanes/cone_twin.h"
#include "rendering/frame.h"

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
constexpr double kTurn = 0.5;  // degrees a frame

peers::PeerRow measure(FrameRequest request, const std::shared_ptr<MapCache>& maps, const char* name, double seconds) {
    Work work;
    FrameRenderer renderer(maps);
    // Until what pays only after some frames has been made.
    const double pixels = static_cast<double>(request.width) * request.height;
    const double enough = static_cast<double>(ConeTwin::kRaysPerTexel * request.field.heights().size()) / pixels;
    for (int n = 0; n <= enough; ++n) {
        renderer.render(request, work);
        request.camera.azimuth += kTurn;
    }
    std::vector<double> taken;
    std::array<double, kStages> stages{};
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds) {
        request.camera.azimuth += kTurn;
        const auto frame = renderer.render(request, work);
        taken.push_back(frame->seconds);
        for (std::size_t s = 0; s < kStages; ++s) stages[s] += frame->stages[s].seconds;
    }
    double sum = 0;
    for (const double s : stages) sum += s;
    std::printf("%-26s %2.0f %-28s %-7s %6.1f frames/s %7.1f ms %7.1f ms ", name, request.camera.elevation,
                filterText(request.filter).c_str(), request.shadows ? "shadows" : "", 1 / quantile(taken, 0.5),
                1000 * quantile(taken, 0.5), 1000 * quantile(taken, 0.9));
    for (std::size_t s = 0; s < kStages; ++s) {
        std::printf(" %s %.0f%%", std::string(kStageNames[s]).c_str(), 100 * stages[s] / sum);
    }
    std::printf("\n");
    std::fflush(stdout);
    peers::PeerRow row{name, "800x600", numberText(request.camera.elevation),
                       filterText(request.filter) + (request.shadows ? ", shadows" : ""),
                       work.arena().max_concurrency()};
    std::vector<double> rates;
    for (const double frame : taken) rates.push_back(1 / frame);
    peers::setRates(row, rates);
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 && argv[1][0] != '-' ? std::atof(argv[1]) : 2;
    const std::string output = argc > 2 && std::string(argv[argc - 2]) == "-o" ? argv[argc - 1] : "";
    std::vector<peers::PeerRow> rows;
    for (const Pictures& pictures : kPictures) {
        const std::string folder = std::string(RELIEF_DATASETS) + "/" + pictures.folder + "/";
        Work work;
        const auto heights = std::make_shared<const FloatImage>(readHeight(folder + pictures.height, {}, work).heights);
        const auto color = std::make_shared<const ColorImage>(readColor(folder + pictures.color, work));
        const auto maps = std::make_shared<MapCache>();
        for (const double elevation : {60.0, 45.0, 25.0}) {
            for (const char* filter : {"elliptical", "elliptical-visible:form=grid"}) {
                for (const bool shadows : {false, true}) {
                    FrameRequest request{HeightField(heights)};
                    request.color = color;
                    request.camera.elevation = elevation;
                    request.filter = parseFilter(filter, "filter");
                    request.shadows = shadows;
                    rows.push_back(measure(request, maps, pictures.folder, seconds));
                }
            }
        }
    }
    if (!output.empty()) peers::writePeerRows(output, rows);
    return 0;
}
