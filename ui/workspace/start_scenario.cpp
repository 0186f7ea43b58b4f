#include "workspace/start_scenario.h"

#include <array>
#include <filesystem>

namespace reliefui {

namespace fs = std::filesystem;

namespace {

constexpr const char* kWall = "stone_wall_bricks102";
// The ray of this pixel skips on five levels and descends once in vain: at level 4, texel (21, 15), from which it
// ascends again at step 7, the chosen one. The window's tests check this.
constexpr relief::PixelChoice kWallPixel{340, 320};
constexpr int kWallStep = 7;
constexpr relief::PixelChoice kBricksPixel{400, 300};

std::string firstOf(const fs::path& folder, const std::string& stem) {
    for (const char* const ending : {".png", ".jpg", ".exr", ".tif"}) {
        const fs::path file = folder / (stem + ending);
        std::error_code error;
        if (fs::is_regular_file(file, error)) return file.string();
    }
    return {};
}

// A folder of the window's files: next to that of the shipped pictures if installed, or in the source tree; empty if
// not found.
std::string besidePictures(const std::string& datasets, const char* name) {
    const fs::path above = fs::path(datasets).parent_path();
    for (const fs::path& place : {above / name, above / "ui" / name}) {
        std::error_code error;
        if (!datasets.empty() && fs::is_directory(place, error)) return place.string();
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

std::string lessonsFolder(const std::string& datasets) {
    return besidePictures(datasets, "lessons");
}

std::string paperFiguresFolder(const std::string& datasets) {
    return besidePictures(datasets, "paper_figures");
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
    scenario.camera.elevation = 20;
    scenario.camera.azimuth = -44;
    scenario.camera.distance = 0.78;
    scenario.camera.target = {-0.1, 0.02, 0};
    scenario.reliefDepth = 0.12;
    scenario.light.azimuth = -70;
    scenario.light.elevation = 36;
    scenario.light.intensity = 1.6;
    if (!datasets.empty()) scenario.pictures = picturesIn((fs::path(datasets) / kWall).string());
    // The light must shade the relief that the rays meet, not the finer one of the normal map.
    scenario.pictures.normal.clear();
    // Two methods whose errors are visible at once.
    scenario.comparison.others = {{"layers", {}}, {"offset", {}}};
    scenario.pixel = kWallPixel;
    scenario.step = kWallStep;
    if (scenario.pictures.height.empty()) {
        scenario.pictures = {};
        scenario.pictures.recipe = "bricks";
        scenario.pixel = kBricksPixel;
    }
    return scenario;
}

}  // namespace reliefui
