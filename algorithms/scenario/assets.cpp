#include <algorithm>

#include "images/tiled_heights.h"
#include "relief/reliefs.h"
#include "scenario/scenario.h"

namespace relief {

namespace {

bool sameHeights(const Pictures& a, const Pictures& b) {
    return a.height == b.height && a.recipe == b.recipe && a.drawn == b.drawn && a.reading == b.reading &&
           a.memory == b.memory &&
           (a.recipe.empty() ||
            (a.recipeWidth == b.recipeWidth && a.recipeHeight == b.recipeHeight && a.seed == b.seed));
}

std::shared_ptr<const HeightImage> loadHeights(const Pictures& pictures, Work& work) {
    if (!pictures.height.empty()) {
        return std::make_shared<HeightImage>(readHeight(pictures.height, pictures.reading, work));
    }
    const bool drawn = !pictures.drawn.empty();
    if (pictures.recipe.empty() && !drawn) throw InputError("--height", Message(MessageId::NoHeights));
    auto made = std::make_shared<HeightImage>();
    made->heights =
        drawn ? drawnHeights(pictures.drawn)
              : makeRelief(pictures.recipe, pictures.recipeWidth, pictures.recipeHeight, pictures.seed, &work);
    made->info.path = drawn ? std::string(kDrawn) : pictures.recipe;
    made->info.format = "procedural";
    made->info.width = made->heights.width();
    made->info.height = made->heights.height();
    made->info.type = "float";
    if (pictures.reading.invert) {
        for (float& h : made->heights.pixels()) h = 1 - h;
    }
    return made;
}

// Most that filters take for the grey picture that stands for a colour picture, with its levels and bounds of heights
// (greyPicture(), HeightBoundsMap), bytes; measured with elliptical-visible.
constexpr std::size_t kGreyBytes = std::size_t{75} << 20;

// Opens the height map by tiles. Three quarters of the memory hold tiles, the rest the upper levels of the pyramid
// (TiledPyramid::mostBytes()), besides what filters may need; of less than 300 MB that gets a quarter, which it may
// exceed.
void openTiles(const Pictures& pictures, Assets& assets) {
    std::size_t bytes = static_cast<std::size_t>(pictures.memory) << 20;
    if (pictures.color.empty()) bytes -= std::min(kGreyBytes, bytes / 4);
    assets.tiles = TiledHeights::open(pictures.height, bytes / 4 * 3);
    auto height = std::make_shared<HeightImage>();
    height->info.path = pictures.height;
    height->info.format = "tiff";
    height->info.width = assets.tiles->width();
    height->info.height = assets.tiles->height();
    assets.height = height;
    assets.heights.reset();
}

// Throws InputError: what is tiled has been scaled when it was tiled.
void refuseReading(const HeightReadOptions& reading) {
    const HeightReadOptions usual;
    const char* option = nullptr;
    if (reading.channel != usual.channel) option = "--channel";
    if (reading.invert) option = "--invert";
    if (!(reading.range == usual.range)) option = "--range";
    if (option != nullptr) throw InputError(option, Message(MessageId::ArgumentsExclude, {{"other", "--memory"}}));
}

}  // namespace

HeightField Assets::field(const Scenario& scenario) const {
    if (tiles) return {tiles, scenario.surface, scenario.address, scenario.reliefDepth};
    return {heights, scenario.surface, scenario.address, scenario.reliefDepth};
}

Assets AssetStore::load(const Pictures& pictures, Work& work, bool byTiles) {
    Assets assets = assets_;
    const bool tiled = byTiles && pictures.memory > 0 && !pictures.height.empty();
    const bool loaded = assets.heights || (tiled && assets.tiles);
    if (!loaded || !sameHeights(pictures, last_)) {
        if (tiled && TiledHeights::isTiled(pictures.height)) {
            refuseReading(pictures.reading);
            openTiles(pictures, assets);
        } else {
            assets.tiles.reset();
            assets.height = loadHeights(pictures, work);
            // This pointer shares ownership with assets.height.
            assets.heights = std::shared_ptr<const FloatImage>(assets.height, &assets.height->heights);
        }
    }
    const std::int64_t cap = pictures.reading.maxPixels;
    if (pictures.color.empty()) {
        assets.color.reset();
    } else if (!assets.color || pictures.color != last_.color) {
        assets.color = std::make_shared<ColorImage>(readColor(pictures.color, work, cap));
    }
    if (pictures.normal.empty()) {
        assets.normals.reset();
    } else if (!assets.normals || pictures.normal != last_.normal) {
        assets.normals = std::make_shared<Image<glm::vec3>>(readNormals(pictures.normal, work, cap));
    }
    last_ = pictures;
    assets_ = assets;
    return assets;
}

}  // namespace relief
