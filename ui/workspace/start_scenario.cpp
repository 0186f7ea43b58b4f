#include "workspace/start_scenario.h"

#include <array>
#include <filesystem>

namespace reliefui {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWall = "stone_wall_bricks102";
// A ray that goes down several levels and comes up again before it hits: see the test of the start.
constexpr relief::PixelChoice kWallPixel{412, 305};
constexpr relief::PixelChoice kBricksPixel{400, 300};

std::string firstOf(const fs::path& folder, const std::string& stem) {
    for (const char* const ending : {".png", ".jpg", ".exr", ".tif"}) {
        const fs::path file = folder / (stem + ending);
        std::error_code error;
        if (fs::is_regular_file(file, error)) return file.string();
    }
    return {};
}

}  // namespace

std::string datasetsFolder(const std::string& programFolder) {
    const fs::path program(programFolder);
    const std::array<fs::path, 4> places{program / "datasets", program / "../share/reliefscope/datasets",
                                         program / "../../datasets", fs::path(RELIEF_DATASETS)};
    for (const fs::path& place : places) {
        std::error_code error;
        if (!fs::is_directory(place / kWall, error)) continue;
        const fs::path clean = fs::weakly_canonical(place, error);
        return error ? place.string() : clean.string();
    }
    return {};
}

relief::Pictures picturesIn(const std::string& folder) {
    relief::Pictures pictures;
    pictures.height = firstOf(folder, "height");
    pictures.color = firstOf(folder, "color");
    pictures.normal = firstOf(folder, "normal_gl");
    return pictures;
}

relief::Scenario startScenario(const std::string& datasets) {
    relief::Scenario scenario;
    scenario.scene = relief::SceneKind::Wall;
    scenario.camera.elevation = 12;
    scenario.camera.azimuth = -48;
    scenario.camera.distance = 1.15;
    scenario.reliefDepth = 0.08;
    if (!datasets.empty()) scenario.pictures = picturesIn((fs::path(datasets) / kWall).string());
    scenario.pixel = kWallPixel;
    if (scenario.pictures.height.empty()) {
        scenario.pictures = {};
        scenario.pictures.recipe = "bricks";
        scenario.pixel = kBricksPixel;
    }
    return scenario;
}

}  // namespace reliefui
