// relief make RELIEF[:SIZE[:SEED]] -o FILE [--size SIZE] [--seed S] [--tiled [--resume | --anew]]
#include <algorithm>

#include "images/recipe_rows.h"
#include "options_common.h"
#include "output.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "tiles_output.h"

namespace relief::app {

namespace {

struct MakeOptions {
    OptionText relief, output, size, seed;
    bool tiled = false;
    RestartOptions restart;
    RunOptions run;
};

// "bricks:512:7" is the same as `bricks --size 512 --seed 7`.
Pictures chosenRelief(const MakeOptions& options) {
    const std::string& relief = needed(options.relief, "RELIEF", "make");
    const std::size_t parts = splitText(relief, ':').size();
    if (options.size && parts > 1)
        throw InputError("--size", Message(MessageId::ArgumentsExclude, {{"other", relief}}));
    if (options.seed && parts > 2)
        throw InputError("--seed", Message(MessageId::ArgumentsExclude, {{"other", relief}}));
    Pictures pictures;
    pictures.reading.maxPixels = std::int64_t{kMaxRecipeSide} * kMaxRecipeSide;
    applyRecipe(pictures, relief, {}, kMaxRecipeSide);
    if (options.seed) pictures.seed = parseSeed(*options.seed, "--seed");
    if (options.size) {
        const SizeText size = parseSize(*options.size, "--size", kMaxRecipeSide);
        pictures.recipeWidth = size.width;
        pictures.recipeHeight = size.height;
    }
    return pictures;
}

// Whether such a relief is too large for commands that read height maps as a whole.
bool exceedsMemory(const Pictures& relief) {
    return relief.drawn.empty() && (std::max(relief.recipeWidth, relief.recipeHeight) > kMaxReliefSide ||
                                    std::int64_t{relief.recipeWidth} * relief.recipeHeight > kDefaultMaxPixels);
}

int runMake(const MakeOptions& options, Session& session) {
    options.run.apply(session);
    const Pictures pictures = chosenRelief(options);
    const std::string& output = needed(options.output, "--output", "make");
    const bool tiled = options.tiled || exceedsMemory(pictures);
    checkOutput(output, tiled ? kTiledEndings : std::vector<std::string>{"png", "tif", "tiff", "exr"});
    if (tiled && pictures.drawn.empty()) {
        const auto rows = reliefHeightRows(pictures.recipe, pictures.recipeWidth, pictures.recipeHeight, pictures.seed);
        writeTiles(*rows, output, options.restart, session);
        return kDone;
    }
    if (options.tiled) throw InputError("--tiled", Message(MessageId::ArgumentsExclude, {{"other", *options.relief}}));
    if (options.restart.given()) {
        throw InputError("--resume, --anew", Message(MessageId::NeedsArgument, {{"other", "--tiled"}}));
    }
    AssetStore store;
    const Assets assets = store.load(pictures, session.work());
    session.eraseBar();
    writeHeight(output, *assets.heights, fileEnding(output) == "exr");
    return kDone;
}

}  // namespace

void addMakeCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<MakeOptions>();
    std::string names;
    for (const ReliefRecipe& recipe : reliefRecipes()) names.append(names.empty() ? "" : ", ").append(recipe.name);
    CLI::App* parser =
        addCommand(program, "make", "make a procedural height map",
                   "Writes a procedural height map. The same seed gives the same bits on every machine. "
                   ".png and .tif hold 16-bit integers, .exr 32-bit floats. A map of more than " +
                       std::to_string(kDefaultMaxPixels) + " texels, or longer than " + std::to_string(kMaxReliefSide) +
                       " on a side, is made row by row, in little memory, and written as the tiled TIFF "
                       "of relief tile, which other commands read with --memory. The reliefs: " +
                       names + "; relief list reliefs describes them.",
                   "  relief make bricks --size 512 --seed 7 -o bricks.png\n"
                   "  relief make bricks:512x256:7 -o bricks.png\n"
                   "  relief make fractal --size 65536 -o terrain.tif");
    addArgument(*parser, "RELIEF", options->relief, "name of the relief; size and seed may follow, as in bricks:512:7");
    addOutput(*parser, options->output, "the height map: .png, .tif or .exr");
    addText(*parser, "--size", options->size, "WxH|N",
            "size in texels, 1 to " + std::to_string(kMaxRecipeSide) +
                " per side; N: N x N; default: that of the relief, mostly 256",
            "Relief");
    addText(*parser, "--seed", options->seed, "S", "seed of the random numbers, a whole number from 0; default 1",
            "Relief");
    addFlag(*parser, "--tiled", options->tiled,
            "write a tiled TIFF with its pyramid, as relief tile does, whatever the size; heights are 16-bit integers "
            "(paper8x8: floats)",
            "Output");
    options->restart.add(*parser, "a tiled map that takes long", "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runMake(*options, session); }});
}

}  // namespace relief::app
