#include "relief/reliefs.h"
#include "scenario/scenario.h"

namespace relief {

namespace {

bool sameHeights(const Pictures& a, const Pictures& b) {
    return a.height == b.height && a.recipe == b.recipe && a.drawn == b.drawn && a.reading == b.reading &&
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

}  // namespace

Assets AssetStore::load(const Pictures& pictures, Work& work) {
    Assets assets = assets_;
    if (!assets.height || !sameHeights(pictures, last_)) {
        assets.height = loadHeights(pictures, work);
        // This pointer shares ownership with assets.height.
        assets.heights = std::shared_ptr<const FloatImage>(assets.height, &assets.height->heights);
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
